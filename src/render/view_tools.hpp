// Tools that draw a picture: the pictures between its passes, the part's mesh.
#pragma once

#include <glm/vec2.hpp>

#include "gl/pass.hpp"
#include "render/view_mesh.hpp"

namespace moldlight {

/// Where a picture goes: the lower left `size` pixels of a framebuffer (0: the window's own) with one RGBA8
/// colour that keeps sRGB values as they are written.
struct ViewTarget {
  GLuint framebuffer = 0;
  glm::ivec2 size{0};
};

/// The pictures between the passes, all of the size of the final one.
struct ViewTargets {
  ViewTargets() = default;
  ViewTargets(const gl::Functions& gl, const glm::ivec2& size);
  /// Each makes what pictures at rest, sections, or tubes alone need, unless it is there already.
  void make_sum(const gl::Functions& gl) { make(gl, GL_RGBA32F, sum, to_sum); }
  void make_winding(const gl::Functions& gl) { make(gl, GL_R16F, winding, to_winding); }
  void make_tube(const gl::Functions& gl) { make(gl, GL_RGBA8, tube, to_tube); }
  /// And of a studio; square, of a size of its own.
  void make_footprint(const gl::Functions& gl, int side);
  /// Copies what the first sample shows of the surface.
  void keep_first(const gl::Functions& gl);

  glm::ivec2 size{0};
  gl::Texture surface;                                   // RG32UI, see shaders/view/surface_bits.glsl
  gl::Texture depth;                                     // 32-bit float
  gl::Texture accessible;                                // R8UI, accessibility bits
  gl::Texture openness;                                  // R8, 1: sees the whole sky
  gl::Texture colour;                                    // RGBA8, one sample in sRGB
  gl::Texture winding;                                   // R16F, see shaders/view/winding.frag
  gl::Texture tube;                                      // RGBA8, see shaders/view/tube.frag
  gl::Texture sum;                                       // RGBA32F, squares of samples
  gl::Framebuffer to_surface, to_accessible, to_colour;  // with depth
  gl::Framebuffer to_shaded;                             // colour, accessibility bits; with depth
  gl::Texture footprint;                                 // R8, see shaders/view/footprint.frag
  gl::Framebuffer to_openness, to_winding, to_tube, to_sum, to_footprint;

  /// Surface and accessibility bits of the first sample, whose lines of sight go through the pixels' middles.
  gl::Texture first_surface, first_depth, first_accessible;
  gl::Framebuffer to_first_surface, to_first_accessible;  // surface with depth

 private:
  void make(const gl::Functions& gl, GLenum format, gl::Texture& texture, gl::Framebuffer& framebuffer) const;
};

/// Valid for one context.
struct ViewTools : gl::Tools {
  ViewTools(const gl::Functions& functions, const ViewGeometry& geometry)
      : gl::Tools(functions), mesh(functions, geometry) {}

  ViewMesh mesh;
  ViewTargets targets;
};

}  // namespace moldlight
