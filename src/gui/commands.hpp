// Commands of panels, mouse and keys in a frame. The app carries them out when the frame's windows are done.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "classify/classify_report.hpp"
#include "gui/app_state.hpp"
#include "gui/input.hpp"
#include "parting/mold_files.hpp"
#include "report/part_report.hpp"

namespace moldlight::gui {

class App;

/// Where the files of a mold go; those without a path are not written.
struct MoldPaths {
  std::string folder;  // of the halves and inserts
  MoldFileSettings solids = {};
  std::string json;
  std::vector<std::string> lines;
};

/// Everything that the window can be asked to do beside changing a value. What each touches stands in
/// part_commands.cpp and app_revisions.cpp.
struct Commands {
  App& app;

  /// A part, or a batch's folder, whose table is shown.
  void open_part(const std::string& path);
  /// With the settings of its result.
  void open_batch_part(std::size_t row);
  void cancel_loading();
  void undo();
  void redo();
  void fit_view();
  /// Shows the part to others, or ends that; see Presentation.
  void present();
  void pause_presenting();
  /// The same into a file.
  void film(const std::string& path);
  /// The picture becomes one of the report's; none is any more.
  void keep_view();
  void forget_views();
  /// Leaves the mold as far open as it is, while it opens.
  void stop_opening();
  /// Flies to where the part is seen from this side, and fits it.
  void look_from(const glm::dquat& orientation);
  /// Looks along the parting direction, onto the core.
  void look_along_direction();
  /// Flies to where most of the undercuts is seen; without any to the largest mark that counts as none.
  void look_at_undercuts();
  /// Flies to the largest mark that counts as no undercut, and says why it is none.
  void look_at_speck();
  /// Flies to what a line of the verdict's card speaks of; of faults to the first.
  void look_at_subject(Subject subject);
  /// Flies to a body of the file; where one is molded, this one is from now on.
  void look_at_body(std::size_t body);
  /// Hides all others.
  void isolate_body(std::size_t body);
  /// The same for one undercut of the plan of side actions.
  void look_at_undercut(std::size_t undercut);
  /// And for one loop of the parting line.
  void look_at_loop(std::size_t loop);
  /// And for a wall with too little draft, whose face is chosen then.
  void look_at_wall(std::size_t wall);
  /// And for the worst wall of a finish, or all of its faces where none has too little draft.
  void look_at_finish(const std::string& finish);
  /// Gives the face of a facet the finish that is chosen, or takes it away where the face has it.
  void give_finish(FacetIndex facet);
  /// Replaces the finishes by those of a file; writes them to one.
  void load_finishes(const std::string& path);
  void save_finishes(const std::string& path);
  /// Gives a face, what may be of it, to the half that does not form most of it.
  void move_face(FacetIndex facet);
  /// The same for the one under the cursor.
  void move_hovered_face();
  void toggle_projection();
  /// The direction becomes the normal of the facet, or the axis of the round wall, under the cursor.
  void take_normal();
  void take_axis();
  /// The parting direction turns to this one.
  void fly_to_direction(const glm::dvec3& direction);
  /// Chooses the face of the facet; of nothing, none.
  void choose_face(const std::optional<FacetIndex>& facet);
  /// A picture beside those of this session; the first one asks where.
  void take_picture();
  void save_picture(const std::string& path);
  /// Writes files that `classify` would write too, and a picture, each if its path is not empty.
  void export_files(const OutputPaths& files, const std::string& picture);
  /// Writes what `mold` would write too.
  void export_mold(const MoldPaths& paths);
  void export_report(const report::ReportOrder& order);
  /// Gives up what is being written.
  void cancel_export();
  /// Compares the part with another revision of it, a file, beside it.
  void compare_with(const std::string& path);
  /// Asks for that file, or leaves the comparison.
  void compare_or_leave();
  void leave_revisions();
  /// Gives up what runs for the comparison.
  void cancel_revisions();
  /// The other revision becomes the part, and the part the one it is compared with.
  void exchange_revisions();
  /// Looks at a change in both pictures.
  void look_at_change(std::size_t change);
  void start_sweep();
  void cancel_sweep();
  void save_notes_beside(bool beside);
  void reset_layout();
  void dismiss_toasts();
  void say(const std::string& text, bool failure);
  void quit();
};

/// Values begin as they are in the state; commands are carried out in order after them.
struct Edits : Editable {
  bool dragging = false;      // a drag is under way that is one step of undo
  bool give_up_drag = false;  // the drag is undone
  std::vector<std::function<void(Commands&)>> commands;

  explicit Edits(const Editable& state) : Editable(state) {}

  /// Puts the direction among the bookmarks, under a note that shows it.
  void keep_bookmark();
  /// Opens the step's panel, with the view that suits it; leaves what belongs to the step before.
  void enter(Step wanted);
  /// The same, or back to the step before where this one is open.
  void enter_or_leave(Step wanted) { enter(step == wanted ? former_step : wanted); }

  /// ask(&Commands::open_part, path).
  template <typename... Parameters, typename... Arguments>
  void ask(void (Commands::*command)(Parameters...), const Arguments&... arguments) {
    commands.emplace_back([=](Commands& commands_) { (commands_.*command)(arguments...); });
  }
};

/// Whether a key ends the program, also while text is being typed.
[[nodiscard]] bool ends_program(const KeyPress& press);
/// Whether it has a meaning while the part is presented.
[[nodiscard]] bool in_presentation(const KeyPress& press);
/// Whether it is the key that closes and gives up.
[[nodiscard]] bool leaves(const KeyPress& press);
/// For keys pressed while no text is being typed.
void apply_shortcut(KeyPress press, const AppState& state, Edits& edits);

/// A line of the help sheet.
struct HelpLine {
  enum class Group : std::uint8_t { direction, view, program };
  const char *keys, *meaning;
};
/// Of keys and mouse; how the mouse moves the camera is the user's choice and not among them.
[[nodiscard]] std::vector<HelpLine> help_lines(HelpLine::Group group);

}  // namespace moldlight::gui
