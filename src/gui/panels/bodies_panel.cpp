// The bodies of the file: a tree of which one is chosen, and along the bottom the verdict on each as a table.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/shown_text.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/step_panels.hpp"

namespace moldlight::gui {

namespace {

// Layout units.
constexpr float k_body_row = 44.0F, k_branch = 14.0F, k_eye = 26.0F, k_verdict_row = 42.0F, k_picture = 60.0F;
constexpr float k_bodies_share = 0.36F;  // of the window's height, at most

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

void choose(const PanelContext& context, std::size_t body) {
  context.edits.body = body;
  context.edits.ask(&Commands::look_at_body, body);
}

}  // namespace

void BodiesPanel::draw(const PanelContext& context, const PictureOf& pictures) {
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
  draw_choices(context, table, tree_,
               [&](std::size_t k, const ScreenBox& row) { draw_body(context, pictures, k, row); });
  if (disclosure(ui, "All verdicts", table_shown_)) {
    table_shown_ = !table_shown_;
    context.layout.fold_bottom("Bodies", false);
  }
  name_item(ui, "All verdicts");
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

std::vector<std::size_t> sorted_bodies(const BodiesState& bodies, const BodyOrder& order) {
  using By = BodyOrder::By;
  const std::vector<Body>& all = bodies.whole->model->part.bodies;
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto& verdict = bodies.verdicts[k];
    if (has_words(body_name(all[k], k) + " " + (verdict ? verdict->sentence : ""), order.words))
      rows.push_back(k);
  }
  const auto figure = [&](std::size_t k) -> std::optional<double> {
    if (order.by == By::facets) return static_cast<double>(all[k].facet_count);
    const auto& verdict = bodies.verdicts[k];
    if (!verdict) return std::nullopt;
    if (order.by == By::verdict) return static_cast<double>(verdict->state);
    return order.by == By::undercut ? verdict->undercut_area : verdict->unreleased_area;
  };
  std::ranges::stable_sort(rows, [&](std::size_t a, std::size_t b) {
    if (order.by == By::name) {
      const std::string x = body_name(all[a], a), y = body_name(all[b], b);
      return order.descending ? y < x : x < y;
    }
    const auto x = figure(a), y = figure(b);
    if (!x || !y) return x.has_value() && !y.has_value();
    return order.descending ? *x > *y : *x < *y;
  });
  return rows;
}

void BodiesPanel::draw_below(const PanelContext& context, const PictureOf& pictures) {
  constexpr float k_table_share = 0.22F;  // of the window's height
  // By BodyOrder::By.
  static const std::vector<SortedColumn> k_columns = {
      {.name = "body", .figure = false, .most_first = false, .share = 0.3F},
      {.name = "verdict", .figure = false, .share = 0.7F},
      {.name = "undercut", .width = 96.0F},
      {.name = "not released", .width = 96.0F},
      {.name = "facets", .width = 80.0F}};
  const Ui& ui = context.ui;
  const BodiesState& bodies = context.state.bodies;
  if (!bodies.whole) table_shown_ = false;
  if (!table_shown_) return;
  if (context.layout.begin_bottom(ui, "Bodies")) {
    const auto known =
        std::ranges::count_if(bodies.verdicts, [](const auto& one) { return one.has_value(); });
    const auto count = static_cast<std::ptrdiff_t>(bodies.verdicts.size());
    BottomHeader header(ui, "Bodies");
    if (header.button({"close bodies", Icon::close, "Close"})) table_shown_ = false;
    table_.draw_filter(ui, header, "body rows", {.hint = "name or verdict"});
    header.end(known < count
                   ? fmt::format("{} of {} verdicts", known, count)
                   : fmt::format("{} bodies, areas in {}", count, powered_unit(bodies.whole->model->part, 2)),
               ui.colours->muted);
    const bool asked = table_.draw_headings(ui, k_columns, k_picture);
    if (asked || std::exchange(known_, known) != known || table_.rows.size() > bodies.verdicts.size()) {
      const auto by = std::ranges::find(k_columns, table_.by(), &SortedColumn::name);
      table_.rows = sorted_bodies(bodies, {.by = static_cast<BodyOrder::By>(by - k_columns.begin()),
                                           .descending = table_.descending(),
                                           .words = table_.filter()});
    }
    if (table_.rows.empty()) hint(ui, "No body matches these words.");
    const auto at = table_.cursor.row();
    draw_list(
        ui,
        {.id = "body rows", .count = table_.rows.size(), .row_height = k_verdict_row, .share = k_table_share},
        table_.cursor, [&](std::size_t k) { draw_row(context, pictures, k); });
    // The arrow keys go from body to body.
    const auto now = table_.cursor.row();
    if (now && now != at && *now < table_.rows.size()) choose(context, table_.rows[*now]);
  } else {
    table_shown_ = false;  // another one was unfolded
  }
  context.layout.end();
}

void BodiesPanel::draw_row(const PanelContext& context, const PictureOf& pictures, std::size_t place) {
  constexpr float k_light = 14.0F;
  const Ui& ui = context.ui;
  const BodiesState& bodies = context.state.bodies;
  const std::size_t k = table_.rows[place];
  const Part& part = bodies.whole->model->part;
  const auto& verdict = bodies.verdicts[k];
  const std::string id = fmt::format("body row {}", k + 1);
  const Row row = list_row(ui, {.id = id.c_str(),
                                .height = k_verdict_row,
                                .chosen = context.edits.body == k,
                                .marked = table_.cursor.is_at(place)});
  ImDrawList& list = window_list();
  const glm::vec2 corner = row.box.min + glm::vec2(ui.px(4), ui.px(2));
  draw_picture(list, pictures(k), {corner, corner + glm::vec2(ui.px(50), ui.px(38))}, ui.px(4));
  const glm::vec2 dot(row.box.min.x + table_.begin_of(1) + ui.px(4), row.box.centre().y);
  list.AddCircleFilled(dot, ui.px(4), light_colour(verdict ? light_of(verdict->state) : VerdictLight::gray));
  const auto cell = [&](std::size_t column, const std::string& text, float mark = 0.0F) {
    table_.draw_cell(ui, row.box, column, ui.text(), text, mark);
  };
  cell(0, body_name(part.bodies[k], k));
  cell(1, verdict ? verdict->sentence : "…", k_light);
  cell(2, verdict ? grouped(rounded(verdict->undercut_area)) : "");
  cell(3, verdict ? grouped(rounded(verdict->unreleased_area)) : "");
  cell(4, grouped(std::to_string(part.bodies[k].facet_count)));
  put_cursor({row.box.min.x, row.box.max.y});
  if (row.clicked) choose(context, k);
}

}  // namespace moldlight::gui
