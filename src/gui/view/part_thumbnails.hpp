// Small pictures of parts, made one after the other while nothing else is to be done.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/job.hpp"
#include "gl/colour_target.hpp"
#include "gl/context.hpp"
#include "gui/jobs/loaded_part.hpp"
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

}  // namespace moldlight::gui
