// Pictures that one program makes of a whole framebuffer.
#pragma once

#include <glm/vec2.hpp>

#include "gl/program.hpp"
#include "render/shadow_maps.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

/// Draws over the lower left `size` pixels of a framebuffer, which is bound afterwards. Needs its context
/// current.
class ScreenPass {
 protected:
  ScreenPass(const gl::Functions& gl, const gl::ProgramSources& sources);
  /// The program, in use and ready to draw there.
  [[nodiscard]] const gl::Program& begin(GLuint framebuffer, const glm::ivec2& size) const;
  void finish() const;

 private:
  const gl::Functions* gl_;
  gl::Program program_;
  gl::NumberedCorners corners_;
};

/// The backdrop alone, as it lies behind a part: for a window without one.
class BackdropPass : ScreenPass {
 public:
  explicit BackdropPass(const gl::Functions& gl);
  void draw(GLuint framebuffer, const glm::ivec2& size, Theme theme) const;
};

/// A shadow map as a picture: near facets light, far ones dark, alpha 0 where there is none; for thumbnails.
class MapPicture : ScreenPass {
 public:
  explicit MapPicture(const gl::Functions& gl);
  void draw(GLuint framebuffer, const glm::ivec2& size, const ShadowMaps& maps, bool plus) const;
};

}  // namespace moldlight
