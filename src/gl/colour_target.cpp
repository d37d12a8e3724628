#include "gl/colour_target.hpp"

#include <algorithm>

namespace moldlight::gl {

ColourTarget::ColourTarget(const Functions& gl, const glm::ivec2& size)
    : gl_(&gl),
      size_(size),
      texture_(make_texture_2d(gl, GL_RGBA8, size.x, size.y)),
      framebuffer_(make_framebuffer(gl, texture_)) {}

std::vector<std::uint8_t> ColourTarget::read() const { return read_colours(*gl_, framebuffer(), size_); }

std::vector<std::uint8_t> read_colours(const Functions& gl, GLuint framebuffer, const glm::ivec2& size) {
  const auto row = static_cast<std::size_t>(size.x) * 4, rows = static_cast<std::size_t>(size.y);
  std::vector<std::uint8_t> below(row * rows), above(row * rows);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  if (framebuffer != 0) gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, below.data());
  for (std::size_t k = 0; k < rows; ++k) {
    std::copy_n(below.begin() + static_cast<std::ptrdiff_t>((rows - 1 - k) * row), row,
                above.begin() + static_cast<std::ptrdiff_t>(k * row));
  }
  return above;
}

}  // namespace moldlight::gl
