// The pictures between the passes, all of the size of the final one.
#pragma once

#include <glm/vec2.hpp>

#include "gl/objects.hpp"

namespace moldlight {

struct ViewTargets {
  ViewTargets() = default;
  ViewTargets(const gl::Functions& gl, const glm::ivec2& size);
  /// Makes what pictures at rest alone need, unless it is there already.
  void make_sum(const gl::Functions& gl);

  glm::ivec2 size{0};
  gl::Texture surface;                                   // RG32UI, see shaders/view/surface_bits.glsl
  gl::Texture depth;                                     // 32-bit float
  gl::Texture accessible;                                // R8UI, accessibility bits
  gl::Texture openness;                                  // R8, 1: sees the whole sky
  gl::Texture colour;                                    // RGBA8, one sample in sRGB
  gl::Texture sum;                                       // RGBA32F, squares of samples
  gl::Framebuffer to_surface, to_accessible, to_colour;  // with depth
  gl::Framebuffer to_shaded;                             // colour, accessibility bits; with depth
  gl::Framebuffer to_depth, to_openness, to_sum;
};

}  // namespace moldlight
