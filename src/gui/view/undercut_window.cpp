#include "gui/view/undercut_window.hpp"

#include <fmt/format.h>

#include "classify/figures.hpp"
#include "gui/draw/widgets.hpp"
#include "render/view_colours.hpp"

namespace moldlight::gui {

namespace {

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
    points.push_back(im(glm::vec2(*at)));
  }
  return points;
}

}  // namespace

const ToBeFree* chosen_change(const AppState& state) {
  const auto& chosen = state.action_choices.chosen;
  const auto& changes = state.actions.changes;
  return changes && chosen && *chosen < changes->size() ? &(*changes)[*chosen] : nullptr;
}

void draw_undercut_window(const Ui& ui, const AppState& state, const glm::ivec2& size) {
  const ToBeFree* const change = chosen_change(state);
  if (change == nullptr || !change->window) return;
  const UndercutWindow& window = *change->window;
  const ImU32 ink = packed(k_block_mark), shade = faded(ui.colours->panel, 0.7F);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
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
      box.min = glm::min(box.min, from_im(corner));
      box.max = glm::max(box.max, from_im(corner));
    }
  }
  ui.memory->controls["undercut window"] = box;
  const PartModel& model = *state.model;
  const std::string text =
      fmt::format("or a window of {} {}", figure(window.area), powered_unit(model.part, 2));
  const glm::vec2 room = 0.5F * tag_size(ui, text);
  const glm::vec2 at(0.5F * (box.min.x + box.max.x), box.max.y + ui.px(k_tag_gap));
  const glm::vec2 screen(size);
  if (glm::all(glm::greaterThan(at - room, glm::vec2(0.0F))) && glm::all(glm::lessThan(at + room, screen)))
    draw_tag(ui, at, text, ui.colours->text);
}

}  // namespace moldlight::gui
