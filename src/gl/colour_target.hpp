// A framebuffer with one RGBA8 colour: what windows are without a window.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "gl/objects.hpp"

namespace moldlight::gl {

/// Needs its context current at every call. What is drawn is kept as it is written, without sRGB conversion.
class ColourTarget {
 public:
  ColourTarget(const Functions& gl, const glm::ivec2& size);

  [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }
  [[nodiscard]] GLuint texture() const { return texture_.name(); }
  [[nodiscard]] const glm::ivec2& size() const { return size_; }
  /// Four bytes a pixel, rows from above. Waits for the GL.
  [[nodiscard]] std::vector<std::uint8_t> read() const;

 private:
  const Functions* gl_;
  glm::ivec2 size_;
  Texture texture_;
  Framebuffer framebuffer_;
};

/// Four bytes a pixel of a framebuffer's first colour, rows from above. Waits for the GL.
[[nodiscard]] std::vector<std::uint8_t> read_colours(const Functions& gl, GLuint framebuffer,
                                                     const glm::ivec2& size);

}  // namespace moldlight::gl
