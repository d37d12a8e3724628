// One sample of a picture: what every pass is told.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gl/program.hpp"
#include "render/camera.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

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

}  // namespace moldlight
