// Readout at the cursor of the surface under it: region, draft, and for an undercut what blocks it,
// whose distance stands at the way there, too; and what is measured between two places.
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"
#include "gui/view/revision_view.hpp"
#include "mesh/place_order.hpp"
#include "parting/draft/draft_check.hpp"
#include "render/view_settings.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_from_cursor = 18.0F, k_readout_line = 18.0F, k_padding = 8.0F;  // layout units
constexpr float k_least_way_px = 48.0F;  // of a way that is long enough for its distance to stand beside it

std::string length_text(const AppState& state, double length) {
  return rounded(length) + " " + length_unit(state.model->part);
}

/// A length in the scene, at the way that has it.
void draw_length(const PanelContext& context, const ViewSegment& way, double length) {
  const Ui& ui = context.ui;
  const Camera& camera = context.state.camera;
  const glm::ivec2 size(screen_size());
  const auto from = project(camera, size, glm::dvec3(way.start)),
             to = project(camera, size, glm::dvec3(way.end));
  if (!from || !to || glm::distance(*from, *to) < ui.px(k_least_way_px)) return;
  draw_tag(ui, glm::vec2(0.5 * (*from + *to)), length_text(context.state, length), ui.colours->text);
}

constexpr float k_card_width = 212.0F, k_card_row = 20.0F, k_from_line = 16.0F;  // layout units

void draw_row(const Ui& ui, const char* name, const std::string& figure, const std::string& exact) {
  ImGui::InvisibleButton(name, ImVec2(ui.px(k_card_width), ui.px(k_card_row)));
  const auto& [min, max] = item_box();
  ui.memory->controls[fmt::format("measured {}", name)] = {min, max};
  ImDrawList& list = window_list();
  if (ImGui::IsItemHovered()) fill(list, {min, max}, ui.colours->field, ui.px(4));
  const float top = 0.5F * (min.y + max.y - ui.fonts.body.size);
  draw_text(list, ui.muted(), {min.x + ui.px(4), top}, name);
  draw_text_to(ui.strong(), max.x - ui.px(4), top, figure);
  copy_menu(ui, name, exact);
}

void draw_card(const PanelContext& context, const MeasuredPair& pair, const glm::vec2& beside) {
  const Ui& ui = context.ui;
  const int rows = pair.between_planes ? 5 : 4;
  const ImVec2 padding = ImGui::GetStyle().WindowPadding, spacing = ImGui::GetStyle().ItemSpacing;
  const glm::vec2 size(
      ui.px(k_card_width) + 2.0F * padding.x,
      2.0F * padding.y + static_cast<float>(rows) * (ui.px(k_card_row) + spacing.y) - spacing.y);
  const FreeArea area = context.free_area();
  place_window(area.beside(beside, size, ui.px(k_from_line)), {0.0F, 0.0F});
  ImGui::Begin("Measured", nullptr, k_card_window);
  const auto length = [&](const char* name, double value) {
    draw_row(ui, name, length_text(context.state, value), real_text(value));
  };
  length("distance", pair.distance);
  length("along the direction", pair.along);
  length("across it", pair.across);
  if (pair.between_planes) length("between the planes", *pair.between_planes);
  draw_row(ui, "angle of the normals", fmt::format("{:.1f}°", pair.angle_deg), real_text(pair.angle_deg));
  ImGui::End();
}

}  // namespace

std::string draft_text(double draft_deg) {
  const double shown = std::abs(draft_deg) < 0.05 ? 0.0 : draft_deg;
  return fmt::format("{}{:.1f}°", shown < 0.0 ? "−" : "", std::abs(shown));
}

std::vector<std::string> readout_lines(const AppState& state) {
  std::vector<std::string> lines;
  if (const auto& hover = state.hover) {
    lines.emplace_back(facts(hover->point.region).title);
    lines.push_back("draft " + draft_text(hover->draft_deg));
    if (state.settings.look.colour_mode == ColourMode::draft_angle) {
      const Finish* const finish =
          finish_of(state.settings.required_draft.finishes, state.faces->of_facet[hover->point.facet]);
      if (finish != nullptr)
        lines.push_back(
            finish->required_deg > 0.0
                ? fmt::format("finish {}: {}° or more", finish->name, figure(finish->required_deg))
                : fmt::format("finish {}: draft is not checked", finish->name));
      if (const WallDraft* wall = wall_of_face(state, state.faces->of_facet[hover->point.facet]))
        lines.push_back(fmt::format("face: {} or more  ·  {}", draft_text(wall->least_deg),
                                    suggestion(*state.model, *wall)));
    }
    if (const auto& blocker = hover->blocker) {
      lines.push_back(fmt::format("blocked {} {}", length_text(state, blocker->distance),
                                  blocker->above ? "above" : "below"));
    }
  }
  if (const auto& span = state.span) {
    if (lines.empty()) lines.emplace_back("Section");
    lines.push_back(
        fmt::format("{} {}", span->material ? "thickness" : "gap", length_text(state, span->length)));
  }
  for (std::string& line : revision_lines(state)) lines.push_back(std::move(line));
  return lines;
}

void draw_cursor_readout(const PanelContext& context) {
  const AppState& state = context.state;
  const Ui& ui = context.ui;
  const std::vector<std::string> lines = readout_lines(state);
  if (lines.empty() || state.measuring) return;  // which has its own
  if (state.hover && state.hover->blocker) {
    const Blocker& blocker = *state.hover->blocker;
    draw_length(context, {blocker.from, blocker.at}, blocker.distance);
  }
  if (state.span) draw_length(context, {state.span->start, state.span->end}, state.span->length);
  const auto& other = state.revisions.hover;
  const std::optional<Region> region = state.hover              ? std::optional(state.hover->point.region)
                                       : other && other->second ? std::optional(other->point.region)
                                                                : std::nullopt;
  const Colour colour = region ? region_colour(*region, state.settings.look.palette) : k_cut_surface;
  const float padding = ui.px(k_padding), swatch = ui.px(10);
  glm::vec2 size(0.0F, 2.0F * padding + static_cast<float>(lines.size()) * ui.px(k_readout_line));
  for (const std::string& line : lines) {
    const bool first = &line == &lines.front();
    size.x = std::max(size.x, 2.0F * padding + text_size(first ? ui.fonts.strong : ui.fonts.body, line).x +
                                  (first ? swatch + ui.px(6) : 0.0F));
  }
  const FreeArea area = context.free_area();
  const glm::vec2 cursor = mouse_at();
  glm::vec2 at = area.beside(cursor, size, ui.px(k_from_cursor));
  ui.memory->controls["readout"] = {at, at + size};
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRectFilled(at, at + size, ui.colours->popup, ui.px(6));
  list.AddRect(at, at + size, ui.colours->panel_border, ui.px(6));
  at += padding;
  const glm::vec2 mark = at + glm::vec2(0.0F, 0.5F * (ui.px(k_readout_line) - swatch));
  list.AddRectFilled(mark, mark + swatch, packed(colour), ui.px(3));
  for (const std::string& line : lines) {
    const bool first = &line == &lines.front();
    const SizedFont& font = first ? ui.fonts.strong : ui.fonts.body;
    draw_text(list, {font, first ? ui.colours->text : ui.colours->muted},
              at + glm::vec2(first ? swatch + ui.px(6) : 0.0F, 0.5F * (ui.px(k_readout_line) - font.size)),
              line);
    at.y += ui.px(k_readout_line);
  }
}

void draw_measuring(const PanelContext& context) {
  const AppState& state = context.state;
  if (!state.measuring) return;
  const Ui& ui = context.ui;
  std::vector<MeasuredPlace> places = state.measuring->places;
  const bool clicked = places.size() == 2;
  if (places.size() == 1 && state.hover) places.push_back(measured_place(*state.model, state.hover->point));
  ImDrawList& list = scene_list();
  const glm::ivec2 window(screen_size());
  std::vector<glm::vec2> seen;
  for (const MeasuredPlace& place : places) {
    const auto pixel = project(state.camera, window, glm::dvec3(state.model->frame.to_unit(place.at)));
    if (!pixel) return;
    seen.emplace_back(*pixel);
  }
  if (seen.size() == 2) {
    list.AddLine(seen[0], seen[1], ui.colours->panel, 4.0F * ui.scale);
    list.AddLine(seen[0], seen[1], ui.colours->text, 2.0F * ui.scale);
  }
  for (const glm::vec2& end : seen) {
    list.AddCircleFilled(end, ui.px(5), ui.colours->panel);
    list.AddCircleFilled(end, ui.px(3), ui.colours->text);
  }
  if (seen.size() < 2) {
    const FreeArea area = context.free_area();
    draw_tag(ui, {area.middle_x(), static_cast<float>(area.min.y) + ui.px(24)},
             places.empty() ? "Measure: click a place on the part" : "and a second place", ui.colours->text);
    return;
  }
  const MeasuredPair pair = measured(places[0], places[1], state.settings.direction.unit());
  const glm::vec2 middle = 0.5F * (seen[0] + seen[1]);
  // Beside the line that was clicked; until then the cursor's own readout is in the way of a card.
  if (clicked) {
    draw_card(context, pair, middle);
  } else {
    draw_tag(ui, middle, length_text(state, pair.distance), ui.colours->text);
  }
}

}  // namespace moldlight::gui
