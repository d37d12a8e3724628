// The window's program without its window: takes input, keeps the state, draws a frame into any framebuffer.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "gl/context.hpp"
#include "gl/objects.hpp"
#include "gui/app_state.hpp"
#include "gui/commands.hpp"
#include "gui/draw/imgui_session.hpp"
#include "gui/draw/panel_layout.hpp"
#include "gui/jobs/batch_table.hpp"
#include "gui/jobs/body_verdicts.hpp"
#include "gui/jobs/measurer.hpp"
#include "gui/jobs/revision_comparer.hpp"
#include "gui/jobs/study_finder.hpp"
#include "gui/jobs/window_sweep.hpp"
#include "gui/panels/workspace.hpp"
#include "gui/store/files.hpp"
#include "gui/store/history.hpp"
#include "gui/store/user_state.hpp"
#include "gui/view/candidate_pictures.hpp"
#include "gui/view/direction.hpp"
#include "gui/view/motion.hpp"
#include "gui/view/presentation.hpp"
#include "gui/view/revision_view.hpp"
#include "gui/view/side_actions.hpp"
#include "gui/view/viewport.hpp"
#include "io/film.hpp"
#include "render/rehearsal.hpp"

namespace moldlight::gui {

struct AppOptions {
  bool persistent = false;  // remember the user's state and the part's notes
  ReadOptions reading;
  UserState user;
  std::optional<WindowSettings> window;  // for this time only, where they are not the user's
  std::vector<std::string> shipped_parts;
  int picture_samples = ViewSettings{}.samples;  // that a picture at rest averages
  bool rehearses = false;                        // all that pictures are drawn by, in the first frames
  std::function<void()> wake = [] {};            // called from other threads when a frame is wanted
  Measurer::MakeContext make_context;
};

/// What the platform knows of a frame, beside what it gives ImGui.
struct FrameInput {
  glm::ivec2 size{0};          // pixels
  float content_scale = 1.0F;  // of the monitor
  double now_s = 0.0;          // rises from frame to frame
  InputQueue::Played played;
  std::vector<std::string> dropped;  // paths
};

/// `context` must be current at every call and outlive the app.
class App {
  /// Frames after an event, until ImGui has laid out what the event changed.
  static constexpr int k_settle_frames = 3;

 public:
  App(const gl::Context& context, AppOptions options);
  ~App();

  /// Starts to load a part, or a batch's table; what is shown stays until it is there.
  void open(const std::string& path);
  /// Compares the part that is shown, or is being loaded, with another revision of it.
  void compare_with(const std::string& path);
  /// Replaces the settings, for the part that is shown and the next one.
  void set_notes(const PartNotes& notes);

  /// Whether what to do next is shown at the things themselves; only where the window asks for it.
  void show_hints(bool shown) { state_.shows_hints = shown; }

  /// Where nobody has seen it yet, opens the shipped lid with a tour of the window; never again after that.
  void offer_tour();

  /// Readies fonts and style; then ImGui gets the frame's input, then frame() does the rest.
  void prepare(const FrameInput& input);
  void frame(const FrameInput& input);
  /// Draws what frame() left, over the whole target. Returns true while the picture is being refined.
  bool draw(const ViewTarget& target);

  /// When the next frame is wanted without any input: now_s or earlier means at once, infinity never.
  [[nodiscard]] double next_frame_s() const { return next_frame_s_; }
  [[nodiscard]] const AppState& state() const { return state_; }
  /// Where the controls of the last frame are: a slider or switch by its label, a choice's word as
  /// "label=word".
  [[nodiscard]] const std::map<std::string, ScreenBox, std::less<>>& controls() const {
    return imgui_.memory().controls;
  }
  /// The control that has the keyboard, by its name there; empty for none.
  [[nodiscard]] const std::string& focused() const { return imgui_.memory().focused; }
  /// The texts of the last frame.
  [[nodiscard]] const std::vector<DrawnText>& texts() const { return imgui_.memory().texts; }
  /// True while pictures on the start page are still to come, or something is to be rehearsed.
  [[nodiscard]] bool preparing() const { return rehearsal_ || (!state_.model && !thumbnails_.finished()); }
  /// True while figures, the split mesh, side actions, the mold, or a comparison are not there that will be.
  [[nodiscard]] bool measuring() const {
    return state_.model && (state_.figures.measuring || state_.actions.awaited ||
                            state_.actions.changes_awaited || state_.mold.line_awaited ||
                            state_.mold.solids_awaited || state_.mold.running || state_.revisions.awaited);
  }
  /// True while a sweep runs, or is about to.
  [[nodiscard]] bool sweeping() const { return state_.sweep.running || quick_sweep_due_; }
  /// Path of the picture that F12 or the bar asked for since the last call.
  [[nodiscard]] std::optional<std::string> take_picture_request() {
    return picture_wait_ > 0 ? std::nullopt : std::exchange(picture_request_, std::nullopt);
  }
  /// To be called with where a picture went: the next ones go there too, and where is said.
  void picture_saved(const std::string& path);
  /// True once the user has asked to end the program.
  [[nodiscard]] bool quitting() const { return quitting_; }
  void say(std::string text, bool failure);
  /// False where it fails, which is said.
  bool attempt(const std::function<void()>& act);
  /// Asks all that runs in the background to end, without waiting for it.
  void end_jobs();
  /// Saves what is to be remembered; the part's notes alone.
  void save();
  void save_notes();

 private:
  friend struct Commands;
  /// Whether controls, and not the shortcuts, get the key.
  [[nodiscard]] bool takes_key(const KeyPress& press, bool typing) const;
  /// Escape for what lies over the panels, and for the control that has the keyboard; false if there is none.
  bool close_innermost(bool typing, Edits& edits);
  void poll_jobs();
  [[nodiscard]] bool loading_part() const { return state_.loading && !state_.loading->batch; }
  void load(const std::string& path, const ReadOptions& reading, PartNotes notes);
  /// Of a part that is to be opened: those that were set, or saved for it.
  [[nodiscard]] PartNotes notes_of(const std::string& path);
  void install(LoadedPart part, const PartNotes& notes);
  /// Texture of a body's picture; 0 where there is none yet.
  [[nodiscard]] unsigned body_picture(std::size_t body);
  void pick();
  void apply(const Edits& edits);
  /// Replaces the direction in one step of undo.
  void set_direction(const glm::dvec3& direction) {
    state_.settings.direction = tidy(direction);
    history_.settle(state_.settings);
  }
  [[nodiscard]] SceneSettings scene_settings() const;
  /// What is lit on the part in this frame; nothing where another picture is shown.
  [[nodiscard]] std::optional<Subject> lit_now() const;
  void light_subject();
  /// Hands what the picture's maps are worth to the panels of the next frame.
  void show_comparison();
  void plan_next_frame();
  [[nodiscard]] std::vector<unsigned> shipped_pictures(const Ui& ui);
  void open_batch(const std::string& path);
  /// What depends on the figures that are shown: the glow of a new undercut, those of the chosen face.
  void follow_figures();
  void measure_face();
  /// Outlines the chosen face, or those that have the finish which clicks give.
  void mark_faces();
  /// The undercut that is looked at stays so in another plan. `moving`: a hand is at the settings.
  void find_actions(bool moving);
  /// The loop that is looked at stays so in another line.
  void find_mold(bool moving);
  void compare_revisions(bool moving);
  /// Makes room for the other revision, or puts back what was there without it.
  void arrange_revisions();
  /// What a part dropped on the window is taken for, or a choice that is asked of the user.
  void take_dropped(const std::vector<std::string>& paths, Edits& edits);
  void turn_direction(bool held);
  /// The sweep that nobody asked for: once the part is measured. A hand that turns the direction wants the
  /// processor for itself; then, and when settings change, it begins anew at rest.
  void sweep_by_itself(bool dragging);
  /// Fits the part as it is seen from `camera`, at once or in a flight, and keeps it fitted: when a panel
  /// grows or the window changes, until the user moves the camera.
  void fit(const Camera& camera, bool at_once);
  /// The same in a flight to where it is seen from this side.
  void turn_camera(const glm::dquat& orientation);
  /// The same to where most undercut of a mesh is seen, with these points.
  void look_at(SplitMesh undercuts, std::vector<glm::vec3> points);
  void keep_fitted();
  /// Whether the picture has the mold's steel, once that is known.
  [[nodiscard]] bool steel_wanted() const;
  [[nodiscard]] bool line_shown() const;
  /// What a fit depends on beside the part: 0 without steel, else how far it opens, and whether with slides.
  [[nodiscard]] double steel_fit() const {
    const auto& solids = state_.mold.solids;
    return steel_wanted() ? (solids && solids->pieces ? 4.0 : 1.0) + state_.settings.look.open_mold : 0.0;
  }
  /// How far apart the parting arrows stand, as an opened mold moves them: out of its steel.
  [[nodiscard]] double arrows_apart(double open) const;
  /// What is seen of the mold that is so far open; `steel`: with its block.
  [[nodiscard]] std::vector<glm::vec3> points_shown(double open, bool steel) const;
  // app_present.cpp: the presentation, and the film of it.
  [[nodiscard]] Presentation made_presentation() const;
  void present();
  void end_presenting();
  void go_on_presenting();
  void add_to_film(const ViewTarget& target);
  void finish_film();
  /// How far the mold is open in this frame, in all that it moves.
  [[nodiscard]] double open_now() const { return presentation_ ? presented_.open : opening_.at(now_s_); }
  /// How far the mold is opened in this frame.
  [[nodiscard]] OpenedMold opened() const;
  /// How far the mold is to be open: closed where revisions are compared.
  [[nodiscard]] double wanted_opening() const { return revision_ ? 0.0 : state_.settings.look.open_mold; }
  /// What panels leave free of the picture; of its left half where it is split.
  [[nodiscard]] FreeArea fit_area() const;
  /// Of two directions, or of two revisions.
  [[nodiscard]] std::optional<SplitView> split_view() const;
  /// Width of what the panels take on either side of a split picture, pixels.
  [[nodiscard]] int split_side() const;

  const gl::Context* context_;
  gl::Tools tools_;
  std::optional<Rehearsal> rehearsal_;  // what of it is left
  AppOptions options_;
  AppState state_;
  History<EditedSettings> history_;
  ImguiSession imgui_;
  PanelLayout layout_;
  Workspace workspace_;
  Viewport viewport_;
  PartThumbnails thumbnails_;
  using Loaded = std::variant<LoadedPart, std::shared_ptr<const BatchTable>>;
  Job<Loaded> loader_;
  Job<std::string> export_;                 // results in what is to be said
  bool Dialogs::*export_dialog_ = nullptr;  // where it was asked for; none: in a panel
  FileWatch file_watch_;
  Measurer measurer_;
  StudyFinder study_;
  RevisionComparer comparer_;
  BodyVerdicts body_verdicts_;
  WindowSweep sweep_;
  std::unique_ptr<BatchPictures> batch_pictures_;
  std::unique_ptr<BodyPictures> body_pictures_;  // of the file's, once they are looked at
  std::unique_ptr<CandidatePictures> pictures_;  // of the sweep's result
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<RevisionPicture> revision_;  // of the one that is prepared
  LitBodies lit_;                              // of the part
  /// Of a line of the verdict's card, and what is drawn of it.
  std::optional<std::pair<Subject, std::shared_ptr<const SplitMesh>>> lit_subject_;
  std::shared_ptr<const std::vector<ViewBody>> sheets_;
  std::optional<std::string> compared_next_;  // with the part that is being loaded
  /// What a comparison hides.
  struct Before {
    Camera camera;
    bool fitted = false;
    SweepChoices sweep;
    std::optional<std::size_t> undercut, loop;
    std::shared_ptr<const ActionPlan> plan;  // of the undercut
    std::shared_ptr<const MoldLine> line;    // of the loop
  };
  std::optional<Before> before_revisions_;
  static constexpr int k_film_rate = 12;  // pictures a second
  std::optional<Presentation> presentation_;
  double presented_last_s_ = 0.0;
  Moment presented_;                            // in this frame
  std::optional<gl::ColourTarget> without_it_;  // the picture before what appeared last
  double appeared_s_ = 0.0;
  std::optional<Camera> camera_before_;  // the presentation
  std::unique_ptr<Film> film_;           // of the presentation that runs
  std::string film_path_;
  glm::ivec2 film_size_{0};
  bool film_waits_ = false;
  Flight<Camera> flight_;
  Flight<glm::dvec3> turn_;
  std::optional<Camera> fitted_;  // where the last fit leads
  FreeArea fitted_area_;
  double fitted_steel_ = 0.0;             // what it fitted
  std::vector<glm::vec3> fitted_points_;  // that it shows; empty: the whole part
  Opening opening_;
  Loop action_loop_;  // of the chosen action's body
  UndercutGlow glow_;
  std::optional<PartNotes> notes_to_set_;
  PartNotes saved_notes_;
  std::string noted_unit_;     // of the notes, or chosen in the window; not that of the command line
  WindowSettings begun_with_;  // what differs from it was changed in the window
  std::optional<std::string> picture_request_;
  int picture_wait_ = 0;  // frames until no dialog is in it
  std::string saved_to_;  // folder of the last export or picture of this session; empty: none yet
  glm::ivec2 size_{1};
  float scale_ = 1.0F;
  double now_s_ = 0.0, next_frame_s_ = 0.0;
  double controls_wake_s_ = std::numeric_limits<double>::infinity();  // when a control wants a frame
  int settle_frames_ = 3, fit_frames_ = 0;
  bool quitting_ = false;
  bool quick_sweep_due_ = false;
  std::uint64_t followed_ = 0;    // revision of the figures
  bool direction_moves_ = false;  // under a hand or in a flight, in this frame
  bool candidates_missing_ = false, was_split_ = false, refining_ = false;
};

}  // namespace moldlight::gui
