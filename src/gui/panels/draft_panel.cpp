#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/step_panels.hpp"
#include "parting/draft/draft_check.hpp"
#include "render/view_settings.hpp"

namespace moldlight::gui {

namespace {

// Layout units.
constexpr float k_draft_row = 40.0F, k_chart = 96.0F, k_axis = 18.0F, k_grip = 14.0F;
constexpr float k_draft_share = 0.36F;    // of the window's height, that the table takes at most
constexpr float k_finishes_share = 0.2F;  // and that of the finishes
constexpr double k_step_deg = 0.1;

constexpr std::array<ListColumn, 4> k_draft_columns = {{
    {"#", "Walls that cost the most thickness come first.", 8.0F, false},
    {"formed by", "The half that forms the wall.", 36.0F, false},
    {"draft", "Least draft of the wall. Negative: reverse draft.", 150.0F, true},
    {"costs", "Change of thickness at the far end if the wall turns about its foot.", 228.0F,
     true},  // beside a scroll bar
}};

constexpr std::array<ListColumn, 3> k_finish_columns = {{
    {"finish", "Walls of the finish that asks for most draft come first.", 8.0F, false},
    {"faces", "", 164.0F, true},
    {"required", "Least draft that the finish asks for.", 214.0F, true},
}};
constexpr float k_beside_finish = 26.0F;  // layout units

/// What a click on the part gives: a chip a finish, and the figure that it needs.
void draw_finish_choice(const PanelContext& context) {
  const Ui& ui = context.ui;
  DraftChoices& choices = context.edits.draft_choices;
  RequiredDraft& draft = context.edits.settings.required_draft;
  const auto offer = [&](std::string_view kind, const std::string& says) {
    const bool on = choices.kind == kind;
    if (chip(ui, kind, on, kind == "polished")) choices.kind = on ? std::string() : std::string(kind);
    name_item(ui, fmt::format("finish {}", kind));
    tooltip(ui, fmt::format("Finish: {}", kind), says + "\nThen click faces. A second click takes it away.");
  };
  hint(ui, "Finish of faces");
  for (const NamedFinish& named : k_named_finishes)
    offer(named.name, named.required_deg > 0.0
                          ? fmt::format("Needs {}° of draft.", figure(named.required_deg))
                          : "Draft of the face is not checked.");
  offer("texture", "Needs draft by its depth.");
  offer("draft", "Needs the angle that you set.");
  if (choices.kind == "texture") {
    if (double depth = choices.texture_mm;
        number_field(ui, "texture depth", depth, {"Depth, mm", 3, room_left()}) && depth > 0.0)
      choices.texture_mm = depth;
    if (option_row(ui, finish_options().front(), static_cast<FinishSettings&>(draft)))
      for (FaceFinish& one : draft.finishes)
        one.finish = parse_finish(one.finish.name, draft.texture_rule).value_or(one.finish);
  } else if (choices.kind == "draft") {
    if (double angle = choices.draft_deg;
        number_field(ui, "finish draft", angle, {"Draft °", 2, room_left()}) && angle > 0.0)
      choices.draft_deg = std::min(angle, k_most_required_deg);
  }
  const float width = 0.5F * (room_left() - ui.px(4));
  if (button(ui, "Load…", {.width = width})) context.edits.dialogs.finishes = false;
  name_item(ui, "load finishes");
  tooltip(ui, "Load the finishes", "A file with a line a face, FACE,FINISH, as the flag --finish reads it.");
  ImGui::SameLine(0.0F, ui.px(4));
  ImGui::BeginDisabled(draft.finishes.empty());
  if (button(ui, "Save…", {.width = width})) context.edits.dialogs.finishes = true;
  ImGui::EndDisabled();
  name_item(ui, "save finishes");
  tooltip(ui, "Save the finishes", "Into a file that the flag --finish reads.");
}

/// A finish that faces have: a click looks at its worst wall, the cross takes it from all of them.
void draw_finish_row(const PanelContext& context, const FinishDraft& one, std::size_t number, bool marked) {
  const Ui& ui = context.ui;
  const std::string id = fmt::format("finish row {}", number + 1);
  const glm::vec2 start = cursor_at();
  const float width = room_left();
  const Row row = list_row(ui, {.id = id.c_str(),
                                .height = k_draft_row,
                                .beside = k_beside_finish,
                                .chosen = false,
                                .marked = marked});
  const ScreenBox upper{row.box.min, {row.box.max.x, row.box.min.y + ui.px(22)}};
  const std::array<std::string, k_finish_columns.size()> texts = {
      one.finish.name, std::to_string(one.faces),
      one.finish.required_deg > 0.0 ? fmt::format("{}°", figure(one.finish.required_deg)) : "none"};
  for (std::size_t k = 0; k < texts.size(); ++k)
    draw_cell(ui, upper, k_finish_columns[k], {k == 0 ? ui.fonts.strong : ui.fonts.body, ui.colours->text},
              texts[k], k == 0 ? ui.px(120) : 0.0F);
  const std::string unit = powered_unit(context.state.model->part, 2);
  const std::string area = grouped(rounded(one.area)) + " " + unit;
  draw_second_line(ui, row.box, k_finish_columns[0].at,
                   one.below > 0.0 ? fmt::format("{} of {} have less", rounded(one.below), area) : area,
                   k_beside_finish);
  tooltip(ui, one.finish.name,
          fmt::format("{}\nClick to look at {}.",
                      one.least_deg ? fmt::format("Least draft {}.", draft_text(*one.least_deg))
                                    : std::string("Side actions form all of its faces."),
                      one.below > 0.0 ? "the wall that costs the most" : "its faces"));
  if (row.clicked) context.edits.ask(&Commands::look_at_finish, one.finish.name);
  put_cursor({start.x + width - ui.px(k_row_height), start.y + ui.px(0.5F * (k_draft_row - k_row_height))});
  const std::string cross = fmt::format("take finish {}", number + 1);
  if (icon_button(ui, {cross.c_str(), Icon::close, "Take it from its faces"}))
    std::erase_if(context.edits.settings.required_draft.finishes,
                  [&](const FaceFinish& each) { return each.finish == one.finish; });
  put_cursor({start.x, start.y + ui.px(k_draft_row)});
}

void draw_bars(const PanelContext& context, const DraftChart& chart, const DraftCheck& check) {
  const Ui& ui = context.ui;
  ImDrawList& list = window_list();
  const double tallest = tallest_bin(check, DraftChart::k_from_deg, DraftChart::k_to_deg);
  const float gap = 0.5F * ui.scale, height = chart.box.max.y - chart.box.min.y;
  for (const DraftBin& bin : check.histogram) {
    if (!bin.within(DraftChart::k_from_deg, DraftChart::k_to_deg) || tallest <= 0.0) continue;
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

void describe_bin(const PanelContext& context, const DraftChart& chart, const DraftCheck& check) {
  const double draft = chart.draft_at(ImGui::GetIO().MousePos.x);
  const auto bin = std::ranges::find_if(
      check.histogram, [&](const DraftBin& each) { return draft >= each.from_deg && draft < each.to_deg; });
  if (bin == check.histogram.end()) return;
  const FigureStyle style(*context.state.model);
  tooltip(context.ui, with_minus(fmt::format("{}° to {}°", bin->from_deg, bin->to_deg)),
          fmt::format("core {}\ncavity {}", grouped(style.with_unit(FigureKind::area, bin->area[0])),
                      grouped(style.with_unit(FigureKind::area, bin->area[1]))));
}

/// The limit of what is required, which a hand may drag; true where the mouse is on it.
bool draw_limit(const PanelContext& context, const DraftChart& chart) {
  const Ui& ui = context.ui;
  double& required = context.edits.settings.required_draft.deg;
  const float x = chart.place_of(required), half = 0.5F * ui.px(k_grip);
  put_cursor({x - half, chart.box.min.y});
  const Pressable grip = pressable(ui, "draft limit", {2.0F * half, chart.box.max.y - chart.box.min.y});
  if (grip.active) {
    const double draft = chart.draft_at(ImGui::GetIO().MousePos.x);
    required = std::max(k_step_deg, k_step_deg * std::round(draft / k_step_deg));
  }
  const bool lively = grip.hovered || grip.active;
  ImDrawList& list = window_list();
  list.AddLine(ImVec2(x, chart.box.min.y), ImVec2(x, chart.box.max.y),
               lively ? ui.colours->accent : ui.colours->text, (lively ? 2.0F : 1.5F) * ui.scale);
  list.AddCircleFilled(ImVec2(x, chart.box.min.y), ui.px(lively ? 4.0F : 3.0F),
                       lively ? ui.colours->accent : ui.colours->text);
  if (!grip.active) tooltip(ui, "Required draft", "Drag to change the required draft.");
  return lively;
}

void draw_chart(const PanelContext& context, const DraftCheck& check) {
  const Ui& ui = context.ui;
  const glm::vec2 start = cursor_at();
  const float width = room_left();
  const glm::vec2 inset(ui.px(8), ui.px(4));
  const DraftChart chart{{start + inset, {start.x + width - inset.x, start.y + ui.px(k_chart)}}};
  ui.memory->controls["draft chart"] = chart.box;
  ImDrawList& list = window_list();
  const float foot = chart.box.max.y;
  draw_bars(context, chart, check);
  list.AddLine(ImVec2(chart.box.min.x, foot), ImVec2(chart.box.max.x, foot), ui.colours->line);
  for (const int draft : {-5, 0, 5, 10}) {
    const std::string text = with_minus(fmt::format("{}°", draft));
    const float size = text_size(ui.fonts.small, text).x;
    const float left = std::clamp(chart.place_of(draft) - 0.5F * size, start.x, start.x + width - size);
    draw_text(list, ui.note(), {left, foot + ui.px(3)}, text);
  }
  const bool at_limit = draw_limit(context, chart);
  put_cursor(start);
  ImGui::Dummy(ImVec2(width, ui.px(k_chart)));
  if (ImGui::IsItemHovered() && !at_limit && !ImGui::IsAnyItemActive()) describe_bin(context, chart, check);
  put_cursor({start.x, start.y + ui.px(k_chart + k_axis)});
}

}  // namespace

const WallDraft* wall_of_face(const AppState& state, std::uint32_t face, std::optional<MoldSide> side) {
  const auto& line = state.mold.line;
  if (!line || !line->draft) return nullptr;
  const auto found = std::ranges::find_if(line->draft->walls, [&](const WallDraft& wall) {
    return wall.face == face && (!side || wall.side == *side);
  });
  return found == line->draft->walls.end() ? nullptr : &*found;
}

void DraftPanel::draw(const PanelContext& context) {
  if (context.state.mold.line || context.state.model != model_) {
    line_ = context.state.mold.line;
    model_ = context.state.model;
  }
  option_row(context.ui, required_draft_options().front(), context.edits.settings.required_draft);
  draw_finish_choice(context);
  if (context.state.settings.look.colour_mode == ColourMode::draft_angle) draw_draft_key(context);
  TableBarParts parts{.news = news(context.state)};
  if (check() != nullptr) {
    parts.table = [&](RowCursor& cursor) {
      draw_chart(context, *check());
      if (!check()->finishes.empty()) draw_finishes(context);
      if (!check()->walls.empty()) draw_walls(context, cursor);
    };
  }
  bar_.draw_inside(context, parts);
}

BarNews DraftPanel::news(const AppState& state) const {
  const MoldState& mold = state.mold;
  BarNews news{.text = "No draft is required."};
  if (mold.line_awaited) {
    news = {.text = "finding the parting line …", .progress = -1.0};
  } else if (!mold.error.empty()) {
    news = {.text = mold.error, .warning = true};
  }
  if (check() != nullptr) news.text = sentence_of(draft_sentence(*state.model, *check()));
  news.tip = news.text;
  return news;
}

void DraftPanel::draw_finishes(const PanelContext& context) {
  const std::vector<FinishDraft>& finishes = check()->finishes;
  draw_headings(context.ui, k_finish_columns);
  const RowList list{
      .id = "finishes", .count = finishes.size(), .row_height = k_draft_row, .share = k_finishes_share};
  if (const auto pressed = draw_list(context.ui, list, finish_cursor_, [&](std::size_t k) {
        draw_finish_row(context, finishes[k], k, finish_cursor_.is_at(k));
      }))
    context.edits.ask(&Commands::look_at_finish, finishes[*pressed].finish.name);
}

void DraftPanel::draw_walls(const PanelContext& context, RowCursor& cursor) const {
  draw_headings(context.ui, k_draft_columns);
  const RowList walls{
      .id = "walls", .count = check()->walls.size(), .row_height = k_draft_row, .share = k_draft_share};
  if (const auto pressed =
          draw_list(context.ui, walls, cursor, [&](std::size_t k) { draw_row(context, k, cursor.is_at(k)); }))
    context.edits.ask(&Commands::look_at_wall, *pressed);
}

void DraftPanel::draw_row(const PanelContext& context, std::size_t number, bool marked) const {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const WallDraft& wall = check()->walls[number];
  const bool here = state.face && state.face->number == wall.face;
  const std::string id = fmt::format("wall {}", number + 1);
  const Row row = list_row(ui, {.id = id.c_str(), .height = k_draft_row, .chosen = here, .marked = marked});
  const std::string unit = length_unit(state.model->part);
  const std::array<std::string, k_draft_columns.size()> texts = {
      std::to_string(number + 1), std::string(side_name(wall.side)), draft_text(wall.least_deg),
      grouped(rounded(wall.thickness)) + " " + unit};
  const ImU32 normal = faded(ui.colours->text, state.mold.line_awaited ? 0.75F : 1.0F);
  const ScreenBox upper{row.box.min, {row.box.max.x, row.box.min.y + ui.px(22)}};
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const bool leans = k == 2 && wall.least_deg < -k_draft_rounding_deg;
    draw_cell(ui, upper, k_draft_columns[k],
              {k == 0 ? ui.fonts.strong : ui.fonts.body, leans ? ui.colours->warning : normal}, texts[k]);
  }
  draw_second_line(ui, row.box, 24.0F,
                   fmt::format("{} · {} {} high · turn {:.3g}°", area_with_unit(*state.model, wall.area),
                               rounded(wall.height), unit, wall.turn_deg));
  tooltip(ui, fmt::format("Face {} of the {}", wall.face, side_name(wall.side)),
          fmt::format("{}{}\nClick to look at it.", suggestion(*state.model, wall),
                      wall.foot_line ? "" : "\nThe foot of the wall is bent: another shape may need less."));
  if (row.clicked) context.edits.ask(&Commands::look_at_wall, number);
}

void draw_draft_marks(const PanelContext& context) {
  const AppState& state = context.state;
  if (!is_at(state, Step::draft)) return;
  if (!state.draft_choices.kind.empty()) {
    const FreeArea area = context.free_area();
    draw_tag(context.ui, {area.middle_x(), static_cast<float>(area.min.y) + context.ui.px(24)},
             "Click faces: " + state.draft_choices.finish(), context.ui.colours->text);
  }
  const WallDraft* wall = nullptr;
  if (state.hover) wall = wall_of_face(state, state.faces->of_facet[state.hover->point.facet]);
  if (wall == nullptr && state.face) wall = wall_of_face(state, state.face->number);
  if (wall == nullptr || !wall->foot_line) return;
  const glm::ivec2 size(screen_size());
  std::array<glm::vec2, 2> ends{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto pixel =
        project(state.camera, size, glm::dvec3(state.model->frame.to_unit((*wall->foot_line)[k])));
    if (!pixel) return;
    ends[k] = glm::vec2(*pixel);
  }
  const Ui& ui = context.ui;
  ImDrawList& list = scene_list();
  list.AddLine(ends[0], ends[1], packed(k_block_mark), 3.0F * ui.scale);
  if (glm::distance(ends[0], ends[1]) > tag_size(ui, "foot").x)
    draw_tag(ui, 0.5F * (ends[0] + ends[1]), "foot", ui.colours->text);
}

}  // namespace moldlight::gui
