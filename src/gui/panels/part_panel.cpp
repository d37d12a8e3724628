// The part: what the file has, its unit, the body that is molded, and the tolerances of its regions.

#include <fmt/format.h>
#include <glm/common.hpp>

#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/table_bar.hpp"

namespace moldlight::gui {

namespace {

/// The unit that the part has; choosing one names or converts it, a reset leaves it to the file.
void draw_unit(const PanelContext& context) {
  const Option<ReadOptions>& option = option_named(reading_options(), "unit");
  const Words& words = std::get<TextKind<ReadOptions>>(option.kind).words;
  std::string& wanted = context.edits.reading.unit;
  const std::string chosen = wanted, as_in_the_file;
  int index = static_cast<int>(std::ranges::find(words, context.state.model->part.unit) - words.begin());
  if (choice(context.ui, {option.label, !chosen.empty()}, words, index))
    wanted = words[static_cast<std::size_t>(index)];
  if (option_menu(context.ui, {option.label, option.help, chosen, as_in_the_file})) wanted.clear();
}

constexpr float k_body_row = 44.0F, k_branch = 14.0F, k_eye = 26.0F;  // layout units
constexpr float k_bodies_share = 0.36F;                               // of the window's height, at most

/// The name that the file gives it, or its number.
std::string body_name(const Body& body, std::size_t number) {
  return body.name.empty() ? fmt::format("Body {}", number + 1) : body.name;
}

/// What it comes to, in as few words as there is room for.
std::string verdict_words(const Verdict& verdict, const Part& part) {
  if (verdict.state == VerdictState::two_plate) return "two-plate mold";
  if (verdict.state == VerdictState::side_actions) return actions_text(verdict.actions);
  if (verdict.state == VerdictState::unknown) return "not decided";
  return fmt::format("{} {} not released", rounded(verdict.unreleased_area), powered_unit(part, 2));
}

/// A leaf of the file's tree: picture, name and verdict, and whether it is seen.
void draw_body(const PanelContext& context, const PictureOf& pictures, std::size_t k, const ScreenBox& row) {
  const Ui& ui = context.ui;
  const BodiesState& bodies = context.state.bodies;
  const Body& body = bodies.whole->model->part.bodies[k];
  std::set<std::size_t>& hidden = context.edits.hidden_bodies;
  const bool all = context.state.reading.body == "all", seen = !hidden.contains(k);
  const bool last = k + 1 == bodies.verdicts.size();
  ImDrawList& list = window_list();
  const float stem = row.min.x + ui.px(6), middle = row.centre().y;
  list.AddLine({stem, row.min.y}, {stem, last ? middle : row.max.y}, ui.colours->line);
  list.AddLine({stem, middle}, {stem + ui.px(5), middle}, ui.colours->line);
  const glm::vec2 size(ui.px(48), ui.px(36)), corner(row.min.x + ui.px(k_branch), middle - 0.5F * size.y);
  draw_picture(list, pictures(k), {corner, corner + size}, ui.px(4));
  const float left = corner.x + size.x + ui.px(6), room = row.max.x - left - ui.px(all ? k_eye + 6 : 8);
  const std::string name = body_name(body, k);
  draw_text(list, {ui.fonts.body, seen ? ui.colours->text : ui.colours->muted}, {left, row.min.y + ui.px(5)},
            fitted(ui.fonts.body, name, room));
  const auto& verdict = bodies.verdicts[k];
  const VerdictLight light = verdict ? light_of(verdict->state) : VerdictLight::gray;
  list.AddCircleFilled({left + ui.px(4), row.max.y - ui.px(13)}, ui.px(4), light_colour(light));
  draw_text(list, ui.note(), {left + ui.px(13), row.max.y - ui.px(7) - ui.fonts.small.size},
            fitted(ui.fonts.small, verdict ? verdict_words(*verdict, bodies.whole->model->part) : "…",
                   room - ui.px(13)));
  tooltip(ui, fmt::format("{}, {} facets", name, grouped(std::to_string(body.facet_count))),
          verdict ? verdict->sentence : "The verdict on this body alone is being found.");
  if (!all) return;
  put_cursor({row.max.x - ui.px(k_eye), middle - 0.5F * ui.px(k_row_height)});
  if (icon_button(ui, {fmt::format("hide {}", k + 1).c_str(), seen ? Icon::eye : Icon::close,
                       seen ? "Hide it in the picture" : "Show it"})) {
    if (seen)
      hidden.insert(k);
    else
      hidden.erase(k);
  }
}

/// The file with its bodies, as a tree.
void draw_bodies(const PanelContext& context, RowCursor& cursor, const PictureOf& pictures) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  Edits& edits = context.edits;
  const std::size_t count = state.bodies.whole ? state.bodies.verdicts.size() : 0;
  if (count == 0) {
    const bool one = state.model->part.chosen_body > 0;
    if (one && button(ui, "All bodies of the file", {.width = room_left()})) edits.reading.body = "all";
    return;
  }
  const bool all = state.reading.body == "all";
  const Row root = list_row(ui, {.id = "all bodies", .height = k_row_height, .chosen = all && !edits.body});
  draw_text(ui.text(), {root.box.min.x + ui.px(4), root.box.centre().y - 0.5F * ui.fonts.body.size},
            fmt::format("All {} bodies as one part", count));
  put_cursor({root.box.min.x, root.box.max.y});
  if (root.clicked) {
    edits.reading.body = "all";
    edits.body.reset();
    if (all) edits.ask(&Commands::fit_view);
  }
  const ChoiceTable table{
      .list = {.id = "bodies", .count = count, .row_height = k_body_row, .share = k_bodies_share},
      .row = "body",
      .chosen = edits.body,
      .look = &Commands::look_at_body,
      .beside = all ? k_eye : 0.0F};
  draw_choices(context, table, cursor,
               [&](std::size_t k, const ScreenBox& row) { draw_body(context, pictures, k, row); });
  if (!all) return;
  const float half = std::floor(0.5F * (room_left() - ui.px(4)));
  ImGui::BeginDisabled(!edits.body);
  if (button(ui, "Mold this one", {.width = half, .strong = edits.body.has_value()}))
    edits.reading.body = std::to_string(*edits.body + 1);
  ImGui::EndDisabled();
  ImGui::SameLine(0.0F, ui.px(4));
  const bool hidden = !edits.hidden_bodies.empty();
  ImGui::BeginDisabled(!hidden && !edits.body);
  if (button(ui, hidden ? "Show all" : "Isolate", {.width = half})) {
    if (hidden)
      edits.hidden_bodies.clear();
    else
      edits.ask(&Commands::isolate_body, *edits.body);
  }
  ImGui::EndDisabled();
}

}  // namespace

void draw_part_controls(const PanelContext& context, RowCursor& cursor, const PictureOf& bodies) {
  const Ui& ui = context.ui;
  const PartModel& model = *context.state.model;
  glm::vec3 least(0.0F), most(0.0F);
  for (const glm::vec3& point : context.state.extremes) {
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
  const glm::dvec3 size = model.frame.diagonal * glm::dvec3(most - least);
  hint(ui, fmt::format("{} facets · {} × {} × {} {}", grouped(std::to_string(model.part.mesh.facets.size())),
                       rounded(size.x), rounded(size.y), rounded(size.z), length_unit(model.part)));
  for (const std::string& repair : model.part.repairs) hint(ui, repair);
  for (const std::string& warning : model.warnings) {
    const glm::vec2 at = cursor_at();
    draw_icon(window_list(), Icon::alert, at + glm::vec2(ui.px(6), ui.px(8)), ui.px(12), ui.colours->warning);
    ImGui::Indent(ui.px(18));
    hint(ui, warning);
    ImGui::Unindent(ui.px(18));
  }
  ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
  draw_unit(context);
  draw_bodies(context, cursor, bodies);
  option_row(ui, option_named(reading_options(), "repair"), context.edits.reading);
  MethodSettings& method = context.edits.settings.method;
  const PartLengths lengths(context.state);
  option_row(ui, option_named(method_options(), "tau_deg"), method);
  option_row(
      ui, option_named(method_options(), "tolerance"), method,
      {.lengths = &lengths, .unset = fmt::format("{:.3g}", lateral_tolerance(method, lengths.diagonal))});
}

}  // namespace moldlight::gui
