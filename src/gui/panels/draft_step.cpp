#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/workspace.hpp"
#include "parting/draft/draft_check.hpp"
#include "render/view_settings.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_chart = 112.0F, k_axis = 20.0F, k_grip = 14.0F;  // layout units
constexpr float k_walls_share = 0.4F;  // of the window's height, that the list takes at most
constexpr double k_step_deg = 0.1;

void draw_bars(const PanelContext& context, const DraftChart& chart, const DraftCheck& check) {
  const Ui& ui = context.ui;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto is_shown = [](const DraftBin& bin) {
    return bin.from_deg >= DraftChart::k_from_deg && bin.to_deg <= DraftChart::k_to_deg;
  };
  double tallest = 0.0;
  for (const DraftBin& bin : check.histogram) {
    if (is_shown(bin)) tallest = std::max(tallest, bin.area[0] + bin.area[1]);
  }
  const float gap = 0.5F * ui.scale, height = chart.box.max.y - chart.box.min.y;
  for (const DraftBin& bin : check.histogram) {
    if (!is_shown(bin) || tallest <= 0.0) continue;
    const float left = chart.place_of(bin.from_deg) + gap, right = chart.place_of(bin.to_deg) - gap;
    float foot = chart.box.max.y;
    for (const Region region : {Region::core, Region::cavity}) {
      const double area = bin.area[region == Region::core ? 0 : 1];
      if (area <= 0.0) continue;
      // What there is is seen.
      const float top = foot - std::max(height * static_cast<float>(area / tallest), ui.px(1));
      list.AddRectFilled(ImVec2(left, top), ImVec2(right, foot),
                         packed(region_colour(region, context.state.settings.look.palette)));
      foot = top;
    }
  }
}

void tell_bin(const PanelContext& context, const DraftChart& chart, const DraftCheck& check) {
  const double draft = chart.draft_at(ImGui::GetIO().MousePos.x);
  const auto bin = std::ranges::find_if(
      check.histogram, [&](const DraftBin& each) { return draft >= each.from_deg && draft < each.to_deg; });
  if (bin == check.histogram.end()) return;
  const PartModel& model = *context.state.model;
  const std::string unit = powered_unit(model.part, 2);
  const FigureColumn areas(model.geometry.total_area);
  tooltip(context.ui, with_minus(fmt::format("{}° to {}°", bin->from_deg, bin->to_deg)),
          fmt::format("core {} {}\ncavity {} {}", grouped(areas.text(bin->area[0])), unit,
                      grouped(areas.text(bin->area[1])), unit));
}

/// The limit of what is required, which a hand may drag.
void draw_limit(const PanelContext& context, const DraftChart& chart) {
  const Ui& ui = context.ui;
  double& required = context.edits.settings.required_draft.deg;
  const float x = chart.place_of(required), half = 0.5F * ui.px(k_grip);
  ImGui::SetCursorScreenPos(ImVec2(x - half, chart.box.min.y));
  const Pressable grip = pressable(ui, "draft limit", {2.0F * half, chart.box.max.y - chart.box.min.y});
  if (grip.active) {
    const double draft = chart.draft_at(ImGui::GetIO().MousePos.x);
    required = std::max(k_step_deg, k_step_deg * std::round(draft / k_step_deg));
  }
  const bool lively = grip.hovered || grip.active;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine(ImVec2(x, chart.box.min.y), ImVec2(x, chart.box.max.y),
               lively ? ui.colours->accent : ui.colours->text, (lively ? 2.0F : 1.5F) * ui.scale);
  list.AddCircleFilled(ImVec2(x, chart.box.min.y), ui.px(lively ? 4.0F : 3.0F),
                       lively ? ui.colours->accent : ui.colours->text);
  if (!grip.active) tooltip(ui, "Required draft", "Drag to change the required draft.");
}

void draw_chart(const PanelContext& context, const DraftCheck& check) {
  const Ui& ui = context.ui;
  const glm::vec2 start = from_im(ImGui::GetCursorScreenPos());
  const float width = ImGui::GetContentRegionAvail().x;
  const glm::vec2 inset(ui.px(8), ui.px(4));
  const DraftChart chart{{start + inset, {start.x + width - inset.x, start.y + ui.px(k_chart)}}};
  ui.memory->controls["draft chart"] = chart.box;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float foot = chart.box.max.y;
  draw_bars(context, chart, check);
  list.AddLine(ImVec2(chart.box.min.x, foot), ImVec2(chart.box.max.x, foot), ui.colours->line);
  for (const int draft : {-5, 0, 5, 10}) {
    const std::string text = with_minus(fmt::format("{}°", draft));
    const float size = text_size(ui.fonts.small, text).x;
    const float left = std::clamp(chart.place_of(draft) - 0.5F * size, start.x, start.x + width - size);
    draw_text(list, {ui.fonts.small, ui.colours->muted}, {left, foot + ui.px(3)}, text);
  }
  draw_limit(context, chart);
  ImGui::SetCursorScreenPos(im(start));
  ImGui::Dummy(ImVec2(width, ui.px(k_chart)));
  if (ImGui::IsItemHovered() && !ImGui::IsAnyItemActive()) tell_bin(context, chart, check);
  ImGui::SetCursorScreenPos(ImVec2(start.x, start.y + ui.px(k_chart + k_axis)));
}

}  // namespace

void draw_draft_key(const PanelContext& context) {
  const Ui& ui = context.ui;
  const DraftScale scale =
      draft_scale(context.state.settings.required_draft.deg, context.state.settings.look.palette);
  const glm::vec2 start = from_im(ImGui::GetCursorScreenPos()) + glm::vec2(ui.px(8), ui.px(3));
  const float step =
      (ImGui::GetContentRegionAvail().x - ui.px(16)) / static_cast<float>(scale.colours.size());
  const float height = ui.px(8);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t k = 0; k < scale.colours.size(); ++k) {
    const glm::vec2 min = start + glm::vec2(static_cast<float>(k) * step, 0.0F);
    list.AddRectFilled(im(min), im(min + glm::vec2(step - ui.px(1), height)), packed(scale.colours[k]),
                       ui.px(2));
  }
  for (std::size_t k = 0; k < scale.limits_deg.size(); ++k) {
    const double limit = scale.limits_deg[k];
    const std::string text = fmt::format("{}{:.3g}°", limit < 0.0 ? "−" : "", std::abs(limit));
    draw_text(list, {ui.fonts.small, ui.colours->muted},
              start + glm::vec2(static_cast<float>(k + 1) * step - 0.5F * text_size(ui.fonts.small, text).x,
                                height + ui.px(3)),
              text);
  }
  ImGui::Dummy(ImVec2(1.0F, height + ui.px(6) + ui.fonts.small.size));
}

const WallDraft* wall_of_face(const AppState& state, std::uint32_t face, std::optional<MoldSide> side) {
  const auto& line = state.mold.line;
  if (!line || !line->draft) return nullptr;
  const auto found = std::ranges::find_if(line->draft->walls, [&](const WallDraft& wall) {
    return wall.face == face && (!side || wall.side == *side);
  });
  return found == line->draft->walls.end() ? nullptr : &*found;
}

void DraftStep::draw(const PanelContext& context, StepMemory& memory) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  if (state.mold.line || state.model != model_) {
    line_ = state.mold.line;
    model_ = state.model;
  }
  draw_news(context, memory, news(state));
  option_row(ui, required_draft_options().front(), context.edits.settings.required_draft);
  if (check() == nullptr) return;
  draw_chart(context, *check());
  draw_draft_key(context);
  if (check()->walls.empty()) return;
  const RowList walls{
      .id = "walls", .count = check()->walls.size(), .row_height = k_two_lines, .share = k_walls_share};
  if (const auto pressed = draw_list(ui, walls, memory.cursor,
                                     [&](std::size_t k) { draw_row(context, k, memory.cursor.is_at(k)); }))
    context.edits.ask(&Commands::look_at_wall, *pressed);
}

StepNews DraftStep::news(const AppState& state) const {
  const MoldState& mold = state.mold;
  if (check() != nullptr) {
    StepNews news{.text = draft_sentence(*state.model, *check())};
    if (mold.line_awaited) news.progress = -1.0;
    return news;
  }
  if (mold.line_awaited) return {.text = "Finding the parting line …", .progress = -1.0};
  if (!mold.error.empty()) return {.text = mold.error, .warning = true};
  return {.text = mold.line ? "No draft is required." : "Measuring …"};
}

void DraftStep::draw_row(const PanelContext& context, std::size_t number, bool marked) const {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const WallDraft& wall = check()->walls[number];
  const bool here = state.face && state.face->number == wall.face;
  const std::string id = fmt::format("wall {}", number + 1);
  const Row row = list_row(ui, {.id = id.c_str(), .height = k_two_lines, .chosen = here, .marked = marked});
  const FigureStyle style(*state.model);
  const std::string face =
      state.model->part.has_cad_faces ? fmt::format(", face {}", grouped(std::to_string(wall.face))) : "";
  draw_two_lines(
      ui, row.box,
      {.number = std::to_string(number + 1),
       .name =
           fmt::format("{}{} · {}", side_name(wall.side), face, style.with_unit(FigureKind::area, wall.area)),
       .figure = draft_text(wall.least_deg),
       .below = fmt::format("turn {:.2f}° · takes {}", wall.turn_deg,
                            style.with_unit(FigureKind::length, wall.thickness)),
       .colour = faded(wall.least_deg < -k_draft_rounding_deg ? ui.colours->warning : ui.colours->text,
                       state.mold.line_awaited ? 0.75F : 1.0F),
       .below_colour = ui.colours->muted});
  tooltip(ui, fmt::format("Wall {} of the {}", number + 1, side_name(wall.side)),
          fmt::format("{}{}\nClick to look at it.", suggestion(*state.model, wall),
                      wall.foot_line ? "" : "\nThe foot of the wall is bent: another shape may need less."));
  if (row.clicked) context.edits.ask(&Commands::look_at_wall, number);
}

void draw_foot_line(const PanelContext& context) {
  const AppState& state = context.state;
  if (state.settings.look.colour_mode != ColourMode::draft_angle || !has_mold(state)) return;
  const WallDraft* wall = nullptr;
  if (state.hover) wall = wall_of_face(state, state.faces->of_facet[state.hover->point.facet]);
  if (wall == nullptr && state.face) wall = wall_of_face(state, state.face->number);
  if (wall == nullptr || !wall->foot_line) return;
  const glm::ivec2 size(ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y);
  std::array<glm::vec2, 2> ends{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto pixel =
        project(state.camera, size, glm::dvec3(state.model->frame.to_unit((*wall->foot_line)[k])));
    if (!pixel) return;
    ends[k] = glm::vec2(*pixel);
  }
  const Ui& ui = context.ui;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddLine(im(ends[0]), im(ends[1]), packed(k_block_mark), 3.0F * ui.scale);
  if (glm::distance(ends[0], ends[1]) > tag_size(ui, "foot").x)
    draw_tag(ui, 0.5F * (ends[0] + ends[1]), "foot", ui.colours->text);
}

}  // namespace moldlight::gui
