// The direction ball: the directions as the camera sees the part, to grab and to read.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "gui/direction_ball.hpp"
#include "gui/loaded_part.hpp"
#include "gui/panels/direction_map.hpp"
#include "gui/panels/panels.hpp"
#include "gui/widgets.hpp"

namespace moldlight::gui {

namespace {

/// A sphere shaded from the upper left, as rings of triangles.
void draw_sphere(ImDrawList& list, const glm::vec2& centre, float radius, ImU32 light, ImU32 dark) {
  constexpr int k_rings = 7, k_spokes = 40;
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
  const auto vertex = [&](int ring, int spoke) {
    const float r = std::sin(0.5F * glm::pi<float>() * static_cast<float>(ring) / k_rings);
    const float angle = 2.0F * glm::pi<float>() * static_cast<float>(spoke % k_spokes) / k_spokes;
    const glm::vec2 at(r * std::cos(angle), r * std::sin(angle));
    const glm::vec3 normal(at, std::sqrt(std::max(0.0F, 1.0F - r * r)));
    const float lit = std::clamp(glm::dot(normal, glm::normalize(glm::vec3(-0.5F, -0.7F, 0.8F))), 0.0F, 1.0F);
    list.PrimVtx(im(centre + radius * at), white, mixed(dark, light, lit));
  };
  list.PrimReserve(k_rings * k_spokes * 6, k_rings * k_spokes * 6);
  for (int ring = 0; ring < k_rings; ++ring) {
    for (int spoke = 0; spoke < k_spokes; ++spoke) {
      vertex(ring, spoke);
      vertex(ring + 1, spoke);
      vertex(ring + 1, spoke + 1);
      vertex(ring, spoke);
      vertex(ring + 1, spoke + 1);
      vertex(ring, spoke + 1);
    }
  }
  list.AddCircle(im(centre), radius, dark, 64, 1.5F);
}

struct Ball : BallPlace {
  [[nodiscard]] glm::vec2 screen(const BallPoint& point) const {
    return centre + radius * glm::vec2(point.at.x, -point.at.y);
  }
  [[nodiscard]] glm::dvec2 disc(const glm::vec2& pixel) const {
    return {(pixel.x - centre.x) / radius, (centre.y - pixel.y) / radius};
  }
};

/// The great circle across `axis`, its far half fainter.
void draw_great_circle(ImDrawList& list, const Ball& ball, const Camera& camera, const glm::dvec3& axis,
                       ImU32 colour) {
  const glm::dvec3 side = std::abs(axis.z) > 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 x = glm::normalize(glm::cross(axis, side)), y = glm::cross(axis, x);
  constexpr int k_steps = 48;
  glm::vec2 before(0.0F);
  for (int step = 0; step <= k_steps; ++step) {
    const double angle = 2.0 * glm::pi<double>() * step / k_steps;
    const BallPoint point = ball_point(camera, std::cos(angle) * x + std::sin(angle) * y);
    const glm::vec2 here = ball.screen(point);
    if (step > 0 && point.front) list.AddLine(im(before), im(here), colour, 1.0F);
    before = here;
  }
}

void draw_axis_names(const Ui& ui, ImDrawList& list, const Ball& ball, const Camera& camera) {
  constexpr std::string_view k_names = "XYZ";
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    const BallPoint point = ball_point(camera, direction);
    if (!point.front) continue;
    const glm::vec2 at = ball.centre + 0.86F * (ball.screen(point) - ball.centre);
    draw_text(list, ui.fonts.small, at - 0.5F * text_size(ui.fonts.small, k_names.substr(axis, 1)),
              ui.colours->muted, k_names.substr(axis, 1));
  }
}

void drag_ball(const PanelContext& context, BallDrag& drag, const Ball& ball) {
  const Camera& camera = context.state.camera;
  MethodSettings& method = context.edits.settings.method;
  const glm::vec2 mouse = from_im(ImGui::GetIO().MousePos);
  if (ImGui::IsItemActivated()) {
    const BallPoint marker = ball_point(camera, glm::normalize(method.direction));
    const glm::vec2 to_marker = ball.screen(marker) - mouse;
    const bool gripped = glm::length(to_marker) < context.ui.px(10);
    drag = {.active = true,
            .gripped = gripped,
            .back = gripped && !marker.front,
            .grip = gripped ? to_marker : glm::vec2(0.0F)};
  }
  if (!ImGui::IsItemActive() || !drag.active) {
    drag.active = false;
    return;
  }
  context.edits.dragging = true;
  if (drag.gripped && !ImGui::IsMouseDragging(0, 3.0F)) return;
  glm::dvec3 direction = ball_direction(camera, {ball.disc(mouse + drag.grip), !drag.back});
  if (ImGui::GetIO().KeyCtrl) direction = snapped_to(context.state.features, direction);
  method.direction = direction;
}

}  // namespace

void draw_ball(const PanelContext& context, BallDrag& drag, float size) {
  const Ui& ui = context.ui;
  ImGui::InvisibleButton("ball", ImVec2(size, size));
  ui.memory->controls["ball"] = {from_im(ImGui::GetItemRectMin()), from_im(ImGui::GetItemRectMax())};
  const glm::vec2 min = from_im(ImGui::GetItemRectMin());
  const Ball ball{{min + glm::vec2(0.5F * size), 0.5F * size - ui.px(3)}};
  drag_ball(context, drag, ball);
  const Camera& camera = context.state.camera;
  const SweepState& sweep = context.state.sweep;
  const bool mapped = sweep.map && !sweep.map->field.empty();
  const glm::dvec2 mouse = ball.disc(from_im(ImGui::GetIO().MousePos));
  const bool read = mapped && ImGui::IsItemHovered() && !ImGui::IsMouseDown(0) && glm::length(mouse) < 1.0;
  if (!drag.active && !mapped) {
    tooltip(ui, "Direction ball",
            "Drag to turn the parting direction; hold Ctrl to snap to the part's own directions.");
  }
  if (mapped && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
    context.edits.sweep_choices.large_ball = !context.state.sweep_choices.large_ball;
  }

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool dark = context.state.window.theme == Theme::dark;
  const BareBall bare{.light = dark ? IM_COL32(88, 93, 100, 255) : IM_COL32(255, 255, 255, 255),
                      .dark = dark ? IM_COL32(34, 36, 40, 255) : IM_COL32(176, 182, 189, 255)};
  if (mapped) {
    draw_direction_map(list, ball, camera, *sweep.map, bare);
  } else {
    draw_sphere(list, ball.centre, ball.radius, bare.light, bare.dark);
  }
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 across(0.0);
    across[axis] = 1.0;
    draw_great_circle(list, ball, camera, across, faded(ui.colours->text, 0.16F));
  }
  draw_axis_names(ui, list, ball, camera);
  if (ImGui::GetIO().KeyCtrl) {
    for (const FeatureDirection& feature : context.state.features) {
      for (const glm::dvec3& direction : {feature.direction, -feature.direction}) {
        const BallPoint point = ball_point(camera, direction);
        if (point.front) list.AddCircleFilled(im(ball.screen(point)), 2.5F * ui.scale, ui.colours->text);
      }
    }
  }
  if (mapped) draw_sweep_marks(ui, list, ball, camera, sweep);
  const BallPoint marker = ball_point(camera, glm::normalize(context.edits.settings.method.direction));
  const glm::vec2 at = ball.screen(marker);
  list.AddLine(im(ball.centre), im(at), faded(ui.colours->text, marker.front ? 0.8F : 0.3F), 1.5F * ui.scale);
  if (marker.front) {
    list.AddCircleFilled(im(at), 5.5F * ui.scale, mapped ? IM_COL32(20, 14, 18, 220) : IM_COL32(0, 0, 0, 70));
    list.AddCircleFilled(im(at), 4.0F * ui.scale,
                         dark || mapped ? IM_COL32_WHITE : IM_COL32(30, 32, 35, 255));
  } else {
    list.AddCircle(im(at), 4.5F * ui.scale, faded(ui.colours->text, 0.6F), 0, 1.5F * ui.scale);
  }
  if (read) tell_direction(context, ball_direction(camera, {mouse, true}));
}

}  // namespace moldlight::gui
