// A picture that is drawn without a window.
#pragma once

#include <glm/vec2.hpp>

#include "base/image.hpp"
#include "gl/objects.hpp"
#include "render/part_view.hpp"

namespace moldlight {

/// Needs its context current.
class OffscreenPicture {
 public:
  /// Throws Error for a size that the driver has no room for.
  OffscreenPicture(const gl::Functions& gl, const glm::ivec2& size);

  [[nodiscard]] ViewTarget target() const { return {framebuffer_.name(), size_}; }
  /// What was drawn. Waits for the GL.
  [[nodiscard]] Image read() const;

 private:
  const gl::Functions* gl_;
  glm::ivec2 size_;
  gl::Texture colour_;
  gl::Framebuffer framebuffer_;
};

}  // namespace moldlight
