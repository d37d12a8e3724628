// Everything the window shows, as plain values. Panels read it; only the app writes it.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/job.hpp"
#include "gui/jobs/actions_state.hpp"
#include "gui/jobs/loaded_part.hpp"
#include "gui/jobs/mold_state.hpp"
#include "gui/jobs/revision_state.hpp"
#include "gui/jobs/sweep_state.hpp"
#include "gui/store/part_notes.hpp"
#include "gui/store/settings.hpp"
#include "gui/store/user_state.hpp"
#include "gui/view/measuring.hpp"
#include "gui/view/surface.hpp"
#include "mold/map_frame.hpp"
#include "render/camera.hpp"
#include "study/verdict.hpp"

namespace moldlight::gui {

struct BatchTable;

/// The measured figures and how far they may be trusted.
struct Figures {
  std::optional<Classification> shown = {};
  std::shared_ptr<const SplitMesh> split = {};       // of the present settings; none while it is not there
  std::shared_ptr<const PieceSamples> samples = {};  // of the split mesh, for comparing the maps with it
  // Of the maps from which the regions shown come; none if they do not.
  std::shared_ptr<const MapComparison> maps = {};
  std::optional<UndercutTotals> undercuts = {};  // not known while the direction moves
  bool stale = false;                            // of other settings than the present ones
  bool pale = false;                             // so for long enough to be shown as such
  bool measuring = false;                        // more is to come: other figures, or the split mesh
  std::uint64_t revision = 0;                    // rises when others are shown
  std::string error = {};                        // why there are none
};

struct Loading {
  std::string path;
  JobStatus status;
  PartNotes notes;  // to be taken with the part, if it is another one
};

struct Toast {
  int number = 0;  // counts up, so that it keeps its place and size when an older one goes
  std::string text;
  bool failure = false;
  double until_s = 0.0;
};

/// Which dialogs are open.
struct Dialogs {
  bool panels_hidden = false, help = false, settings = false, browser = false, exporting = false,
       batch = false, exporting_mold = false;
  bool browser_compares = false;       // the browser is for another revision
  std::optional<std::string> dropped;  // path of a part that is to be opened or compared
  std::optional<bool> large_map;       // true: of +d
  std::optional<std::string> picture;  // to be saved, with the path that is proposed

  bool operator==(const Dialogs&) const = default;
};

/// What panels, mouse and keys change: they edit a copy of it, which the app takes over after the frame.
struct Editable {
  EditedSettings settings;
  ReadOptions reading;  // of the part that is shown; another unit or body reads it again
  WindowSettings window;
  std::vector<Bookmark> bookmarks;
  Camera camera;
  Dialogs dialogs;
  SweepChoices sweep_choices;
  ActionChoices action_choices;
  MoldChoices mold_choices;
  RevisionChoices revision_choices;
  std::optional<Measuring> measuring;  // the tool, while it is on
  std::set<Hint> hints_done;
};

struct AppState : Editable {
  std::shared_ptr<const PartModel> model;  // none: the start page
  std::shared_ptr<const Faces> faces;      // of the model
  std::vector<glm::vec3> extremes;         // of the part: its outermost points, unit frame
  std::string path;                        // of the part, absolute
  std::vector<FeatureDirection> features;
  std::vector<std::string> recent, shipped;  // parts to offer; paths
  Figures figures;
  SweepState sweep;
  ActionsState actions;
  std::optional<Verdict> verdict;  // of the study; none while undercuts are not counted
  MoldState mold;
  RevisionState revisions;                  // of the part and another revision of it
  bool mold_open = false;                   // the panel of the mold is unfolded
  std::shared_ptr<const BatchTable> batch;  // none: no batch was opened
  std::optional<CutPlane> cut;              // by the section that is shown
  std::optional<Hover> hover;
  std::optional<CutSpan> span;     // under the cursor, where there is a section
  std::optional<ChosenFace> face;  // chosen by a click
  std::optional<Loading> loading;
  std::vector<Toast> toasts;
  bool can_undo = false, can_redo = false;
  bool shows_hints = false;   // to newcomers
  bool notes_beside = false;  // settings and bookmarks are saved beside the part
};

}  // namespace moldlight::gui
