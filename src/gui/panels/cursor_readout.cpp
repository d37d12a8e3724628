// What is said at the cursor about the surface under it: region, draft, and for an undercut what blocks it,
// whose distance stands at the way there, too.
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "classify/figures.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/draft_panel.hpp"
#include "gui/panels/panels.hpp"
#include "gui/view/revision_view.hpp"
#include "parting/draft/draft_report.hpp"
#include "render/view_colours.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_from_cursor = 18.0F, k_readout_line = 18.0F, k_padding = 8.0F;  // layout units
constexpr float k_least_way_px = 48.0F;  // of a way that is long enough for its distance to stand beside it

std::string length_text(const AppState& state, double length) {
  return fmt::format("{:.4g} {}", length, length_unit(state.model->part));
}

/// A length in the scene, at the way that has it.
void draw_length(const PanelContext& context, const ViewSegment& way, double length) {
  const Ui& ui = context.ui;
  const Camera& camera = context.state.camera;
  const glm::ivec2 size(ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y);
  const auto from = project(camera, size, glm::dvec3(way.start)),
             to = project(camera, size, glm::dvec3(way.end));
  if (!from || !to || glm::distance(*from, *to) < ui.px(k_least_way_px)) return;
  draw_tag(ui, glm::vec2(0.5 * (*from + *to)), length_text(context.state, length), ui.colours->text);
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
    lines.push_back(fmt::format("draft {}  ·  facet {}", draft_text(hover->draft_deg),
                                grouped(std::to_string(hover->point.facet))));
    if (state.settings.look.colour_mode == ColourMode::draft_angle) {
      if (const WallDraft* wall = wall_of_face(state, state.faces->of_facet[hover->point.facet]))
        lines.push_back(fmt::format("face: {} or more  ·  {}", draft_text(wall->least_deg),
                                    suggestion(*state.model, *wall)));
    }
    if (const auto& blocker = hover->blocker) {
      lines.push_back(fmt::format("blocked {} {} by facet {}", length_text(state, blocker->distance),
                                  blocker->above ? "above" : "below",
                                  grouped(std::to_string(blocker->facet))));
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
  const FreeArea area = context.layout.free_area(state.dialogs.panels_hidden);
  const glm::vec2 cursor = from_im(ImGui::GetIO().MousePos);
  glm::vec2 at = area.beside(cursor, size, ui.px(k_from_cursor));
  ui.memory->controls["readout"] = {at, at + size};
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRectFilled(im(at), im(at + size), ui.colours->popup, ui.px(6));
  list.AddRect(im(at), im(at + size), ui.colours->panel_border, ui.px(6));
  at += padding;
  const glm::vec2 mark = at + glm::vec2(0.0F, 0.5F * (ui.px(k_readout_line) - swatch));
  list.AddRectFilled(im(mark), im(mark + swatch), packed(colour), ui.px(3));
  for (const std::string& line : lines) {
    const bool first = &line == &lines.front();
    const SizedFont& font = first ? ui.fonts.strong : ui.fonts.body;
    draw_text(list, {font, first ? ui.colours->text : ui.colours->muted},
              at + glm::vec2(first ? swatch + ui.px(6) : 0.0F, 0.5F * (ui.px(k_readout_line) - font.size)),
              line);
    at.y += ui.px(k_readout_line);
  }
}

}  // namespace moldlight::gui
