#include "gui/commands.hpp"

#include <algorithm>
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
  if (!p.state.toasts.empty()) {
    p.edits.ask(&Commands::dismiss_toasts);
  } else if (p.edits.measuring) {
    p.edits.measuring.reset();
  } else if (choices.compared) {
    choices.compared.reset();
  } else if (choices.large_ball) {
    choices.large_ball = false;
  } else if (p.edits.action_choices.chosen) {
    p.edits.action_choices.chosen.reset();
  } else if (p.edits.mold_choices.moves_faces) {
    p.edits.mold_choices.moves_faces = false;
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

/// Views as on the number pad of other programs; with Ctrl from the other side.
void look_from_side(const Pressed& p) {
  const auto [view, opposite] =
      p.key.key == GLFW_KEY_KP_1   ? std::pair(StandardView::front, StandardView::back)
      : p.key.key == GLFW_KEY_KP_3 ? std::pair(StandardView::right, StandardView::left)
                                   : std::pair(StandardView::top, StandardView::bottom);
  p.edits.ask(&Commands::look_from, standard_orientation(p.key.ctrl ? opposite : view));
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

const std::vector<Shortcut>& shortcuts() {
  using enum HelpLine::Group;
  using enum When;
  using P = const Pressed&;
  const auto asks = [](void (Commands::*command)()) { return [=](P p) { p.edits.ask(command); }; };
  static const std::vector<Shortcut> k_shortcuts = {
      {{direction, "Drag the arrow's tip", "turn the parting direction"}},
      {{direction, "Ctrl while dragging", "snap to the part's own directions"}},
      {{direction, "Esc", "undo the drag, close what is open"}, always, {GLFW_KEY_ESCAPE}, escape},
      {{direction, "Double click", "direction: normal of the face there"}},
      {{direction, "Click", "choose the face there"}},
      {{direction, "Alt + double click", "direction: axis of that round wall"}},
      {{direction, "N / A", "the same for the face under the cursor"},
       part_no_ctrl,
       {'N', 'A'},
       [](P p) { p.edits.ask(p.key.key == 'N' ? &Commands::take_normal : &Commands::take_axis); }},
      {{direction, "Arrow keys", "turn by 1°, with Shift by 0.1°"},
       part,
       {GLFW_KEY_LEFT, GLFW_KEY_RIGHT, GLFW_KEY_UP, GLFW_KEY_DOWN},
       nudge},
      {{direction, "X", "flip"}, part_no_ctrl, {'X'}, [](P p) { p.direction = tidy(-p.direction.given()); }},
      {{direction, "B", "bookmark the direction"}, part_no_ctrl, {'B'}, keep_bookmark},
      {{direction, "Drag a side action's tip", "give it a direction of your own"}},
      {{direction, "Delete", "forget that direction"},
       part_no_ctrl,
       {GLFW_KEY_DELETE},
       forget_side_direction},
      {{direction, "V", "move the face at the cursor to the other half"},
       part_no_ctrl,
       {'V'},
       asks(&Commands::move_hovered_face)},
      {{direction, "Ctrl + click", "the same for the face there"}},
      {{direction, "W", "sweep: find directions, or cancel"},
       part_no_ctrl,
       {'W'},
       [](P p) {
         p.edits.enter(Step::direction);
         p.edits.ask(p.state.sweep.running ? &Commands::cancel_sweep : &Commands::start_sweep);
       }},
      {{direction, "C", "compare with the best, the next …"}, part_no_ctrl, {'C'}, compare_next},
      {{direction, "M", "map of directions, large"},
       part_no_ctrl,
       {'M'},
       [](P p) {
         p.edits.enter(Step::direction);
         p.edits.sweep_choices.large_ball = !p.edits.sweep_choices.large_ball;
       }},

      {{view, "1 … 7", "the steps: part, direction … report"},
       part_no_ctrl,
       {'1', '2', '3', '4', '5', '6', '7'},
       [](P p) { p.edits.enter(static_cast<Step>(p.key.key - '1')); }},
      {{view, "Shift + 1 / 3 / 7", "front, right, top; with Ctrl the opposite"},
       part,
       {GLFW_KEY_KP_1, GLFW_KEY_KP_3, GLFW_KEY_KP_7},
       look_from_side},
      {{view, "0", "along the parting direction"},
       part,
       {'0', GLFW_KEY_KP_0},
       asks(&Commands::look_along_direction)},
      {{view, "U", "the undercuts, from the best point of view"},
       part_no_ctrl,
       {'U'},
       asks(&Commands::look_at_undercuts)},
      {{view, "Shift + 5", "parallel or perspective"},
       part,
       {GLFW_KEY_KP_5},
       asks(&Commands::toggle_projection)},
      {{view, "F", "fit the part"}, part, {'F'}, asks(&Commands::fit_view)},
      {{view, "O / Space", "open or close the mold, or stop it"},
       part_no_ctrl,
       {'O', GLFW_KEY_SPACE},
       [](P p) {
         if (p.key.key == GLFW_KEY_SPACE) return p.edits.ask(&Commands::stop_opening);
         p.look.open_mold = p.look.open_mold < 1.0 ? 1.0 : 0.0;
         p.edits.ask(&Commands::fit_view);
       }},
      {{view, "G", "the mold, or back"},
       part_no_ctrl,
       {'G'},
       [](P p) { p.edits.enter_or_leave(Step::mold); }},
      {{view, "S", "section across, along the direction, none"},
       part_no_ctrl,
       {'S'},
       [](P p) { p.look.section = next_section(p.look.section); }},
      {{view, "R", "measure between two places, or end it"},
       part_no_ctrl,
       {'R'},
       [](P p) { p.edits.measuring = p.edits.measuring ? std::nullopt : std::optional(Measuring{}); }},
      {{view, "D", "colour by region or by draft angle"}, part_no_ctrl, {'D'}, colour_by_draft},
      {{view, "P", "palette"}, part_no_ctrl, {'P'}, [](P p) { take_the_other(p.look.palette); }},
      {{view, "T", "dark or light"}, always, {'T'}, [](P p) { take_the_other(p.edits.window.theme); }},

      {{program, "Ctrl+O", "open a part, or a batch's folder"},
       with_ctrl,
       {'O'},
       [](P p) {
         p.edits.dialogs.browser = true;
         p.edits.dialogs.browser_compares = false;
       }},
      {{program, "Ctrl+D", "compare with another revision, or leave it"},
       with_ctrl,
       {'D'},
       asks(&Commands::compare_or_leave)},
      {{program, "L", "the parts of the batch that is open"},
       always,
       {'L'},
       [](P p) { p.edits.dialogs.batch = p.state.batch && !p.edits.dialogs.batch; }},
      {{program, "Ctrl+E", "export"},
       with_ctrl,
       {'E'},
       [](P p) { p.edits.dialogs.exporting = p.state.model != nullptr; }},
      {{program, "F12", "picture with legend"}, part_no_ctrl, {GLFW_KEY_F12}, asks(&Commands::take_picture)},
      {{program, "Ctrl+Z / Ctrl+Y", "undo, redo"},
       with_ctrl,
       {'Z', 'Y'},
       [](P p) { p.edits.ask(p.key.shift || p.key.key == 'Y' ? &Commands::redo : &Commands::undo); }},
      {{program, "Tab, Space, arrows", "go to a control, press, change it"}},
      {{program, "Ctrl+Tab", "hide the panels"},
       with_ctrl,
       {GLFW_KEY_TAB},
       [](P p) { p.edits.dialogs.panels_hidden = !p.edits.dialogs.panels_hidden; }},
      {{program, "H", "this sheet; type to search"},
       always,
       {'H', GLFW_KEY_F1},
       [](P p) { p.edits.dialogs.help = !p.edits.dialogs.help; }},
      {{program, "Double click a value", "type it"}},
      {{program, "Right click", "reset, copy"}},
      {{program, "Ctrl+Q", "quit"}, with_ctrl, {'Q'}, asks(&Commands::quit)},
  };
  return k_shortcuts;
}

bool acts(When when, const KeyPress& press, const AppState& state) {
  if (when == When::always) return true;
  if (when == When::with_ctrl) return press.ctrl;
  return state.model && (when == When::part || !press.ctrl);
}

}  // namespace

bool leaves(const KeyPress& press) { return press.key == GLFW_KEY_ESCAPE; }

bool ends_program(const KeyPress& press) { return press.ctrl && press.key == 'Q'; }

void apply_shortcut(KeyPress press, const AppState& state, Edits& edits) {
  // Keyboards without a number pad have its keys with Shift.
  if (press.shift && press.key >= '0' && press.key <= '9') press.key += GLFW_KEY_KP_0 - '0';
  for (const Shortcut& each : shortcuts()) {
    const bool meant = std::ranges::find(each.keys, press.key) != each.keys.end();
    if (meant && acts(each.when, press, state)) return each.act({press, state, edits});
  }
}

std::vector<HelpLine> help_lines(HelpLine::Group group) {
  std::vector<HelpLine> lines;
  for (const Shortcut& each : shortcuts()) {
    if (each.help.group == group) lines.push_back(each.help);
  }
  return lines;
}

}  // namespace moldlight::gui
