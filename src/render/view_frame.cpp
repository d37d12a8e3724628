#include "render/view_frame.hpp"

#include <cmath>

#include <glm/common.hpp>

namespace moldlight {

namespace {

/// Half the width of the tent over which a pixel's samples are spread, in pixels.
constexpr double k_tent_px = 0.85;

double tent(double share) {
  return share < 0.5 ? std::sqrt(2.0 * share) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * share);
}

/// Of sample k: member k of the additive recurrence of the plastic number (Roberts 2018), which fills the
/// pixel evenly however many of it are taken; sample 0 is the middle.
glm::dvec2 picture_shift(int sample) {
  constexpr double k_root = 1.3247179572447460;  // of x^3 = x + 1
  const glm::dvec2 point =
      glm::fract(0.5 + static_cast<double>(sample) * glm::dvec2(1.0 / k_root, 1.0 / (k_root * k_root)));
  return k_tent_px * glm::dvec2(tent(point.x), tent(point.y));
}

}  // namespace

ViewFrame::ViewFrame(const Camera& from, const glm::ivec2& picture_size, const ViewSettings& shown,
                     const glm::dvec3& parting_direction, int sample_number)
    : camera(from),
      size(picture_size),
      settings(shown),
      direction(parting_direction),
      sample(sample_number),
      shift_px(picture_shift(sample_number)),
      eye_from_unit(view_matrix(from)),
      clip_from_eye(projection_matrix(from, picture_size, shift_px)),
      clip_from_unit(clip_from_eye * eye_from_unit) {}

void ViewFrame::set_sight(const gl::Program& program) const {
  const double length = pixel_length(camera, size);
  const glm::dvec3 step_x = length * camera.right(), step_y = length * camera.up();
  // Of the lower left corner; rows count from below in GL.
  const glm::dvec3 corner =
      camera.target - (0.5 * size.x + shift_px.x) * step_x + (shift_px.y - 0.5 * size.y) * step_y;
  const bool parallel = camera.projection == Projection::orthographic;
  const glm::dvec3 none(0.0);
  program.set("u_sight_origin[0]", glm::vec3(parallel ? corner : camera.eye()));
  program.set("u_sight_origin[1]", glm::vec3(parallel ? step_x : none));
  program.set("u_sight_origin[2]", glm::vec3(parallel ? step_y : none));
  program.set("u_sight_direction[0]", glm::vec3(parallel ? -camera.toward_viewer() : corner - camera.eye()));
  program.set("u_sight_direction[1]", glm::vec3(parallel ? none : step_x));
  program.set("u_sight_direction[2]", glm::vec3(parallel ? none : step_y));
}

void ViewFrame::set_eye_axes(const gl::Program& program) const {
  program.set("u_eye_right", glm::vec3(camera.right()));
  program.set("u_eye_up", glm::vec3(camera.up()));
  program.set("u_eye_back", glm::vec3(camera.toward_viewer()));
}

void ViewFrame::set_eye_depth(const gl::Program& program) const {
  const auto [near, far] = depth_range(camera);
  program.set("u_eye_depth", camera.projection == Projection::perspective
                                 ? glm::vec4(near * far, 0.0, far, near - far)
                                 : glm::vec4(near, far - near, 1.0, 0.0));
}

ViewTargets::ViewTargets(const gl::Functions& gl, const glm::ivec2& wanted) : size(wanted) {
  const auto texture = [&](GLenum format) { return gl::make_texture_2d(gl, format, size.x, size.y); };
  surface = texture(GL_RG32UI);
  depth = texture(GL_DEPTH_COMPONENT32F);
  accessible = texture(GL_R8UI);
  openness = texture(GL_R8);
  colour = texture(GL_RGBA8);
  to_surface = gl::make_framebuffer(gl, surface, &depth);
  to_accessible = gl::make_framebuffer(gl, accessible, &depth);
  to_colour = gl::make_framebuffer(gl, colour, &depth);
  const GLuint shaded[] = {colour.name(), accessible.name()};
  to_shaded = gl::make_framebuffer(gl, {.colours = shaded, .depth = depth.name()});
  to_depth = gl::make_framebuffer(gl, {.colours = {}, .depth = depth.name()});
  to_openness = gl::make_framebuffer(gl, openness);
}

void ViewTargets::make_sum(const gl::Functions& gl) {
  if (sum) return;
  sum = gl::make_texture_2d(gl, GL_RGBA32F, size.x, size.y);
  to_sum = gl::make_framebuffer(gl, sum);
}

const gl::Program& ViewPrograms::use(std::string_view vertex, std::string_view fragment,
                                     const std::vector<std::string_view>& defines) {
  std::string key(vertex);
  key.append(" ").append(fragment);
  for (const std::string_view define : defines) key.append(" ").append(define);
  auto found = programs_.find(key);
  if (found == programs_.end()) {
    gl::ProgramSources sources{.vertex = vertex, .fragment = fragment};
    for (const std::string_view define : defines) {
      if (!define.empty()) sources.defines.emplace_back(define, "1");
    }
    found = programs_.emplace(std::move(key), gl::Program(*gl_, sources)).first;
  }
  found->second.use();
  return found->second;
}

}  // namespace moldlight
