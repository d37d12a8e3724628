// Everything the window shows, as plain values. Panels read it; only the app writes it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/job.hpp"
#include "classify/settings.hpp"
#include "classify/surface_facts.hpp"
#include "gui/jobs/loaded_part.hpp"
#include "gui/jobs/revision_state.hpp"
#include "gui/store/part_notes.hpp"
#include "gui/store/user_state.hpp"
#include "render/camera.hpp"
#include "render/view_geometry.hpp"
#include "report/report.hpp"
#include "study/study.hpp"
#include "study/verdict_surface.hpp"
#include "sweep/direction_cards.hpp"
#include "sweep/sweep_map.hpp"

namespace moldlight::gui {

struct BatchTable;

/// A place on the strip along the top, in its order; each has a panel of its own and can be entered at any
/// time.
enum class Step : std::uint8_t { part, direction, undercuts, parting_line, draft, mold, report };

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

// Of bodies.

/// The file as one part, where it has several bodies, and what is known of each as a part of its own.
struct BodiesState {
  std::shared_ptr<const LoadedPart> whole;       // null where the file has one, or one alone was read
  std::vector<std::optional<Verdict>> verdicts;  // of each, along the direction; none while not known
};

// Of side actions.

/// What the user does beside the settings; panels edit a copy of it.
struct ActionChoices {
  std::optional<std::size_t> chosen;  // undercut of the plan whose action is shown
  std::optional<glm::dvec3> wish;  // direction given to its action by hand, until a plan has answered; unit
};

/// The solids that a plan's actions move.
struct ActionBodies {
  std::vector<ViewBody> bodies;
  std::vector<std::size_t> actions;  // of each
};

/// A plan outlives changes of the actions' settings until another one is there, but not its undercuts.
struct ActionsState {
  std::shared_ptr<const ActionPlan> plan;
  std::shared_ptr<const ActionBodies> bodies;                // of the plan
  std::shared_ptr<const std::vector<DesignChange>> changes;  // of its undercuts; null until they are known
  bool awaited = false;                                      // there will be another one
  bool changes_awaited = false;                              // they are looked for
  std::optional<JobStatus> running;                          // the search for it
  std::uint64_t revision = 0;                                // rises with every plan
  std::string error;                                         // why there is none
};

/// Whether the plan is of the present settings.
[[nodiscard]] inline bool is_settled(const ActionsState& actions) { return actions.plan && !actions.awaited; }

// Of the mold.

/// What the user does beside the settings; panels edit a copy of it.
struct MoldChoices {
  std::optional<std::size_t> loop;  // of the line, that is looked at
  bool moves_faces = false;         // a click moves a face to the other half
  /// Of the molds of several pieces that were found, which is looked at, at most the last; none: of two
  /// halves.
  std::optional<std::size_t> pieces;
};

// Of draft.

/// What the user does beside the settings; panels edit a copy of it.
struct DraftChoices {
  std::string kind = {};  // of the finish that a click gives to a face: "texture", "draft" or a name; empty:
                          // a click gives none
  double texture_mm = 0.025, draft_deg = 2.0;

  /// As parse_finish reads it.
  [[nodiscard]] std::string finish() const;
  bool operator==(const DraftChoices&) const = default;
};

/// The parting line as the study found it, and as it is drawn.
struct MoldLine : moldlight::MoldLine {
  std::string verdict = {};
  std::vector<std::vector<ViewSegment>> loops = {};  // each of the line, unit frame
  std::optional<DraftCheck> draft = {};              // at the required draft, if there is one
  MoldFrame frame = {};                              // of its block
};

/// The halves with their certificate, with slides and lifters once these are made, and as they are drawn.
struct MoldSolids {
  std::shared_ptr<const MoldHalves> plain;   // without slides
  std::shared_ptr<const MoldPieces> pieces;  // null while they are not made
  std::vector<ViewSolid> shown;  // core, cavity, what stands between them; none where there are no halves

  [[nodiscard]] const MoldHalves& halves() const { return pieces ? pieces->halves : *plain; }
};

/// A mold of several pieces, what each forms of the part as it is drawn, then its solids.
struct MoldOfPieces {
  std::shared_ptr<const PiecesResult> result;
  std::shared_ptr<const PieceSolids> solids;  // null where the directions are not enough
  std::shared_ptr<const std::vector<ViewBody>> bodies;

  [[nodiscard]] bool has_solids() const { return solids && solids->refusal.empty(); }
};

/// A line outlives changes of the mold's settings until another one is there, but not those of the direction;
/// so do halves.
struct MoldState {
  std::shared_ptr<const MoldLine> line;
  std::shared_ptr<const MoldSolids> solids;
  std::vector<MoldOfPieces> pieces;                   // of two directions on, until they are enough
  bool line_awaited = false, solids_awaited = false;  // there will be others
  std::optional<JobStatus> running;                   // the search for one of them
  std::string error;                                  // why there is none
};

/// Whether both are of the present settings.
[[nodiscard]] inline bool is_settled(const MoldState& mold) {
  return mold.line && mold.solids && !mold.line_awaited && !mold.solids_awaited;
}

// Of a sweep.

/// What the user sets about the sweep; panels edit a copy of it.
struct SweepChoices {
  SweepSettings options;                // the method is the window's when the sweep starts
  std::optional<std::size_t> compared;  // candidate of the result that is seen beside the direction
  bool large_ball = false;
};

struct SweepProgress {
  std::string stage;
  double share = 0.0;  // of the whole sweep, [0, 1]
  std::optional<double> left_s;
  bool ending = false;  // cancelled; what is done is being gathered
};

struct SweepState {
  std::optional<SweepProgress> running;
  std::optional<SweepMap> map;
  /// Of the last sweep that ended; of one that runs by itself what it knew before its search.
  std::shared_ptr<const SweepResult> result;
  std::vector<DirectionCard> cards;  // of the result, beside the direction at rest
  bool stale = false;                // the method, or what is allowed of side actions, has changed since
  bool by_itself = false;            // nobody asked for it
  std::string error;                 // why there is no result
};

struct Loading {
  std::string path;
  JobStatus status;
  PartNotes notes;  // to be taken with the part, if it is another one
  bool batch = false;
  double since_s = 0.0;
};

struct Toast {
  int number = 0;  // counts up, so that it keeps its place and size when an older one goes
  std::string text;
  bool failure = false;
  double until_s = 0.0;
};

/// Of a presentation that runs.
struct Presented {
  std::string caption;
  double time_s = 0.0;  // since it began
  bool paused = false, recording = false;
  unsigned fading = 0;  // a picture over this one
  double fade = 0.0;    // how much of it is left
};

/// Which dialogs are open.
struct Dialogs {
  bool panels_hidden = false, help = false, settings = false, browser = false, exporting = false,
       batch = false, exporting_mold = false;
  bool browser_compares = false;       // the browser is for another revision
  std::optional<std::string> dropped;  // path of a part that is to be opened or compared
  std::optional<bool> large_map;       // true: of +d
  std::optional<std::string> picture;  // to be saved, with the path that is proposed
  std::optional<bool> finishes;        // true: to be saved; false: to be loaded
  std::optional<int> film;             // to be made: a GIF, or 1: an MP4

  /// All closed.
  [[nodiscard]] Dialogs none() const {
    Dialogs closed;
    closed.panels_hidden = panels_hidden;
    return closed;
  }
  bool operator==(const Dialogs&) const = default;
};

/// Of the tour through the window: where it is, and since when.
struct Tour {
  std::size_t stop = 0;
  double since_s = 0.0;
  bool operator==(const Tour&) const = default;
};

/// What panels, mouse and keys change: they edit a copy of it, which the app takes over after the frame.
struct Editable {
  EditedSettings settings;
  ReadOptions reading;  // of the part that is shown; another unit or body reads it again
  WindowSettings window;
  std::vector<Bookmark> bookmarks;
  Camera camera;
  Step step = Step::direction, former_step = Step::direction;
  Dialogs dialogs;
  SweepChoices sweep_choices;
  ActionChoices action_choices;
  MoldChoices mold_choices;
  DraftChoices draft_choices;
  RevisionChoices revision_choices;
  std::optional<std::size_t> body;      // of the whole file, that is looked at
  std::set<std::size_t> hidden_bodies;  // of the whole file, in the picture
  std::optional<Measuring> measuring;   // the tool, while it is on
  std::optional<Subject> lit;           // on the part, while the mouse is on its line
  // Of the regions of the maps on the left from exact ones on the right: its place between the panels, [0,
  // 1].
  std::optional<double> divider;
  std::set<Hint> hints_done;
  std::optional<Tour> tour;
};

struct AppState : Editable {
  std::shared_ptr<const PartModel> model;  // none: the start page
  std::shared_ptr<const Faces> faces;      // of the model
  std::vector<glm::vec3> extremes;         // of the part: its outermost points, unit frame
  std::string path;                        // of the part, absolute
  std::vector<FeatureDirection> features;
  std::vector<std::string> recent, shipped;  // parts to offer; paths
  BodiesState bodies;
  Figures figures;
  SweepState sweep;
  ActionsState actions;
  std::optional<Verdict> verdict;  // of the study; none while undercuts are not counted
  MoldState mold;
  RevisionState revisions;                  // of the part and another revision of it
  std::shared_ptr<const BatchTable> batch;  // none: no batch was opened
  std::optional<CutPlane> cut;              // by the section that is shown
  std::optional<Hover> hover;
  std::optional<CutSpan> span;     // under the cursor, where there is a section
  std::optional<ChosenFace> face;  // chosen by a click
  std::optional<Loading> loading;
  std::optional<JobStatus> exporting;  // files are being written
  std::vector<Toast> toasts;
  std::optional<Presented> presented;  // then nothing else is on the screen
  std::vector<report::Picture> views;  // that the report is to have
  bool can_undo = false, can_redo = false;
  bool shows_hints = false;   // to newcomers
  bool notes_beside = false;  // settings and bookmarks are saved beside the part
};

/// Whether the picture has regions of the shadow maps, and of the direction at rest.
[[nodiscard]] inline bool maps_shown(const Editable& shown) {
  return shown.settings.look.regions_by == RegionsBy::maps || shown.divider;
}
/// Whether the step is open, and is what is looked at: two revisions beside each other have no step.
[[nodiscard]] inline bool is_at(const AppState& state, Step step) {
  return state.model && state.step == step && !state.revisions.on();
}
/// The mold of several pieces that is looked at; null for none.
[[nodiscard]] inline const MoldOfPieces* shown_pieces(const AppState& state) {
  const auto& chosen = state.mold_choices.pieces;
  const std::vector<MoldOfPieces>& found = state.mold.pieces;
  return chosen && !found.empty() && is_at(state, Step::mold) ? &found[std::min(*chosen, found.size() - 1)]
                                                              : nullptr;
}
/// Whether the parting line is looked at, with the handle of its height.
[[nodiscard]] inline bool looks_at_line(const AppState& state) {
  return is_at(state, Step::parting_line) || (is_at(state, Step::mold) && shown_pieces(state) == nullptr);
}

}  // namespace moldlight::gui
