#include "gui/commands.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <GLFW/glfw3.h>

#include "classify/number_format.hpp"
#include "gui/view/direction.hpp"
#include "gui/view/side_actions.hpp"

namespace moldlight::gui {

void Edits::keep_bookmark() {
  const glm::dvec3& direction = settings.direction.given();
  bookmarks.push_back(
      {.note = direction_text(direction, 3), .direction = tidy(direction), .actions = settings.actions});
}

void Edits::enter(Step wanted) {
  if (wanted == step) return;
  LookSettings& look = settings.look;
  if (wanted == Step::draft) {
    look.colour_mode = ColourMode::draft_angle;
  } else if (step == Step::draft) {
    look.colour_mode = ColourMode::regions;
  }
  if (step == Step::mold) look.open_mold = 0.0;
  if (step == Step::undercuts) action_choices.chosen.reset();
  if (wanted != Step::direction) {
    sweep_choices.compared.reset();
    sweep_choices.large_ball = false;
  }
  if (step == Step::draft) draft_choices.kind.clear();
  if (wanted != Step::parting_line && wanted != Step::mold) mold_choices = {};
  former_step = std::exchange(step, wanted);
}

namespace {

constexpr double k_nudge_deg = 1.0, k_fine_nudge_deg = 0.1;

/// What a key finds, and what it may change.
struct Pressed {
  const KeyPress& key;
  const AppState& state;
  Edits& edits;
  LookSettings& look = edits.settings.look;
  Direction& direction = edits.settings.direction;
};

template <typename Enum>
void take_the_other(Enum& one_of_two) {
  one_of_two = one_of_two == Enum{0} ? Enum{1} : Enum{0};
}

/// Gives up a drag, or takes back the last of what was opened and chosen beside the dialogs.
void escape(const Pressed& p) {
  p.edits.give_up_drag = true;
  SweepChoices& choices = p.edits.sweep_choices;
  if (ImGui::IsMouseDown(0)) return;
  if (p.edits.tour) {
    p.edits.tour.reset();
  } else if (!p.state.toasts.empty()) {
    p.edits.ask(&Commands::dismiss_toasts);
  } else if (p.edits.measuring) {
    p.edits.measuring.reset();
  } else if (p.edits.divider) {
    p.edits.divider.reset();
  } else if (choices.compared) {
    choices.compared.reset();
  } else if (choices.large_ball) {
    choices.large_ball = false;
  } else if (p.edits.action_choices.chosen) {
    p.edits.action_choices.chosen.reset();
  } else if (p.edits.mold_choices.moves_faces) {
    p.edits.mold_choices.moves_faces = false;
  } else if (!p.edits.draft_choices.kind.empty()) {
    p.edits.draft_choices.kind.clear();
  } else if (p.edits.mold_choices.loop) {
    p.edits.mold_choices.loop.reset();
  } else if (p.edits.revision_choices.chosen) {
    p.edits.revision_choices.chosen.reset();
  } else if (p.state.face) {
    p.edits.ask(&Commands::choose_face, std::nullopt);
  } else if (p.state.revisions.on()) {
    p.edits.ask(&Commands::leave_revisions);
  }
}

/// Of the user's own directions, that of the action that is looked at, or else the last one.
void forget_side_direction(const Pressed& p) {
  const auto arrow = side_arrow(p.state);
  ActionSettings& settings = p.edits.settings.actions;
  const auto own = arrow ? own_direction(settings, arrow->direction) : std::nullopt;
  if (!own && !settings.side_directions.empty()) return settings.side_directions.pop_back();
  if (own)
    settings.side_directions.erase(settings.side_directions.begin() + static_cast<std::ptrdiff_t>(*own));
}

/// Arrow keys move the direction's tip on the screen.
void nudge(const Pressed& p) {
  const Camera& camera = p.state.camera;
  const glm::dvec3 toward = p.key.key == GLFW_KEY_LEFT    ? -camera.right()
                            : p.key.key == GLFW_KEY_RIGHT ? camera.right()
                            : p.key.key == GLFW_KEY_UP    ? camera.up()
                                                          : -camera.up();
  const double angle_deg = p.key.shift ? k_fine_nudge_deg : k_nudge_deg;
  p.direction = nudged(p.edits.settings.direction.unit(), toward, camera.toward_viewer(), angle_deg);
}

void keep_bookmark(const Pressed& p) {
  p.edits.keep_bookmark();
  p.edits.ask(&Commands::say, "Bookmark kept: " + p.edits.bookmarks.back().note, false);
}

/// The best direction beside the present one, then the next ones, then none.
void compare_next(const Pressed& p) {
  auto& compared = p.edits.sweep_choices.compared;
  const std::size_t count = p.state.sweep.result ? p.state.sweep.result->candidates.size() : 0;
  const std::size_t next = compared ? *compared + 1 : 0;
  p.edits.enter(Step::direction);
  compared = next < count ? std::optional(next) : std::nullopt;
}

/// Draft colours have a step of their own.
void colour_by_draft(const Pressed& p) {
  const bool on = p.look.colour_mode != ColourMode::draft_angle;
  p.look.colour_mode = on ? ColourMode::draft_angle : ColourMode::regions;
  if (on != (p.edits.step == Step::draft)) p.edits.enter_or_leave(Step::draft);
}

void take_direction(const Pressed& p) {
  p.edits.ask(p.key.key == 'N' ? &Commands::take_normal : &Commands::take_axis);
}

void undo_or_redo(const Pressed& p) {
  p.edits.ask(p.key.shift || p.key.key == 'Y' ? &Commands::redo : &Commands::undo);
}

void measure(const Pressed& p) {
  p.edits.measuring = p.edits.measuring ? std::nullopt : std::optional(Measuring{});
}

void ask_for_part(const Pressed& p) {
  p.edits.dialogs.browser = true;
  p.edits.dialogs.browser_compares = false;
}

/// Views as on the number pad of other programs; with Ctrl from the other side.
void look_from_side(const Pressed& p) {
  const auto [view, opposite] =
      p.key.key == GLFW_KEY_KP_1   ? std::pair(StandardView::front, StandardView::back)
      : p.key.key == GLFW_KEY_KP_3 ? std::pair(StandardView::right, StandardView::left)
                                   : std::pair(StandardView::top, StandardView::bottom);
  p.edits.ask(&Commands::look_from, standard_orientation(p.key.ctrl ? opposite : view));
}

void move_divider(const Pressed& p) {
  constexpr double k_step = 0.02;
  const double by = p.key.key == GLFW_KEY_COMMA ? -k_step : k_step;
  if (p.edits.divider) p.edits.divider = std::clamp(*p.edits.divider + by, 0.0, 1.0);
}

Section next_section(Section section) {
  return section == Section::off      ? Section::across
         : section == Section::across ? Section::along
                                      : Section::off;
}

/// When a key acts: with a part alone or without one, too; with Ctrl alone, without it, or either way.
enum class When : std::uint8_t { always, with_ctrl, part, part_no_ctrl };

/// A line of the help sheet, and what its keys do; a line without keys is the mouse's.
struct Shortcut {
  HelpLine help;
  When when = When::always;
  std::vector<int> keys = {};
  std::function<void(const Pressed&)> act = {};
};

void sweep_or_cancel(const Pressed& p) {
  p.edits.enter(Step::direction);
  p.edits.ask(p.state.sweep.running ? &Commands::cancel_sweep : &Commands::start_sweep);
}

void enlarge_map(const Pressed& p) {
  p.edits.enter(Step::direction);
  p.edits.sweep_choices.large_ball = !p.edits.sweep_choices.large_ball;
}

void open_mold(const Pressed& p) {
  if (p.key.key == GLFW_KEY_SPACE)
    return p.edits.ask(p.state.presented ? &Commands::pause_presenting : &Commands::stop_opening);
  p.look.open_mold = p.look.open_mold < 1.0 ? 1.0 : 0.0;
  p.edits.ask(&Commands::fit_view);
}

using Shortcuts = std::vector<Shortcut>;

/// By HelpLine::Group.
const std::array<Shortcuts, 3>& shortcuts() {
  using enum When;
  using C = Commands;
  using P = const Pressed&;
  const auto asks = [](void (C::*command)()) { return [=](P p) { p.edits.ask(command); }; };
  const auto switches = [](bool Dialogs::*shown) {
    return [=](P p) { p.edits.dialogs.*shown = !(p.edits.dialogs.*shown); };
  };
  static const Shortcuts k_direction = {
      {{"Drag the arrow's tip", "turn the parting direction"}},
      {{"Ctrl while dragging", "snap to the part's own directions"}},
      {{"Esc", "undo the drag, close what is open"}, always, {GLFW_KEY_ESCAPE}, escape},
      {{"Double click", "direction: normal of the face there"}},
      {{"Click", "choose the face there"}},
      {{"Alt + double click", "direction: axis of that round wall"}},
      {{"N / A", "the same for the face under the cursor"}, part_no_ctrl, {'N', 'A'}, take_direction},
      {{"Arrow keys", "turn by 1°, with Shift by 0.1°"},
       part,
       {GLFW_KEY_LEFT, GLFW_KEY_RIGHT, GLFW_KEY_UP, GLFW_KEY_DOWN},
       nudge},
      {{"X", "flip"}, part_no_ctrl, {'X'}, [](P p) { p.direction = tidy(-p.direction.given()); }},
      {{"B", "bookmark the direction"}, part_no_ctrl, {'B'}, keep_bookmark},
      {{"Drag a side action's tip", "give it a direction of your own"}},
      {{"Delete", "forget that direction"}, part_no_ctrl, {GLFW_KEY_DELETE}, forget_side_direction},
      {{"V", "move the face at the cursor to the other half"},
       part_no_ctrl,
       {'V'},
       asks(&C::move_hovered_face)},
      {{"Ctrl + click", "the same for the face there"}},
      {{"W", "sweep: find directions, or cancel"}, part_no_ctrl, {'W'}, sweep_or_cancel},
      {{"C", "compare with the best, the next …"}, part_no_ctrl, {'C'}, compare_next},
      {{"M", "map of directions, large"}, part_no_ctrl, {'M'}, enlarge_map},
  };
  static const Shortcuts k_view = {
      {{"1 … 7", "the steps: part, direction … report"},
       part_no_ctrl,
       {'1', '2', '3', '4', '5', '6', '7'},
       [](P p) { p.edits.enter(static_cast<Step>(p.key.key - '1')); }},
      {{"Shift + 1 / 3 / 7", "front, right, top; with Ctrl the opposite"},
       part,
       {GLFW_KEY_KP_1, GLFW_KEY_KP_3, GLFW_KEY_KP_7},
       look_from_side},
      {{"0", "along the parting direction"}, part, {'0', GLFW_KEY_KP_0}, asks(&C::look_along_direction)},
      {{"U", "the undercuts, from the best point of view"}, part_no_ctrl, {'U'}, asks(&C::look_at_undercuts)},
      {{"Shift + 5", "parallel or perspective"}, part, {GLFW_KEY_KP_5}, asks(&C::toggle_projection)},
      {{"F", "fit the part"}, part, {'F'}, asks(&C::fit_view)},
      {{"O / Space", "open or close the mold, or stop it"}, part_no_ctrl, {'O', GLFW_KEY_SPACE}, open_mold},
      {{"F5", "present the part, or end that"}, part_no_ctrl, {GLFW_KEY_F5}, asks(&C::present)},
      {{"G", "the mold, or back"}, part_no_ctrl, {'G'}, [](P p) { p.edits.enter_or_leave(Step::mold); }},
      {{"S", "section across, along the direction, none"},
       part_no_ctrl,
       {'S'},
       [](P p) { p.look.section = next_section(p.look.section); }},
      {{"R", "measure between two places, or end it"}, part_no_ctrl, {'R'}, measure},
      {{", / .", "move the line between maps and exact"},
       part_no_ctrl,
       {GLFW_KEY_COMMA, GLFW_KEY_PERIOD},
       move_divider},
      {{"D", "colour by region or by draft angle"}, part_no_ctrl, {'D'}, colour_by_draft},
      {{"P", "palette"}, part_no_ctrl, {'P'}, [](P p) { take_the_other(p.look.palette); }},
      {{"T", "dark or light"}, always, {'T'}, [](P p) { take_the_other(p.edits.window.theme); }},
  };
  static const Shortcuts k_program = {
      {{"Ctrl+O", "open a part, or a batch's folder"}, with_ctrl, {'O'}, ask_for_part},
      {{"Ctrl+D", "compare with another revision, or leave it"},
       with_ctrl,
       {'D'},
       asks(&C::compare_or_leave)},
      {{"L", "the parts of the batch that is open"},
       always,
       {'L'},
       [](P p) { p.edits.dialogs.batch = p.state.batch && !p.edits.dialogs.batch; }},
      {{"Ctrl+E", "export"},
       with_ctrl,
       {'E'},
       [](P p) { p.edits.dialogs.exporting = p.state.model != nullptr; }},
      {{"F12", "picture with legend"}, part_no_ctrl, {GLFW_KEY_F12}, asks(&C::take_picture)},
      {{"Ctrl+Z / Ctrl+Y", "undo, redo"}, with_ctrl, {'Z', 'Y'}, undo_or_redo},
      {{"Tab, Space, arrows", "go to a control, press, change it"}},
      {{"Ctrl+Tab", "hide the panels"}, with_ctrl, {GLFW_KEY_TAB}, switches(&Dialogs::panels_hidden)},
      {{"H", "this sheet; type to search"}, always, {'H', GLFW_KEY_F1}, switches(&Dialogs::help)},
      {{"Double click a value", "type it"}},
      {{"Right click", "reset, copy"}},
      {{"Ctrl+Q", "quit"}, with_ctrl, {'Q'}, asks(&C::quit)},
  };
  static const std::array<Shortcuts, 3> k_shortcuts = {k_direction, k_view, k_program};
  return k_shortcuts;
}

bool acts(When when, const KeyPress& press, const AppState& state) {
  if (when == When::always) return true;
  if (when == When::with_ctrl) return press.ctrl;
  return state.model && (when == When::part || !press.ctrl);
}

}  // namespace

bool in_presentation(const KeyPress& press) {
  constexpr std::array<int, 4> k_keys = {GLFW_KEY_F5, GLFW_KEY_F12, GLFW_KEY_SPACE, GLFW_KEY_ESCAPE};
  return std::ranges::find(k_keys, press.key) != k_keys.end();
}

bool leaves(const KeyPress& press) { return press.key == GLFW_KEY_ESCAPE; }

bool ends_program(const KeyPress& press) { return press.ctrl && press.key == 'Q'; }

void apply_shortcut(KeyPress press, const AppState& state, Edits& edits) {
  // Keyboards without a number pad have its keys with Shift.
  if (press.shift && press.key >= '0' && press.key <= '9') press.key += GLFW_KEY_KP_0 - '0';
  for (const Shortcuts& group : shortcuts())
    for (const Shortcut& each : group) {
      const bool meant = std::ranges::find(each.keys, press.key) != each.keys.end();
      if (meant && acts(each.when, press, state)) return each.act({press, state, edits});
    }
}

std::vector<HelpLine> help_lines(HelpLine::Group group) {
  std::vector<HelpLine> lines;
  std::ranges::transform(shortcuts()[static_cast<std::size_t>(group)], std::back_inserter(lines),
                         &Shortcut::help);
  return lines;
}

}  // namespace moldlight::gui
