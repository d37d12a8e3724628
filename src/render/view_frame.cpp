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

ViewFrame::ViewFrame(const ViewInputs& inputs, const ViewSubject& shown, const glm::ivec2& picture_size,
                     int sample_number)
    : ViewInputs(inputs),
      subject(shown),
      size(picture_size),
      sample(sample_number),
      shift_px(picture_shift(sample_number)),
      eye_from_unit(view_matrix(camera)),
      clip_from_eye(projection_matrix(camera, size, shift_px)),
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

void ViewFrame::set_section(const gl::Program& program) const {
  program.set("u_section_normal", glm::vec3(settings.cut->normal));
  program.set("u_section_offset", settings.cut->offset);
}

std::vector<Piece> ViewFrame::pieces() const {
  const auto bit = [](Region region) { return 1U << facts(region).accessible; };
  if (layer == Layer::undercuts_alone) return {{glm::vec3(0.0F), bit(Region::undercut)}};
  const glm::vec3 moved(settings.travel() * direction);
  return {{glm::vec3(0.0F), bit(Region::undercut) | bit(Region::both)},
          {moved, bit(Region::core)},
          {-moved, bit(Region::cavity)}};
}

bool ViewFrame::exact() const {
  return subject.split != nullptr && (subject.maps == nullptr || settings.regions_by == RegionsBy::exact);
}

std::string_view ViewFrame::kernel_define() const {
  return subject.maps != nullptr && subject.maps->settings().symmetric_kernel ? "SYMMETRIC_KERNEL" : "";
}

}  // namespace moldlight
