// What a picture is drawn with: the pictures between its passes, the programs, the part's mesh.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "gl/pass.hpp"
#include "gl/program.hpp"
#include "render/view_mesh.hpp"

namespace moldlight {

/// The pictures between the passes, all of the size of the final one.
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

/// The programs of a picture, each variant compiled when it is first needed.
class ViewPrograms {
 public:
  explicit ViewPrograms(const gl::Functions& gl) : gl_(&gl) {}

  /// The program of these files below shaders/ with each of `defines` defined, in use from now on; empty
  /// defines are left out. Throws Error where it does not compile.
  const gl::Program& use(std::string_view vertex, std::string_view fragment,
                         const std::vector<std::string_view>& defines = {});

 private:
  const gl::Functions* gl_;
  std::map<std::string, gl::Program, std::less<>> programs_;
};

/// Valid for one context.
struct ViewTools {
  ViewTools(const gl::Functions& functions, const ViewGeometry& geometry)
      : gl(functions), programs(functions), corners(functions), mesh(functions, geometry) {}

  const gl::Functions& gl;
  ViewPrograms programs;
  gl::NumberedCorners corners;
  ViewMesh mesh;
  ViewTargets targets;
};

}  // namespace moldlight
