#include "gui/input/shortcuts.hpp"

#include <GLFW/glfw3.h>

#include "gui/direction.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_nudge_deg = 1.0, k_fine_nudge_deg = 0.1;

/// Arrow keys move the direction's tip on the screen.
bool nudge(const KeyPress& press, const AppState& state, Edits& edits) {
  const glm::dvec3 right = state.camera.right(), up = state.camera.up(), back = state.camera.toward_viewer();
  glm::dvec3 toward(0.0);
  switch (press.key) {
    case GLFW_KEY_LEFT:
      toward = -right;
      break;
    case GLFW_KEY_RIGHT:
      toward = right;
      break;
    case GLFW_KEY_UP:
      toward = up;
      break;
    case GLFW_KEY_DOWN:
      toward = -up;
      break;
    default:
      return false;
  }
  glm::dvec3& direction = edits.settings.method.direction;
  direction = nudged(direction, toward, back, press.shift ? k_fine_nudge_deg : k_nudge_deg);
  return true;
}

bool control_key(const KeyPress& press, const AppState& state, Edits& edits) {
  switch (press.key) {
    case GLFW_KEY_Z:
      press.shift ? edits.ask(Redo{}) : edits.ask(Undo{});
      return true;
    case GLFW_KEY_Y:
      edits.ask(Redo{});
      return true;
    case GLFW_KEY_O:
      edits.dialogs.browser = true;
      return true;
    case GLFW_KEY_E:
      edits.dialogs.exporting = state.model != nullptr;
      return true;
    default:
      return false;
  }
}

/// Views as on the number pad of other programs; with Ctrl from the other side.
bool view_key(const KeyPress& press, Edits& edits) {
  const auto look = [&](StandardView view, StandardView opposite) {
    edits.ask(LookFrom{standard_orientation(press.ctrl ? opposite : view)});
    return true;
  };
  switch (press.key) {
    case GLFW_KEY_1:
    case GLFW_KEY_KP_1:
      return look(StandardView::front, StandardView::back);
    case GLFW_KEY_3:
    case GLFW_KEY_KP_3:
      return look(StandardView::right, StandardView::left);
    case GLFW_KEY_7:
    case GLFW_KEY_KP_7:
      return look(StandardView::top, StandardView::bottom);
    case GLFW_KEY_0:
    case GLFW_KEY_KP_0:
      edits.ask(LookAlongDirection{});
      return true;
    case GLFW_KEY_5:
    case GLFW_KEY_KP_5:
      edits.ask(ToggleProjection{});
      return true;
    case GLFW_KEY_F:
      edits.ask(FitView{});
      return true;
    default:
      return false;
  }
}

/// The best direction beside the present one, then the next ones, then none.
void compare(const AppState& state, Edits& edits) {
  auto& compared = edits.sweep_choices.compared;
  const std::size_t count = state.sweep.result ? state.sweep.result->candidates.size() : 0;
  const std::size_t next = compared ? *compared + 1 : 0;
  compared = next < count ? std::optional(next) : std::nullopt;
}

void part_key(const KeyPress& press, const AppState& state, Edits& edits) {
  LookSettings& look = edits.settings.look;
  MethodSettings& method = edits.settings.method;
  switch (press.key) {
    case GLFW_KEY_X:
      method.direction = tidy(-method.direction);
      return;
    case GLFW_KEY_N:
      edits.ask(TakeNormal{});
      return;
    case GLFW_KEY_A:
      edits.ask(TakeAxis{});
      return;
    case GLFW_KEY_B:
      edits.bookmarks.push_back(
          {.note = direction_text(method.direction), .direction = tidy(method.direction)});
      edits.ask(Say{"Bookmark kept: " + direction_text(method.direction)});
      return;
    case GLFW_KEY_W:
      state.sweep.running ? edits.ask(CancelSweep{}) : edits.ask(StartSweep{});
      return;
    case GLFW_KEY_M:
      edits.sweep_choices.large_ball = !edits.sweep_choices.large_ball;
      return;
    case GLFW_KEY_C:
      compare(state, edits);
      return;
    case GLFW_KEY_O:
      look.open_mold = look.open_mold > 0.0 ? 0.0 : 0.5;
      return;
    case GLFW_KEY_S:
      look.section = !look.section;
      return;
    case GLFW_KEY_D:
      look.colouring = look.colouring == Colouring::regions ? Colouring::draft : Colouring::regions;
      return;
    case GLFW_KEY_P:
      look.palette = look.palette == Palette::paper ? Palette::colour_blind_safe : Palette::paper;
      return;
    case GLFW_KEY_F12:
      edits.ask(TakePicture{});
      return;
    default:
      return;
  }
}

}  // namespace

bool ends_program(const KeyPress& press) { return press.ctrl && press.key == GLFW_KEY_Q; }

void apply_shortcut(const KeyPress& press, const AppState& state, Edits& edits) {
  switch (press.key) {
    case GLFW_KEY_ESCAPE: {
      edits.give_up_drag = true;
      const bool hidden = edits.dialogs.panels_hidden;
      edits.dialogs = {};
      edits.dialogs.panels_hidden = hidden;
      edits.sweep_choices.compared.reset();
      edits.sweep_choices.large_ball = false;
      if (state.face) edits.ask(ChooseFace{});
      edits.ask(DismissToasts{});
      return;
    }
    case GLFW_KEY_H:
    case GLFW_KEY_F1:
      edits.dialogs.help = !edits.dialogs.help;
      return;
    case GLFW_KEY_TAB:
      edits.dialogs.panels_hidden = !edits.dialogs.panels_hidden;
      return;
    case GLFW_KEY_T:
      edits.window.theme = edits.window.theme == Theme::dark ? Theme::light : Theme::dark;
      return;
    default:
      break;
  }
  if (ends_program(press)) {
    edits.ask(Quit{});
    return;
  }
  if (press.ctrl && control_key(press, state, edits)) return;
  if (!state.model) return;
  if (view_key(press, edits) || nudge(press, state, edits) || press.ctrl) return;
  part_key(press, state, edits);
}

}  // namespace moldlight::gui
