// What the passes of a picture share: what each is told of the sample, the pictures between them, the
// programs.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gl/program.hpp"
#include "render/camera.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

/// One sample of a picture.
struct ViewFrame {
  ViewFrame(const Camera& camera, const glm::ivec2& size, const ViewSettings& settings,
            const glm::dvec3& direction, int sample);

  /// Each sets the uniforms of the shader file of that name (or of the eye's axes).
  void set_sight(const gl::Program& program) const;
  void set_eye_axes(const gl::Program& program) const;
  void set_eye_depth(const gl::Program& program) const;

  Camera camera;
  glm::ivec2 size;
  ViewSettings settings;
  glm::dvec3 direction;  // parting direction, unit
  int sample;            // 0, 1, …
  glm::dvec2 shift_px;   // of the picture, y down; that of sample 0 is zero
  glm::dmat4 eye_from_unit, clip_from_eye;
  glm::mat4 clip_from_unit;
};

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

}  // namespace moldlight
