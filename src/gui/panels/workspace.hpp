// All panels of a frame, and what some of them remember.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gui/draw/sorted_table.hpp"
#include "gui/jobs/batch_table.hpp"
#include "gui/panels/step_panels.hpp"

namespace moldlight::gui {

/// The texture of a part's picture; 0 where there is none yet.
using BatchPicture = std::function<unsigned(const Digest&)>;

/// A batch's parts as a table along the bottom: filtered by typing, sorted by a click on a heading; a click
/// on a row, or an arrow key, opens the part with its settings.
class BatchPanel {
 public:
  void draw(const PanelContext& context, const BatchPicture& picture);

 private:
  void draw_row(const PanelContext& context, std::size_t index, const BatchPicture& picture);

  std::shared_ptr<const BatchTable> of_;  // of the rows; kept, so that no later one has its address
  SortedTable table_{{}, true};
  std::vector<batch::RowColumn> columns_;
  bool open_ = false;
};

/// The window's own file browser: no dialog program of the desktop is needed.
class FileBrowser {
 public:
  /// Draws the dialog while it is open; asks to open the part that is chosen.
  void draw(const PanelContext& context);

  /// What the list offers.
  struct Line {
    std::filesystem::path path;
    std::string note;  // its size, or where it is
    bool folder = false, recent = false;
  };

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    std::uintmax_t bytes = 0;
  };
  /// What the field asks for: a name to filter by, in the folder that is shown or in that of a path.
  struct Sought {
    std::filesystem::path folder;
    std::string name;
  };
  [[nodiscard]] Sought sought() const;
  void enter(const std::filesystem::path& folder);
  void scan(const std::filesystem::path& folder);
  /// The line that Return and the button stand for; -1: none.
  [[nodiscard]] int entered(const std::vector<Line>& shown) const;
  void draw_head(const PanelContext& context);
  /// Whether there is a line that can be opened.
  [[nodiscard]] bool draw_list(const PanelContext& context);
  /// Recent parts and the folder's entries, as far as the filter lets them through.
  [[nodiscard]] std::vector<Line> lines(const AppState& state) const;

  std::filesystem::path folder_, scanned_;
  std::optional<std::filesystem::path> next_;  // the folder to go to
  std::vector<Entry> entries_;
  std::string problem_;
  std::array<char, 1024> filter_{};
  bool all_files_ = false;
  bool open_ = false, starts_ = false;
  bool opens_ = false;  // the button was pressed
  int selected_ = -1;   // line that the arrow keys have gone to; -1: none
};

/// A dialog that asks for a path, and what is to be written there.
class PathDialog {
 public:
  struct Form {
    const char *name, *title = nullptr, *prompt, *action;  // without a title it is the name
    std::string proposed;                                  // path; another one replaces what was typed
  };
  /// Whether it can be confirmed; if not, what is waited for.
  struct Ready {
    bool now = true;
    std::string wait;
  };
  /// `draw_rows` has what is below the path. True when it was confirmed; then, and when it is left, `open` is
  /// set to false.
  bool draw(const Ui& ui, const Form& form, const std::function<Ready()>& draw_rows, bool& open);
  [[nodiscard]] std::string path() const { return path_.data(); }
  /// What was typed is of no use any more.
  void forget() { proposed_.clear(); }

 private:
  std::string proposed_;
  std::array<char, 1024> path_{};
};

/// What `classify` writes, from the window.
class ExportDialog {
 public:
  /// Draws the dialog while it is open; asks for the export when it is confirmed.
  void draw(const PanelContext& context);

 private:
  PathDialog dialog_;  // its path has no extension
  bool json_ = true, facets_ = false, faces_ = false, mesh_ = true, split_ = false, borders_ = false,
       picture_ = true;
  int mesh_format_ = 0;
};

/// What `mold` writes, from the window.
class MoldExportDialog {
 public:
  /// Draws the dialog while it is open; asks for the export when it is confirmed.
  void draw(const PanelContext& context);

 private:
  PathDialog dialog_;
  bool solids_ = true, json_ = true, first_ = true;
  MoldFileSettings together_;
  std::vector<std::string_view> lines_;  // extensions of the files of the line
};

/// Asks where the first picture of a session goes.
void draw_picture_dialog(const PanelContext& context, PathDialog& dialog);
/// Asks which file the finishes of faces come from, or go to.
void draw_finishes_dialog(const PanelContext& context, PathDialog& dialog);

/// Asks where the film of a presentation goes.
void draw_film_dialog(const PanelContext& context, PathDialog& dialog);

/// All keys and what the mouse does; typing leaves the lines that have the words.
class HelpSheet {
 public:
  void draw(const PanelContext& context);

 private:
  std::array<char, 64> filter_{};
  bool open_ = false;
};

class Workspace {
 public:
  struct Textures {
    std::function<MapTextures(int)> maps;  // where they are looked at
    std::span<const unsigned> shipped_parts;
    std::vector<unsigned> candidates;  // of the sweep, one each; 0 for none yet
    PictureOf bodies;
    BatchPicture batch;
  };
  void draw(const PanelContext& context, const Textures& textures);
  void give_up_drag() {
    steps_.give_up_drag();
    large_ball_.active = false;
  }

 private:
  StepPanels steps_;
  BallDrag large_ball_;
  RevisionsBar revisions_;
  FileBrowser browser_;
  BatchPanel batch_;
  ExportDialog export_;
  MoldExportDialog mold_export_;
  PathDialog picture_, finishes_, film_;
  HelpSheet help_;
};

}  // namespace moldlight::gui
