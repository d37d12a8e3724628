// What panels and mouse ask for in a frame. The app carries it out when the frame's windows are done.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "gui/app_state.hpp"
#include "session/write_outputs.hpp"

namespace moldlight::gui {

struct OpenPart {
  std::string path;
};
struct CancelLoading {};
struct Undo {};
struct Redo {};
struct FitView {};
/// Flies to where the part is seen from this side, and fits it.
struct LookFrom {
  glm::dquat orientation{1, 0, 0, 0};
};
/// Looks along the parting direction, onto the core.
struct LookAlongDirection {};
struct ToggleProjection {};
/// The direction becomes the normal of the facet (or the axis of the round wall) under the cursor.
struct TakeNormal {};
struct TakeAxis {};
/// The CAD face of the facet is chosen; of nothing, none is.
struct ChooseFace {
  std::optional<FacetIndex> facet;
};
struct TakePicture {};
struct SaveNotesBeside {
  bool beside = true;
};
struct ResetLayout {};
struct DismissToasts {};
struct Quit {};
struct StartSweep {};
struct CancelSweep {};
/// The parting direction turns to this one.
struct FlyToDirection {
  glm::dvec3 direction{0, 0, 1};
};
struct Say {
  std::string text;
  bool failure = false;
};
/// Files that `classify` would write too, each if its path is not empty.
struct Export {
  OutputPaths files;
  std::string picture;
};

using Command =
    std::variant<OpenPart, CancelLoading, Undo, Redo, FitView, LookFrom, LookAlongDirection, ToggleProjection,
                 TakeNormal, TakeAxis, TakePicture, SaveNotesBeside, ResetLayout, DismissToasts, Say, Export,
                 StartSweep, CancelSweep, FlyToDirection, ChooseFace, Quit>;

/// Values begin as they are in the state; commands are carried out in order after them.
struct Edits {
  EditedSettings settings;
  WindowSettings window;
  std::vector<Bookmark> bookmarks;
  Camera camera;
  Dialogs dialogs;
  SweepChoices sweep_choices;
  bool dragging = false;      // a drag is under way that is one step of undo
  bool give_up_drag = false;  // the drag is undone
  std::vector<Command> commands;

  explicit Edits(const AppState& state)
      : settings(state.settings),
        window(state.window),
        bookmarks(state.bookmarks),
        camera(state.camera),
        dialogs(state.dialogs),
        sweep_choices(state.sweep_choices) {}

  template <typename C>
  void ask(C command) {
    commands.emplace_back(std::move(command));
  }
};

}  // namespace moldlight::gui
