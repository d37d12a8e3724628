// Everything the window shows, as plain values. Panels read it; only the app writes it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/chosen_face.hpp"
#include "gui/jobs/job.hpp"
#include "gui/loaded_part.hpp"
#include "gui/look_settings.hpp"
#include "gui/store/part_notes.hpp"
#include "gui/sweep_state.hpp"
#include "gui/window_settings.hpp"
#include "mold/draft.hpp"
#include "render/camera.hpp"
#include "render/part_view.hpp"
#include "session/classification.hpp"
#include "session/part_model.hpp"

namespace moldlight::gui {

/// What undo and redo go through.
struct EditedSettings {
  MethodSettings method;
  LookSettings look;

  bool operator==(const EditedSettings&) const = default;
};

/// What stands in a point's way.
struct Blocker {
  FacetIndex facet = 0;
  double distance = 0.0;  // model units, along the direction of removal
  bool above = true;      // towards +d
};

/// The surface under the cursor.
struct Hover {
  PickedPoint point;
  double draft_deg = 0.0;
  FacetClass facet_class = FacetClass::up;
  std::optional<Blocker> blocker;  // the nearest, where something blocks
};

/// The measured figures and how far they may be trusted.
struct Figures {
  std::optional<Classification> shown = {};
  std::shared_ptr<const SplitMesh> split = {};       // of the present settings; none while it is not there
  std::shared_ptr<const PieceSamples> samples = {};  // of the split mesh, for comparing the maps with it
  std::shared_ptr<const MapComparison> maps =
      {};                      // of the maps that tell the regions shown; none if they do not
  bool stale = false;          // of other settings than the present ones
  bool pale = false;           // so for long enough to be shown as such
  bool measuring = false;      // more is to come: other figures, or the split mesh
  std::uint64_t revision = 0;  // rises when others are shown
  std::string error = {};      // why there are none
};

struct Loading {
  std::string path;
  JobStatus status;
};

struct Toast {
  int number = 0;  // counts up, so that it keeps its place and size when an older one goes
  std::string text;
  bool failure = false;
  double until_s = 0.0;
};

/// Which dialogs are open.
struct Dialogs {
  bool panels_hidden = false, help = false, settings = false, browser = false, exporting = false;
  std::optional<bool> large_map;  // true: of +d

  bool operator==(const Dialogs&) const = default;
};

struct AppState {
  std::shared_ptr<const PartModel> model;  // none: the start page
  std::vector<glm::vec3> extremes;         // of the part: its outermost points, unit frame
  std::string path;                        // of the part, absolute
  EditedSettings settings;
  WindowSettings window;
  std::vector<Bookmark> bookmarks;
  std::vector<FeatureDirection> features;
  std::vector<std::string> recent, shipped;  // parts to offer; paths
  Camera camera;
  Figures figures;
  SweepChoices sweep_choices;
  SweepState sweep;
  std::optional<Hover> hover;
  std::optional<ChosenFace> face;  // chosen by a click
  std::optional<Loading> loading;
  std::vector<Toast> toasts;
  Dialogs dialogs;
  bool can_undo = false, can_redo = false;
  bool notes_beside = false;  // settings and bookmarks are saved beside the part
};

}  // namespace moldlight::gui
