// The undercuts: what releases each, and what of that is allowed.
#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "actions/action_figures.hpp"
#include "actions/action_words.hpp"
#include "actions/actions_files.hpp"
#include "actions/actions_report.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/table_bar.hpp"
#include "gui/view/side_actions.hpp"
#include "mold/direction.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_action_row = 74.0F;    // layout units
constexpr float k_actions_share = 0.5F;  // of the window's height, that the table takes at most
constexpr float k_pin_width = 88.0F;

constexpr ListColumn k_number{"#", "", 8.0F, false}, k_kind{"action", "", 42.0F, false};

/// The pin that the settings have for it, which a plan may not have seen yet.
const ActionPin* pin_for(const ActionSettings& settings, const UndercutReport& found) {
  for (auto pin = settings.pins.rbegin(); pin != settings.pins.rend(); ++pin)
    if (found.pin == *pin || (pin->point == found.point && pin->area == found.undercut.area)) return &*pin;
  return nullptr;
}

void set_pin(ActionSettings& settings, const UndercutReport& found,
             const std::optional<std::optional<ActionKind>>& kind) {
  while (const ActionPin* pin = pin_for(settings, found))
    settings.pins.erase(settings.pins.begin() + (pin - settings.pins.data()));
  if (kind) settings.pins.push_back({.point = found.point, .area = found.undercut.area, .kind = *kind});
}

/// The cell that shows to what an undercut is pinned; a click opens the list of kinds.
void draw_pin(const PanelContext& context, std::size_t undercut) {
  const Ui& ui = context.ui;
  const UndercutReport& found = context.state.actions.plan->undercuts[undercut];
  ActionSettings& settings = context.edits.settings.actions;
  const ActionPin* const pin = pin_for(settings, found);
  const std::string id = fmt::format("pin {}", undercut + 1);
  const Pressable cell = pressable(ui, id.c_str(), {ui.px(k_pin_width), ui.px(22)});
  ImDrawList& list = window_list();
  if (cell.hovered || pin != nullptr)
    fill(list, cell.box, field_colour(ui, {.hovered = cell.hovered}), ui.px(6));
  const float top = cell.box.centre().y - 0.5F * ui.fonts.small.size;
  const ImU32 colour = pin != nullptr || cell.hovered ? ui.colours->text : ui.colours->muted;
  draw_text(list, {ui.fonts.small, colour}, {cell.box.min.x + ui.px(8), top},
            pin != nullptr ? pin_name(*pin) : "automatic");
  draw_icon(list, Icon::chevron_down, {cell.box.max.x - ui.px(12), cell.box.centre().y}, ui.px(8), colour);
  tooltip(ui, "Pinned to",
          "The only kind of action that may release this undercut. The choice is saved with the part.");
  if (cell.clicked) open_popup_below_item(ui, id.c_str());
  if (!begin_popup(ui, id.c_str(), ui.px(176))) return;
  if (menu_item(ui, "automatic", {.chosen = pin == nullptr})) set_pin(settings, found, std::nullopt);
  for (std::size_t k = 0; k < k_action_kinds; ++k) {
    const auto kind = static_cast<ActionKind>(k);
    if (menu_item(ui, facts(kind).singular, {.chosen = pin != nullptr && pin->kind == kind}))
      set_pin(settings, found, std::optional(kind));
  }
  if (menu_item(ui, k_no_action, {.chosen = pin != nullptr && !pin->kind}))
    set_pin(settings, found, std::optional<ActionKind>());
  end_popup(ui);
}

/// The user's own directions: a click forgets one.
void draw_own_directions(const PanelContext& context) {
  const Ui& ui = context.ui;
  auto& own = context.edits.settings.actions.side_directions;
  if (own.empty()) return;
  row_text(ui, ui.note(), text_size(ui.fonts.small, "by hand").x + ui.px(12), "by hand");
  const ActionsState& actions = context.state.actions;
  for (std::size_t k = 0; k < own.size(); ++k) {
    const bool taken =
        is_settled(actions) && std::ranges::any_of(actions.plan->actions, [&](const SideAction& action) {
          return is_along(action, glm::normalize(own[k]));
        });
    ImGui::SameLine(0.0F, ui.px(4));
    ImGui::PushID(static_cast<int>(k));
    const bool removed = chip(ui, with_minus(direction_words(glm::normalize(own[k]))) + "  ×", taken);
    ImGui::PopID();
    name_item(ui, fmt::format("by hand {}", k + 1));
    tooltip(ui, "A direction of your own",
            taken
                ? "An action uses this direction. Click to remove it (Delete)."
                : "No action uses this direction: it is blocked, or others are cheaper. Click to remove it.");
    if (removed) {
      own.erase(own.begin() + static_cast<std::ptrdiff_t>(k));
      break;
    }
  }
}

std::string tip_text(const AppState& state, std::size_t undercut) {
  const ActionPlan& plan = *state.actions.plan;
  std::string tip = undercut_details(*state.model, plan, undercut);
  if (std::ranges::find(plan.unreleased, undercut) != plan.unreleased.end())
    tip += (tip.empty() ? "" : "\n") + unreleased_text(plan, undercut);
  if (const auto& changes = state.actions.changes; changes && state.figures.shown) {
    const std::string change =
        change_text({*state.model, *state.figures.shown, state.settings.actions, plan, *changes}, undercut);
    if (change != "-") tip += "\nWhat to change of the part: " + change;
  }
  return tip + "\nClick to look at it and see its action move.";
}

/// Items between dots, as many in a line as there is room for.
std::vector<std::string> lines_of_items(const SizedFont& font, std::string_view text, float width) {
  constexpr std::string_view k_dot = " · ";
  std::vector<std::string> lines;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = text.find(k_dot);
    const std::string item(text.substr(0, end));
    const std::string longer = lines.empty() ? item : lines.back() + std::string(k_dot) + item;
    if (lines.empty() || text_size(font, longer).x > width)
      lines.push_back(item);
    else
      lines.back() = longer;
    if (end != std::string_view::npos) text.remove_prefix(end + k_dot.size());
  }
  return lines;
}

void draw_undercut(const PanelContext& context, std::size_t undercut, const ScreenBox& row) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const ActionPlan& plan = *state.actions.plan;
  const SideAction* const action = action_of(plan, undercut);
  const ImU32 normal = faded(ui.colours->text, state.actions.awaited ? 0.75F : 1.0F);
  const ScreenBox upper{row.min, {row.max.x, row.min.y + ui.px(24)}};
  draw_cell(ui, upper, k_number, {ui.fonts.strong, normal}, std::to_string(undercut + 1));
  const float at = row.min.x + ui.px(k_kind.at), room = row.max.x - ui.px(k_pin_width + 6) - at;
  const float width = row.max.x - row.min.x - ui.px(30);
  std::vector<std::string> lines;  // below
  if (action != nullptr) {
    draw_cell(ui, upper, k_kind, {ui.fonts.body, normal}, facts(action->kind).singular, room);
    const Colour body = action_colour(static_cast<std::size_t>(action - plan.actions.data()));
    window_list().AddCircleFilled(ImVec2(at - ui.px(10), upper.centre().y), 4.0F * ui.scale, packed(body));
    lines = lines_of_items(ui.fonts.small, undercut_items(*state.model, plan, undercut), width);
  } else {
    draw_cell(ui, upper, k_kind, {ui.fonts.body, ui.colours->warning}, "not released", room);
    lines = lines_within(ui.fonts.small, unreleased_text(plan, undercut), width, 2);
    lines.insert(lines.begin(), undercut_items(*state.model, plan, undercut));
  }
  for (std::size_t k = 0; k < lines.size(); ++k)
    draw_second_line(
        ui,
        {row.min, row.min + glm::vec2(row.max.x - row.min.x, ui.px(42.0F + 15.0F * static_cast<float>(k)))},
        24.0F, lines[k]);
  tooltip(ui, fmt::format("Undercut {}", undercut + 1), tip_text(state, undercut));
  put_cursor({row.max.x - ui.px(k_pin_width + 2), row.min.y + ui.px(1)});
  draw_pin(context, undercut);
}

void draw_undercuts(const PanelContext& context, RowCursor& cursor) {
  const ActionPlan& plan = *context.state.actions.plan;
  const ChoiceTable undercuts{.list = {.id = "undercuts",
                                       .count = plan.undercuts.size(),
                                       .row_height = k_action_row,
                                       .share = k_actions_share},
                              .row = "undercut",
                              .chosen = context.edits.action_choices.chosen,
                              .look = &Commands::look_at_undercut,
                              .beside = k_pin_width + 6,
                              .tiny = tiny_text(speck_count(plan)),
                              .look_at_tiny = &Commands::look_at_speck};
  draw_choices(context, undercuts, cursor,
               [&](std::size_t k, const ScreenBox& row) { draw_undercut(context, k, row); });
  draw_own_directions(context);
}

BarNews actions_news(const AppState& state) {
  const ActionsState& actions = state.actions;
  if (actions.running || actions.awaited) return running_news(actions.running, "finding side actions …");
  if (!actions.error.empty()) return {.text = actions.error, .warning = true};
  if (!actions.plan) return {.text = "Undercuts are listed when the direction rests."};
  if (!actions.plan->undercuts.empty()) return {.text = actions_summary(state)};
  return {.text = actions.plan->specks.empty()
                      ? std::string("There is no undercut along this direction.")
                      : "All undercuts are too small to count. " + tiny_text(speck_count(*actions.plan))};
}

}  // namespace

void draw_actions_panel(const PanelContext& context, TableBar& bar) {
  const AppState& state = context.state;
  const auto& plan = state.actions.plan;
  TableBarParts parts{.options = "action options",
                      .options_hint = "Settings of the side actions",
                      .news = actions_news(state),
                      .settings = [&] {
                        option_table<ActionSettings>(context.ui, action_options(),
                                                     context.edits.settings.actions, typed_numbers(context));
                        draw_own_directions(context);
                      }};
  if (plan && !plan->undercuts.empty())
    parts.table = [&](RowCursor& cursor) { draw_undercuts(context, cursor); };
  bar.draw_inside(context, parts);
}

}  // namespace moldlight::gui
