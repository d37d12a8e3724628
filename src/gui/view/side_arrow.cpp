// The side action that is looked at, over the scene.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/view/direction.hpp"
#include "gui/view/side_actions.hpp"
#include "mold/direction.hpp"
#include "render/view_settings.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_arc_share = 0.72;  // of the arrow's length: the arc's radius
constexpr double k_arc_step_deg = 3.0;
constexpr double k_narrow_deg = 1e-3;  // an interval that is none

/// Points of the scene on the screen; those behind the eye are left out.
std::vector<ImVec2> on_screen(const Camera& camera, const glm::ivec2& size,
                              const std::vector<glm::dvec3>& points) {
  std::vector<ImVec2> found;
  for (const glm::dvec3& point : points)
    if (const auto at = project(camera, size, point)) found.push_back(glm::vec2(*at));
  return found;
}

void stroke(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 colour, float width) {
  list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, ImDrawFlags_None, width);
}

constexpr float k_tag_gap = 18.0F;  // layout units, above the outline

/// The same outline moved along the parting direction, on the screen; nothing where some of it is behind the
/// eye.
std::optional<std::vector<ImVec2>> on_screen(const AppState& state, const glm::ivec2& size,
                                             const std::vector<glm::dvec3>& loop, double along) {
  const glm::dvec3 way = along * state.settings.direction.unit();
  std::vector<ImVec2> points;
  for (const glm::dvec3& corner : loop) {
    const auto at = project(state.camera, size, glm::dvec3(state.model->frame.to_unit(corner + way)));
    if (!at) return std::nullopt;
    points.push_back(glm::vec2(*at));
  }
  return points;
}

}  // namespace

glm::dvec3 side_direction_at(const Camera& camera, const glm::ivec2& size, const SidePull& pull,
                             const glm::vec2& at) {
  constexpr double k_coarse_deg = 2.0, k_fine_deg = 0.02;
  constexpr double k_far_px_per_deg = 0.15;  // what an angle from the former direction weighs
  const glm::dvec3 level = glm::normalize(pull.former - glm::dot(pull.former, pull.parting) * pull.parting);
  const auto miss = [&](double turn_deg) {
    const glm::dvec3 tip =
        pull.tail + side_arrow_length(camera) * turned_about(level, pull.parting, turn_deg);
    const auto seen = project(camera, size, tip), foot = project(camera, size, pull.tail);
    if (!seen || !foot) return std::numeric_limits<double>::infinity();
    // Beyond the tip the hand still points along it.
    const glm::dvec2 hand = glm::dvec2(at) - *foot, arrow = *seen - *foot;
    const double reach = std::max(glm::length(arrow), 1.0);
    const glm::dvec2 held = glm::length(hand) > reach ? hand / glm::length(hand) * reach : hand;
    return glm::distance(held, arrow) + k_far_px_per_deg * std::abs(turn_deg);
  };
  double best_deg = 0.0, least = miss(0.0);
  const auto search = [&](double from_deg, double to_deg, double step_deg) {
    for (double turn_deg = from_deg; turn_deg <= to_deg; turn_deg += step_deg) {
      const double found = miss(turn_deg);
      if (found >= least) continue;
      least = found;
      best_deg = turn_deg;
    }
  };
  search(-180.0, 180.0, k_coarse_deg);
  const double middle = best_deg;
  search(middle - k_coarse_deg, middle + k_coarse_deg, k_fine_deg);
  return tidy(turned_about(level, pull.parting, best_deg));
}

void draw_side_arrow(const Ui& ui, const AppState& state, const glm::ivec2& size, bool lively) {
  const auto arrow = side_arrow(state);
  if (!arrow) return;
  ImDrawList& list = scene_list();
  const Camera& camera = state.camera;
  const glm::dvec3 tip = arrow->tail + side_arrow_length(camera) * arrow->direction;
  const auto foot = project(camera, size, arrow->tail), end = project(camera, size, tip);
  if (!foot || !end) return;
  const bool held = state.action_choices.wish.has_value();
  const ImU32 ink = faded(ui.colours->text, arrow->released || held ? 1.0F : 0.75F),
              shade = ui.colours->panel;

  // The sector is the action's own, also while the arrow is dragged elsewhere.
  if (arrow->free && arrow->free->to_deg - arrow->free->from_deg > k_narrow_deg) {
    const glm::dvec3& parting = state.settings.direction.unit();
    const glm::dvec3 axis = chosen_action(state)->direction;
    const double from = arrow->free->from_deg, to = arrow->free->to_deg;
    const int steps = std::max(2, static_cast<int>(std::ceil((to - from) / k_arc_step_deg)));
    std::vector<glm::dvec3> rim;
    for (int k = 0; k <= steps; ++k)
      rim.push_back(arrow->tail + k_arc_share * side_arrow_length(camera) *
                                      turned_about(axis, parting, from + (to - from) * k / steps));
    const std::vector<ImVec2> arc = on_screen(camera, size, rim);
    for (std::size_t k = 1; k < arc.size(); ++k)
      list.AddTriangleFilled(glm::vec2(*foot), arc[k - 1], arc[k], faded(ui.colours->accent, 0.22F));
    stroke(list, arc, shade, 4.5F * ui.scale);
    stroke(list, arc, ui.colours->accent, 2.5F * ui.scale);
    for (const ImVec2& edge : {arc.front(), arc.back()})
      list.AddLine(glm::vec2(*foot), edge, faded(ui.colours->accent, 0.7F), 1.0F * ui.scale);
  }

  const glm::vec2 from(*foot), at(*end), along = at - from;
  const float length = glm::length(along);
  const glm::vec2 forward = length > 1.0F ? along / length : glm::vec2(0.0F, -1.0F),
                  aside(-forward.y, forward.x);
  const float head = std::min(ui.px(13), 0.8F * length);
  const glm::vec2 neck = at - forward * head;
  list.AddCircleFilled(from, ui.px(4) + 1.0F, shade);
  list.AddCircleFilled(from, ui.px(4), ink);
  list.AddLine(from, neck, shade, 5.0F * ui.scale);
  list.AddTriangleFilled(at + forward * 2.0F * ui.scale, neck - forward * ui.scale + aside * 0.62F * head,
                         neck - forward * ui.scale - aside * 0.62F * head, shade);
  list.AddLine(from, neck, ink, 2.5F * ui.scale);
  list.AddTriangleFilled(at, neck + aside * 0.5F * head, neck - aside * 0.5F * head, ink);
  if (lively) list.AddCircle(at, ui.px(12), faded(ui.colours->text, 0.6F), 0, 1.5F * ui.scale);
  const glm::vec2 reach(ui.px(12));
  ui.memory->controls["side arrow"] = {at - reach, at + reach};

  const SideAction* const action = chosen_action(state);
  std::string name =
      action != nullptr ? std::string(facts(action->kind).singular) : "drag to try a direction";
  if (held) name = with_minus(direction_words(arrow->direction));
  draw_whole_tag(ui, beyond_tip(ui, from, at, name), name, ui.colours->text);
}

const DesignChange* chosen_change(const AppState& state) {
  const auto& chosen = state.action_choices.chosen;
  const auto& changes = state.actions.changes;
  return changes && chosen && *chosen < changes->size() ? &(*changes)[*chosen] : nullptr;
}

void draw_undercut_window(const Ui& ui, const AppState& state, const glm::ivec2& size) {
  const DesignChange* const change = chosen_change(state);
  if (change == nullptr || !change->window) return;
  const UndercutWindow& window = *change->window;
  const ImU32 ink = packed(k_block_mark), shade = faded(ui.colours->panel, 0.7F);
  ImDrawList& list = scene_list();
  ScreenBox box{glm::vec2(std::numeric_limits<float>::infinity()),
                glm::vec2(-std::numeric_limits<float>::infinity())};
  for (const std::vector<glm::dvec3>& loop : window.loops) {
    // From the surface that it opens to through what is in the way.
    const auto outer = on_screen(state, size, loop, 0.0);
    const auto inner = on_screen(state, size, loop, (window.core_side ? -1.0 : 1.0) * window.thickness);
    if (!outer || !inner) return;
    const int count = static_cast<int>(outer->size());
    list.AddPolyline(inner->data(), count, faded(ink, 0.55F), ImDrawFlags_Closed, 1.25F * ui.scale);
    list.AddPolyline(outer->data(), count, shade, ImDrawFlags_Closed, 4.5F * ui.scale);
    list.AddPolyline(outer->data(), count, ink, ImDrawFlags_Closed, 2.5F * ui.scale);
    for (const ImVec2& corner : *outer) {
      box.min = glm::min(box.min, glm::vec2(corner));
      box.max = glm::max(box.max, glm::vec2(corner));
    }
  }
  ui.memory->controls["undercut window"] = box;
  const PartModel& model = *state.model;
  const std::string text = "or a window of " + FigureStyle(model).with_unit(FigureKind::area, window.area);
  draw_whole_tag(ui, {0.5F * (box.min.x + box.max.x), box.max.y + ui.px(k_tag_gap)}, text, ui.colours->text);
}

}  // namespace moldlight::gui
