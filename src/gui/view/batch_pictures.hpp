// The small pictures of a batch's parts as textures, read as they come into sight.
#pragma once

#include <string>
#include <unordered_map>

#include "gl/context.hpp"
#include "gl/objects.hpp"
#include "io/digest.hpp"

namespace moldlight::gui {

/// Needs its context current at every call.
class BatchPictures {
 public:
  BatchPictures(const gl::Context& context, std::string batch_folder);

  /// A few pictures are read in a frame; call it at the frame's beginning.
  void begin_frame() { read_ = 0; }
  /// 0 while it is not there yet, and for a picture that cannot be read.
  [[nodiscard]] unsigned texture(const Digest& key);
  /// True if one was asked for in this frame that another frame is to read.
  [[nodiscard]] bool unfinished() const { return read_ > k_a_frame; }

 private:
  static constexpr int k_a_frame = 6;

  const gl::Context* context_;
  std::string folder_;
  std::unordered_map<Digest, gl::Texture, DigestHash> textures_;
  int read_ = 0;  // asked for in this frame
};

}  // namespace moldlight::gui
