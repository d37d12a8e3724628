// The strip of steps along the top, what it says of each, and the panel of the one that is open.
#include <algorithm>

#include <fmt/format.h>

#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/step_panels.hpp"

namespace moldlight::gui {

namespace {

using Kind = StepBadge::Kind;

// Layout units.
constexpr float k_padding = 8.0F, k_badge_gap = 5.0F, k_icon = 11.0F, k_step_gap = 2.0F;
constexpr std::string_view k_many = "99+";

StepBadge part_badge(const AppState& state) {
  const std::size_t count = state.model->warnings.size();
  if (count == 0) return {Kind::tick, {}, "The mesh is in order."};
  return {Kind::warning, {}, state.model->warnings.front()};
}

StepBadge direction_badge(const AppState& state) {
  const SweepState& sweep = state.sweep;
  if (sweep.cards.empty() || sweep.stale) return {};
  const auto offered = std::ranges::count_if(sweep.cards, &DirectionCard::offered);
  if (offered == 0) return {Kind::tick, {}, "No direction that was tried is better."};
  return {Kind::count, fmt::format("{}", offered),
          fmt::format("{} worth a look.",
                      offered == 1 ? "1 direction is" : fmt::format("{} directions are", offered))};
}

StepBadge undercuts_badge(const AppState& state) {
  const VerdictCard card = verdict_card(state);
  if (!card.verdict) return {};
  if (card.good()) return {Kind::tick, {}, card.sentence};
  if (card.verdict->undercuts == 0) return {};
  return {card.light() == VerdictLight::red ? Kind::warning : Kind::count,
          fmt::format("{}", card.verdict->undercuts), card.sentence};
}

StepBadge line_badge(const AppState& state) {
  const MoldState& mold = state.mold;
  if (!mold.error.empty()) return {Kind::warning, {}, mold.error};
  if (!mold.line || mold.line_awaited) return {};
  const std::vector<PartingLoop>& loops = mold.line->line.loops;
  const bool outer = !loops.empty() && loops.front().kind == LoopKind::outer;
  return {outer ? Kind::tick : Kind::warning, {}, mold.line->verdict};
}

StepBadge draft_badge(const AppState& state) {
  const auto& line = state.mold.line;
  if (!line || !line->draft) return {};
  const std::string sentence = draft_sentence(*state.model, *line->draft);
  if (line->draft->walls.empty()) return {Kind::tick, {}, sentence};
  return {Kind::warning, fmt::format("{}", line->draft->walls.size()), sentence};
}

StepBadge mold_badge(const AppState& state) {
  if (!is_settled(state.mold)) return {};
  const std::vector<HalvesLine> lines = halves_lines(state);
  const auto doubt = std::ranges::find_if(lines, &HalvesLine::doubt);
  if (doubt != lines.end()) return {Kind::warning, {}, doubt->text};
  return {Kind::tick, {}, "The halves are made, and their check has passed."};
}

using Pictures = const StepPictures&;

std::string number_of(const StepRow& row) { return fmt::format("{}", 1 + static_cast<int>(row.step)); }

/// With room for any badge, so that what comes and goes moves nothing.
float width_of(const Ui& ui, const StepRow& row) {
  const float gap = ui.px(k_badge_gap);
  const bool counts = row.step == Step::undercuts || row.step == Step::draft;  // beside a sign
  return 2.0F * ui.px(k_padding) + text_size(ui.fonts.small, number_of(row)).x + gap +
         text_size(ui.fonts.body, row.title).x + (row.badge != nullptr ? gap + ui.px(k_icon) : 0.0F) +
         (counts ? gap + text_size(ui.fonts.small, k_many).x : 0.0F);
}

void draw_place(const PanelContext& context, const StepRow& row) {
  const Ui& ui = context.ui;
  const StepBadge badge = step_badge(context.state, row);
  const bool here = context.state.step == row.step;
  const Pressable item =
      pressable(ui, fmt::format("step {}", row.title).c_str(), {width_of(ui, row), ui.px(k_row_height)});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (here || item.hovered)
    fill(list, item.box, here ? ui.colours->field_active : ui.colours->field_hovered, ui.px(6));
  tooltip(ui, fmt::format("{} ({})", row.title, number_of(row)),
          badge.help.empty() ? std::string(row.help) : fmt::format("{}\n{}", row.help, badge.help));
  float x = item.box.min.x + ui.px(k_padding);
  const float middle = item.box.centre().y;
  const auto write = [&](const Lettering& lettering, std::string_view text) {
    draw_text(list, lettering, {x, middle - 0.5F * lettering.font.size}, text);
    x += text_size(lettering.font, text).x + ui.px(k_badge_gap);
  };
  write({ui.fonts.small, ui.colours->muted}, number_of(row));
  write({ui.fonts.body, here ? ui.colours->text : ui.colours->muted}, row.title);
  const bool warns = badge.kind == Kind::warning;
  const ImU32 colour = warns ? ui.colours->warning : ui.colours->text;
  if (warns || badge.kind == Kind::tick) {
    draw_icon(list, warns ? Icon::alert : Icon::check, {x + 0.5F * ui.px(k_icon), middle}, ui.px(k_icon),
              colour);
    x += ui.px(k_icon + k_badge_gap);
  }
  if (!badge.count.empty())
    write({ui.fonts.small, ui.colours->text}, badge.count.size() > 2 ? k_many : badge.count);
  if (item.clicked) context.edits.enter(row.step);
}

}  // namespace

const std::array<StepRow, 7>& step_rows() {
  static const std::array<StepRow, 7> k_rows = {{
      {Step::part, "Part", "The file, its unit and the body that is molded.", part_badge,
       [](StepPanels& panels, const PanelContext& context, Pictures pictures) {
         draw_part_controls(context, panels.bodies, pictures.bodies);
       }},
      {Step::direction, "Direction", "Direction in which the mold opens.", direction_badge,
       [](StepPanels& panels, const PanelContext& context, Pictures pictures) {
         draw_direction_controls(context, panels.ball);
         panels.sweep.draw(context, pictures.candidates);
       }},
      {Step::undercuts, "Undercuts", "Undercuts, and the side actions that release them.", undercuts_badge,
       [](StepPanels& panels, const PanelContext& context, Pictures) {
         draw_actions_panel(context, panels.actions);
       }},
      {Step::parting_line, "Parting line", "The parting line, along which core and cavity meet.", line_badge,
       [](StepPanels& panels, const PanelContext& context, Pictures) {
         draw_line_panel(context, panels.line);
       }},
      {Step::draft, "Draft", "Walls with too little draft.", draft_badge,
       [](StepPanels& panels, const PanelContext& context, Pictures) { panels.draft.draw(context); }},
      {Step::mold, "Mold", "The mold halves, open or closed.", mold_badge,
       [](StepPanels& panels, const PanelContext& context, Pictures) {
         draw_mold_panel(context, panels.mold);
       }},
      {Step::report, "Report", "Pictures, files and the report.", nullptr,
       [](StepPanels& panels, const PanelContext& context, Pictures) { panels.report.draw(context); }},
  }};
  return k_rows;
}

StepBadge step_badge(const AppState& state, const StepRow& row) {
  StepBadge badge = row.badge != nullptr ? row.badge(state) : StepBadge();
  if (badge.kind == Kind::tick && !verdict_card(state).good()) badge.kind = Kind::none;
  return badge;
}

float strip_width(const PanelContext& context) {
  float width = 0.0F;
  for (const StepRow& row : step_rows()) width += width_of(context.ui, row) + context.ui.px(k_step_gap);
  return width;
}

void draw_strip(const PanelContext& context) {
  for (const StepRow& row : step_rows()) {
    if (row.step != Step::part) ImGui::SameLine(0.0F, context.ui.px(k_step_gap));
    draw_place(context, row);
  }
}

void StepPanels::draw(const PanelContext& context, const StepPictures& pictures) {
  const StepRow& row = step_rows()[static_cast<std::size_t>(context.state.step)];
  if (context.layout.begin(context.ui, "Step", row.title.data())) {
    // Two revisions have their own direction, and changes in place of undercuts.
    const bool compares = context.state.revisions.on();
    if (compares && row.step != Step::part && row.step != Step::direction) {
      hint(context.ui, "Two revisions are compared. Leave the comparison (Ctrl+D) for this step.");
    } else {
      row.panel(*this, context, pictures);
    }
  }
  context.layout.end();
}

void StepPanels::draw_below(const PanelContext& context, const StepPictures& pictures) {
  if (is_at(context.state, Step::part)) bodies.draw_below(context, pictures.bodies);
  if (is_at(context.state, Step::direction)) sweep.draw_below(context, pictures.candidates);
}

}  // namespace moldlight::gui
