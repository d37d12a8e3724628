// The parting line and the mold: what they say, also to what else asks.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/step_parts.hpp"
#include "gui/view/mold_view.hpp"
#include "gui/view/side_actions.hpp"
#include "parting/mold_figures.hpp"
#include "parting/mold_report.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_loops_share = 0.4F;  // of the window's height, that the list takes at most

/// "Core half 123 mm³ · Cavity half 120 mm³".
std::string figures_line(const FigureStyle& style, const std::vector<FoundFigure>& figures,
                         bool of_surfaces) {
  std::string line;
  for (const FoundFigure& figure : figures) {
    if (!style.is_shown(figure) || figure.key.starts_with("surface") != of_surfaces) continue;
    const std::string unit = style.unit(figure.kind);
    line += fmt::format("{}{} {}{}{}", line.empty() ? "" : " · ", figure.title, grouped(style.text(figure)),
                        unit.empty() ? "" : " ", unit);
  }
  return with_minus(line);
}

/// The faces that a hand has given to a half: a click forgets them.
void draw_cosmetic(const PanelContext& context) {
  const Ui& ui = context.ui;
  std::string& cosmetic = context.edits.settings.mold.cosmetic;
  for (const bool core : {true, false}) {
    const std::vector<std::uint32_t> faces = cosmetic_faces(cosmetic, core);
    if (faces.empty()) continue;
    const std::string_view half = core ? "core" : "cavity";
    const std::string label = fmt::format("{} to the {}  ×", plural(faces.size(), "face"), half);
    const bool forgotten = chip(ui, label, true, false);
    name_item(ui, fmt::format("faces to the {}", half));
    tooltip(ui, "Faces given by hand",
            "Saved with the part; the flag --cosmetic does the same. Click to remove them.");
    if (!forgotten) continue;
    for (const std::uint32_t face : faces) cosmetic = cosmetic_with(cosmetic, face, std::nullopt);
    break;
  }
}

/// The height: that which is given, or that which was found until one is typed.
void draw_height(const PanelContext& context, const RowOptions& numbers) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  auto& given = context.edits.settings.mold.parting_height;
  const float width = ImGui::GetContentRegionAvail().x, cross = given ? ui.px(k_row_height + 4) : 0.0F;
  double height = parting_height(state);
  const HeightRange range = height_range(state);
  const std::string label =
      fmt::format("{}, {}", given ? "Height" : "Height found", length_unit(state.model->part));
  if (number_field(ui, "parting_height", height, {label, 2, width - cross})) {
    if (height > range.low && height < range.high) {
      given = height;
    } else {
      numbers.refused(fmt::format("The halves can meet between {} and {}, where the part is",
                                  with_minus(figure(range.low)), with_minus(figure(range.high))));
    }
  }
  tooltip(ui, "Parting height", option_named(mold_options(), "parting_height").help);
  if (!given) return;
  ImGui::SameLine(0.0F, ui.px(4));
  if (icon_button(ui, {"find the height", Icon::close, "Find the height again"})) given.reset();
}

}  // namespace

bool has_mold(const AppState& state) {
  return !state.sweep_choices.compared && !state.sweep_choices.large_ball && !state.revisions.on();
}

std::string halves_refusal(const AppState& state) {
  const MoldHalves& halves = state.mold.solids->halves;
  const auto& place = halves.refused_at ? halves.refused_at : halves.written.refused_at;
  const auto& line = state.mold.line;
  return refusal_text(*state.model, halves, halves.written,
                      place && line ? loop_near(line->line, *place) : std::string());
}

std::vector<HalvesLine> halves_lines(const AppState& state) {
  const MoldState& mold = state.mold;
  if (!mold.solids) return {};
  const PartModel& model = *state.model;
  const MoldHalves& halves = mold.solids->halves;
  if (const std::string refusal = halves_refusal(state); !refusal.empty()) return {{refusal, true}};
  const FigureStyle style(model);
  const std::vector<FoundFigure> figures = found_figures(halves_figures(), halves);
  std::vector<HalvesLine> lines = {{figures_line(style, figures, false)},
                                   {figures_line(style, figures, true)}};
  for (const std::string& fault : half_faults(model, halves)) lines.push_back({sentence_of(fault), true});
  for (const std::string& missed : missed_lines(model, halves)) lines.push_back({missed, true});
  if (const std::string unfilled = unfilled_text(model, state.settings.mold, halves); !unfilled.empty())
    lines.push_back({"No files: " + unfilled, true});
  else if (mold.by_action) {
    const auto moved = std::ranges::count_if(
        *mold.by_action, [](const InsertActions& insert) { return !insert.actions.empty(); });
    if (moved > 0)
      lines.push_back({fmt::format("{} insert{} with side actions", moved, moved == 1 ? " goes" : "s go")});
  }
  return lines;
}

namespace {

void draw_mold_settings(const PanelContext& context) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const PartLengths lengths(state);
  MoldSettings& settings = context.edits.settings.mold;
  RowOptions numbers = typed_numbers(context);
  numbers.lengths = &lengths;
  numbers.unset = fmt::format("{:.1f}", block_margin({}, state.model->frame.diagonal));
  option_table<MoldSettings>(ui, mold_options(), settings, numbers);
}

void draw_loop(const PanelContext& context, std::size_t number, const ScreenBox& row) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const PartingLoop& loop = state.mold.line->line.loops[number];
  const FigureStyle style(*state.model);
  const auto length = [&](double value) { return style.with_unit(FigureKind::length, value); };
  const std::string name(loop_name(loop.kind));
  draw_two_lines(
      ui, row,
      {.number = std::to_string(number + 1),
       .name = name,
       .figure = length(loop.length),
       .below = loop.climb() > lateral_tolerance(state.settings.method, state.model->frame.diagonal)
                    ? fmt::format("climbs {} · steepest {:.0f}°", length(loop.climb()), loop.steepest_deg)
                    : "level",
       .colour = faded(ui.colours->text, state.mold.line_awaited ? 0.75F : 1.0F),
       .below_colour = ui.colours->muted});
  tooltip(ui, fmt::format("Loop {}: {}", number + 1, name),
          with_minus(
              fmt::format("{} long, from {} to {} along the direction\nsteepest edge {:.0f}°, projected area "
                          "{}\nClick to look at it.",
                          length(loop.length), length(loop.low), length(loop.high), loop.steepest_deg,
                          style.with_unit(FigureKind::area, std::abs(loop.area)))));
}

StepNews line_news(const MoldState& mold) {
  if (mold.line_awaited)
    return {.text = mold.running && !mold.running->stage.empty() ? mold.running->stage + " …"
                                                                 : "Finding the parting line …",
            .progress = mold.running ? mold.running->fraction : -1.0};
  if (!mold.line && !mold.error.empty()) return {.text = mold.error, .warning = true};
  return {.text = mold.line ? mold.line->verdict : std::string("Measuring …")};
}

StepNews mold_news(const MoldState& mold) {
  if (mold.line_awaited) return line_news(mold);
  if (mold.solids_awaited)
    return {.text = mold.running && !mold.running->stage.empty() ? mold.running->stage + " …"
                                                                 : "Making the halves …",
            .progress = mold.running ? mold.running->fraction : -1.0};
  if (!mold.error.empty()) return {.text = mold.error, .warning = true};
  if (!mold.solids) return {.text = "Measuring …"};
  return {.text = mold.solids->halves.made() ? "Both halves are made." : "There are no halves."};
}

/// The certificate's figures, a row each.
void draw_halves_facts(const PanelContext& context) {
  const AppState& state = context.state;
  const FigureStyle style(*state.model);
  if (!state.mold.solids || !state.mold.solids->halves.made()) return;
  for (const FoundFigure& figure : found_figures(halves_figures(), state.mold.solids->halves)) {
    if (!style.is_shown(figure)) continue;
    const std::string unit = style.unit(figure.kind);
    draw_fact(context.ui, figure.title,
              with_minus(grouped(style.text(figure)) + (unit.empty() ? "" : " " + unit)));
  }
}

}  // namespace

void draw_parting_line_step(const PanelContext& context, StepMemory& memory) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  draw_news(context, memory, line_news(state.mold), {"mold options", "Settings of the mold"});
  if (memory.settings) return draw_mold_settings(context);
  if (!state.mold.line) return;
  const std::vector<PartingLoop>& all = state.mold.line->line.loops;
  const double tolerance = lateral_tolerance(state.settings.method, state.model->frame.diagonal);
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!all[k].tiny(tolerance)) shown.push_back(k);
  const ChoiceTable loops{
      .list = {.id = "loops", .count = shown.size(), .row_height = k_two_lines, .share = k_loops_share},
      .row = "loop",
      .chosen = context.edits.mold_choices.loop,
      .look = &Commands::look_at_loop,
      .numbers = shown};
  draw_choices(context, loops, memory.cursor,
               [&](std::size_t k, const ScreenBox& row) { draw_loop(context, k, row); });
  if (const std::string tiny = tiny_text(all.size() - shown.size()); !tiny.empty()) hint(ui, tiny);
  draw_height(context, typed_numbers(context));
  bool& moves = context.edits.mold_choices.moves_faces;
  if (chip(ui, "Move faces", moves)) moves = !moves;
  tooltip(ui, "Move faces",
          "Click a face that either half could form to move it to the other half. Ctrl + click or V does "
          "this at any time.");
  draw_cosmetic(context);
}

void draw_mold_step(const PanelContext& context, StepMemory& memory) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  draw_news(context, memory, mold_news(state.mold), {"mold options", "Settings of the mold"});
  if (memory.settings) return draw_mold_settings(context);
  LookSettings& look = context.edits.settings.look;
  const bool opens = look.open_mold < 1.0;
  if (button(ui, opens ? "Play the shot##shot" : "Close the mold##shot",
             {.width = ImGui::GetContentRegionAvail().x, .strong = opens}))
    context.edits.ask(&Commands::play_shot);
  name_item(ui, "shot");
  tooltip(ui, {}, "Slides, halves, then the ejection (O). Space pauses.");
  const RowOptions row{.text = [&](double open) { return opening_text(state, open); }};
  option_row(ui, option_named(look_options(), "open_mold"), look, row);
  if (ImGui::IsItemActive()) context.edits.dragging = true;
  option_row(ui, option_named(window_options(), "halves"), context.edits.window);
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
  draw_halves_facts(context);
  for (const HalvesLine& line : halves_lines(state)) {
    if (line.doubt)
      draw_note(ui, {.text = line.text,
                     .icon = Icon::alert,
                     .warning = true,
                     .alpha = state.mold.solids_awaited ? 0.6F : 1.0F});
  }
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
  if (button(ui, "Export the mold …", {.width = ImGui::GetContentRegionAvail().x}))
    context.edits.dialogs.exporting_mold = true;
  name_item(ui, "export mold");
}

}  // namespace moldlight::gui
