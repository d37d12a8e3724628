// The verdict's card: its light, sentence and button, and the legend with the four regions with their
// measured areas, how sure they are, and whether two ways agree.
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "classify/figure_table.hpp"
#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "classify/option.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_legend_row = 24.0F;

void draw_swatch(const Ui& ui, Region region, const LookSettings& look, const glm::vec2& min) {
  ImDrawList& list = window_list();
  const float size = ui.px(12);
  const glm::vec2 max = min + glm::vec2(size);
  fill(list, {min, max}, packed(region_colour(region, look.palette)), ui.px(3));
  if (region != Region::undercut || !look.hatching) return;
  list.PushClipRect(min, max, true);
  for (float offset = -size; offset < size; offset += ui.px(5)) {
    list.AddLine(ImVec2(min.x + offset, max.y), ImVec2(min.x + offset + size, min.y), IM_COL32(0, 0, 0, 110),
                 1.5F * ui.scale);
  }
  list.PopClipRect();
}

/// What was measured.
struct Legend {
  const PartModel& model;
  const Classification& result;
  float alpha = 1.0F;

  [[nodiscard]] std::string area(double area) const { return area_with_unit(model, area); }
};

/// Of a line "name … value unit": its corner, and where its texts end and begin.
struct Line {
  glm::vec2 min{0.0F};
  float right = 0.0F, top = 0.0F;
  bool pressed = false;  // with the keyboard
};

/// Lights what a line speaks of while the mouse or the keyboard is on it.
void light(const PanelContext& context, const Pressable& line, const Subject& subject) {
  if (line.hovered || line.focused) context.edits.lit = subject;
}

Pressable line_place(const Ui& ui, const char* id) {
  return pressable(ui, id, {room_left(), ui.px(k_legend_row)});
}

/// Leaves a place in front for a mark.
Line begin_line(const Ui& ui, const Pressable& row, std::string_view name, ImU32 colour) {
  const auto& [min, max] = row.box;
  ImDrawList& list = window_list();
  if (row.hovered) fill(list, {min, max}, ui.colours->field, ui.px(6));
  const float top = 0.5F * (min.y + max.y - ui.fonts.body.size);
  draw_text(list, {ui.fonts.body, colour}, {min.x + ui.px(26), top}, name);
  return {min, max.x - ui.px(6), top, row.pressed};
}

void draw_region(const PanelContext& context, const Legend& legend, Region region) {
  const Ui& ui = context.ui;
  const double area = legend.result.areas[region];
  const std::string name(region_name(region));
  const Pressable row = line_place(ui, name.c_str());
  const Subject subject{.region = region};
  light(context, row, subject);
  if (row.clicked && !row.pressed) context.edits.ask(&Commands::look_at_subject, subject);
  const Line line = begin_line(ui, row, facts(region).title, ui.colours->text);
  draw_swatch(ui, region, context.state.settings.look, line.min + glm::vec2(ui.px(6), ui.px(6)));
  const ImU32 strong = faded(ui.colours->text, legend.alpha), quiet = faded(ui.colours->muted, legend.alpha);
  draw_text_to({ui.fonts.strong, strong}, line.right, line.top,
               fmt::format("{:.1f} %", 100.0 * share(area, legend.result.total_area)));
  draw_text_to({ui.fonts.body, quiet}, line.right - ui.px(60), line.top, legend.area(area));
  tooltip(ui, facts(region).title, fmt::format("{}\n{}", facts(region).meaning, legend.area(area)));
  copy_menu(ui, name.c_str(), real_text(area), line.pressed);
}

void draw_total(const PanelContext& context, const Legend& legend) {
  const Ui& ui = context.ui;
  const glm::vec2 at = cursor_at();
  ImGui::Dummy(ImVec2(1.0F, ui.px(3)));
  window_list().AddLine(ImVec2(at.x, at.y + ui.px(1)), ImVec2(at.x + room_left(), at.y + ui.px(1)),
                        ui.colours->line);
  const Line line = begin_line(ui, line_place(ui, "total"), "Total", ui.colours->muted);
  draw_text_to(ui.muted(), line.right - ui.px(60), line.top, legend.area(legend.result.total_area));
  copy_menu(ui, "total", real_text(legend.result.total_area), line.pressed);
}

/// How far the figures may be trusted: the row says no more than that the check passed, unless something is
/// in doubt. Rounding is nothing to show.
void draw_trust(const PanelContext& context, const Legend& legend) {
  const Ui& ui = context.ui;
  const UndercutUncertainty& doubt = legend.result.uncertainty;
  const ShadowIdentity& shadow = legend.result.identity;
  const double visible = doubt.mesh + doubt.readout;
  const bool in_doubt = visible > 1e-6 * legend.result.total_area;  // else four digits do not show it
  const bool fine = shadow.agrees() && !(in_doubt && doubt.mesh > 0.0);
  const std::string_view name = in_doubt ? "Undercut ±" : shadow.agrees() ? "Areas checked" : "Check failed";
  const Line line =
      begin_line(ui, line_place(ui, "trust"), name, fine ? ui.colours->muted : ui.colours->warning);
  if (!fine || verdict_card(context.state).good())  // no tick beside red
    draw_icon(window_list(), fine ? Icon::check : Icon::alert, line.min + glm::vec2(ui.px(12), ui.px(12)),
              ui.px(12), faded(fine ? ui.colours->text : ui.colours->warning, legend.alpha));
  if (in_doubt)
    draw_text_to({ui.fonts.body, faded(ui.colours->text, legend.alpha)}, line.right - ui.px(60), line.top,
                 legend.area(visible));
  std::string text =
      fmt::format("Area of the part's shadow, computed in two ways: {} along +d, {} along −d. {}",
                  legend.area(shadow.core), legend.area(shadow.cavity),
                  shadow.agrees() ? "They agree." : "They differ: the mesh is open or its winding is wrong.");
  if (doubt.mesh > 0.0)
    text += fmt::format("\nFaults of the mesh leave {} of the undercut in doubt.", legend.area(doubt.mesh));
  if (doubt.readout > 0.0)
    text += fmt::format("\nThe undercut of the readout is {} off the exact one.", legend.area(doubt.readout));
  tooltip(ui, "Accuracy of the figures", text);
  copy_menu(ui, "trust", real_text(visible), line.pressed);
}

/// What there is to see of a verdict beside its sentence: a line each, lit on the part while the mouse is on
/// it.
struct SubjectLine {
  Subject::Of of;
  const char* id;
  std::string name, figure;
  bool doubt = false;  // of the mesh
};

std::vector<SubjectLine> subject_lines(const AppState& state) {
  using Of = Subject::Of;
  std::vector<SubjectLine> lines;
  const Verdict& verdict = *state.verdict;
  const HealthReport& health = state.model->health;
  const Classification& here = *state.figures.shown;
  const auto area = [&](double value) { return area_with_unit(*state.model, value); };
  const auto count = [](std::size_t number) { return grouped(std::to_string(number)); };
  if (state.actions.plan && !state.actions.plan->unreleased.empty())
    lines.push_back({Of::unreleased, "line unreleased", "Not released", area(verdict.unreleased_area)});
  if (verdict.specks > 0 && verdict.undercuts > 0)
    lines.push_back(
        {Of::tiny, "line tiny", fmt::format("{} tiny, ignored", verdict.specks), area(verdict.speck_area)});
  if (health.open_edges > 0)
    lines.push_back({Of::open_edges, "line open", "Open edges", count(health.open_edges), true});
  if (health.inconsistent_edges > 0)
    lines.push_back({Of::turned_edges, "line turned", "Facets face opposite ways",
                     count(health.inconsistent_edges), true});
  if (here.uncertainty.mesh > 0.0 && lines.empty())
    lines.push_back({Of::crossings, "line crossings", "Facets cross", "", true});
  return lines;
}

void draw_subjects(const PanelContext& context, float alpha) {
  constexpr float k_subject_row = 20.0F;
  const Ui& ui = context.ui;
  if (!context.state.verdict) return;
  const std::vector<SubjectLine> lines = subject_lines(context.state);
  for (const SubjectLine& each : lines) {
    const Pressable row = pressable(ui, each.id, {room_left(), ui.px(k_subject_row)});
    light(context, row, {.of = each.of});
    const ImU32 colour = faded(each.doubt ? ui.colours->warning : ui.colours->text, alpha);
    const Line line = begin_line(ui, row, each.name, colour);
    draw_text_to({ui.fonts.body, colour}, line.right, line.top, each.figure);
    tooltip(ui, {}, "Lit on the part. Click to go there.");
    if (!row.clicked) continue;
    if (each.of == Subject::Of::unreleased) context.edits.enter(Step::undercuts);
    context.edits.ask(&Commands::look_at_subject, Subject{.of = each.of});
  }
  if (!lines.empty()) ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
}

void show_undercuts(const PanelContext& context) {
  context.edits.enter(Step::undercuts);
  context.edits.ask(&Commands::look_at_undercuts);
}

std::string tooltip_text(const VerdictCard& card) {
  std::string text = card.sentence;
  if (card.verdict)
    for (const std::string& reason : card.verdict->reasons) text += "\n" + reason;
  if (card.verdict && card.verdict->undercuts > 0)
    text += "\nClick to look at the undercuts (U).";
  else if (card.verdict && card.verdict->specks > 0)
    text += "\nClick to look at the largest tiny undercut (U).";
  return text;
}

/// By VerdictLight.
constexpr std::array<ImU32, 4> k_lights = {IM_COL32(140, 146, 154, 255), IM_COL32(52, 178, 96, 255),
                                           IM_COL32(240, 168, 40, 255), IM_COL32(226, 62, 54, 255)};

/// Of a mesh with these faults; one that has been done already helps no more.
RepairLevel repair_that_helps(const AppState& state) {
  const HealthReport& health = state.model->health;
  const bool torn = health.open_edges + health.inconsistent_edges > 0;
  return torn && state.reading.repair.level < RepairLevel::full ? RepairLevel::full : RepairLevel::unite;
}

/// What to do next, in one button: the mesh, a better direction, the undercuts.
void draw_next(const PanelContext& context, const VerdictCard& card) {
  const Ui& ui = context.ui;
  if (!card.verdict) return;
  const auto wide = [&](const std::string& label, const char* name) {
    const bool pressed = button(ui, label, {.width = room_left(), .strong = false});
    name_item(ui, name);
    ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
    return pressed;
  };
  const SweepState& sweep = context.state.sweep;
  const DirectionCard* const better = sweep.stale ? nullptr : better_direction(sweep.cards);
  const bool unknown = card.verdict->state == VerdictState::unknown;
  const RepairLevel level = repair_that_helps(context.state);
  if (unknown || level == RepairLevel::full) {
    if (level > context.state.reading.repair.level) {
      if (wide(level == RepairLevel::full ? "Repair the mesh" : "Unite what overlaps", "verdict repair"))
        context.edits.reading.repair.level = level;
      tooltip(ui, "Repair", option_named(reading_options(), "repair").help);
    } else if (wide("Show the faults of the mesh", "verdict faults")) {
      context.edits.enter(Step::part);
    }
  } else if (better != nullptr) {
    if (wide(fmt::format("Go to {}", with_minus(better->name)), "verdict go"))
      context.edits.ask(&Commands::fly_to_direction, better->direction);
  } else if (card.verdict->undercuts + card.verdict->specks > 0) {
    if (wide(card.verdict->undercuts > 0 ? "Show the undercuts" : "Show the tiny undercuts", "verdict show"))
      show_undercuts(context);
  }
}

}  // namespace

ImU32 light_colour(VerdictLight light) { return k_lights[static_cast<std::size_t>(light)]; }

void draw_regions_panel(const PanelContext& context) {
  const Ui& ui = context.ui;
  const Figures& figures = context.state.figures;
  if (context.layout.begin(ui, "Verdict")) {
    if (figures.shown) {
      const Legend legend{*context.state.model, *figures.shown, figures.pale ? 0.4F : 1.0F};
      draw_verdict(context);
      for (const Region region : k_regions) draw_region(context, legend, region);
      draw_total(context, legend);
      draw_trust(context, legend);
      ImGui::Indent(ui.px(18));  // below the regions' names
      option_row(ui, option_named(look_options(), "regions"), context.edits.settings.look);
      ImGui::Unindent(ui.px(18));
      draw_map_comparison(context);
    } else {
      hint(ui, figures.error.empty() ? "Measuring …" : figures.error);
    }
  }
  context.layout.end();
}

std::string actions_summary(const AppState& state) {
  const ActionPlan& plan = *state.actions.plan;
  std::string text = plan.actions.empty() ? "no side action releases them" : actions_text(plan);
  if (plan.unreleased_area > 0.0 && !plan.actions.empty())
    text += " · " + area_with_unit(*state.model, plan.unreleased_area) + " unreleased";
  return text;
}

VerdictCard verdict_card(const AppState& state) {
  VerdictCard card;
  if (!state.model || !state.figures.shown) return card;
  card.verdict = state.verdict;
  const Classification& here = *state.figures.shown;
  constexpr double k_seen = 1e-6;  // of the part's surface: less is no pixel
  double red = here.areas[Region::undercut];
  if (const auto& maps = state.figures.maps) red += maps->excess(Region::undercut);
  const bool known = state.figures.maps || !maps_shown(state);
  card.red = !known || red > k_seen * here.total_area;
  card.sentence = card.verdict ? card.verdict->sentence
                               : "Undercut, " + area_with_unit(*state.model, here.areas[Region::undercut]);
  return card;
}

VerdictLight light_of(VerdictState state) {
  if (state == VerdictState::two_plate) return VerdictLight::green;
  if (state == VerdictState::side_actions) return VerdictLight::amber;
  // Else nobody has asked yet what releases the undercuts, or they are not known.
  return state == VerdictState::not_releasable ? VerdictLight::red : VerdictLight::gray;
}

VerdictLight VerdictCard::light() const {
  if (!verdict) return VerdictLight::gray;
  return verdict->good() && red ? VerdictLight::amber : light_of(verdict->state);
}

void draw_verdict(const PanelContext& context) {
  constexpr float k_line = 18.0F, k_low_window = 680.0F;
  const Ui& ui = context.ui;
  // In a low window the panels below need the room; the tooltip has it all.
  const std::size_t most_lines = screen_size().y < ui.px(k_low_window) ? 2 : 5;
  const VerdictCard verdict = verdict_card(context.state);
  const float alpha = context.state.figures.pale ? 0.4F : 1.0F;
  const float width = room_left();
  const float room = width - ui.px(26);
  const std::vector<std::string> lines = lines_within(ui.fonts.strong, verdict.sentence, room, most_lines);
  const float height = ui.px(4.0F + k_line * static_cast<float>(lines.size()));
  const Pressable sentence = pressable(ui, "verdict", {width, height});
  const glm::vec2 at = sentence.box.min;
  ImDrawList& list = window_list();
  if (sentence.hovered && !verdict.good()) fill(list, {at, sentence.box.max}, ui.colours->field, ui.px(6));
  tooltip(ui, "Verdict", tooltip_text(verdict));
  if (verdict.verdict && verdict.verdict->undercuts + verdict.verdict->specks > 0)
    light(context, sentence,
          {.of = verdict.verdict->undercuts > 0 ? Subject::Of::undercuts : Subject::Of::tiny});
  if (sentence.clicked) show_undercuts(context);
  const glm::vec2 middle = at + glm::vec2(ui.px(12), ui.px(11));
  list.AddCircleFilled(middle, ui.px(verdict.good() ? 8 : 6), faded(light_colour(verdict.light()), alpha));
  if (verdict.good()) draw_icon(list, Icon::check, middle, ui.px(10), IM_COL32_WHITE);
  for (std::size_t k = 0; k < lines.size(); ++k)
    draw_text(list, {ui.fonts.strong, faded(ui.colours->text, alpha)},
              at + glm::vec2(ui.px(26), 0.5F * (ui.px(22) - ui.fonts.strong.size) +
                                            ui.px(k_line) * static_cast<float>(k)),
              lines[k]);
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
  draw_subjects(context, alpha);
  draw_next(context, verdict);
}

}  // namespace moldlight::gui
