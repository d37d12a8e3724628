// Small pictures of parts as textures: those of the start page, made one after the other while nothing else
// is to be done, and those of a batch, read as they come into sight.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/job.hpp"
#include "gl/context.hpp"
#include "gl/objects.hpp"
#include "gui/jobs/loaded_part.hpp"
#include "io/digest.hpp"
#include "render/view_settings.hpp"

namespace moldlight::gui {

/// Needs its context current at every call.
class PartThumbnails {
 public:
  PartThumbnails(const gl::Context& context, std::vector<std::string> parts, std::function<void()> wake);

  /// Goes on with the work; call it every frame in which the pictures are to be seen.
  void update(int size_px, Theme theme);
  /// One texture a part, in their order; 0 where there is none yet.
  [[nodiscard]] std::vector<unsigned> textures() const;
  [[nodiscard]] bool finished() const { return next_ >= parts_.size(); }

 private:
  const gl::Context* context_;
  std::vector<std::string> parts_;
  std::vector<std::optional<gl::ColourTarget>> pictures_;
  Job<LoadedPart> job_;
  std::size_t next_ = 0;  // the part that is loaded next or now
  int size_px_ = 0;
  Theme theme_ = Theme::dark;
};

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
