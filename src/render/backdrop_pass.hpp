// The backdrop alone, as it lies behind a part: for a window without one.
#pragma once

#include <glm/vec2.hpp>

#include "gl/program.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

/// Needs its context current.
class BackdropPass {
 public:
  explicit BackdropPass(const gl::Functions& gl);

  /// Draws over the lower left `size` pixels of a framebuffer, which is bound afterwards.
  void draw(GLuint framebuffer, const glm::ivec2& size, Theme theme) const;

 private:
  const gl::Functions* gl_;
  gl::Program program_;
  gl::VertexArray fullscreen_;
};

}  // namespace moldlight
