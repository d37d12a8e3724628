// Common parts of the panels of undercuts, parting line, mold and draft: what there is in words, and below it
// either settings or a table to choose a row from; and the bar of revisions.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "gui/draw/bottom_panel.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

struct RowOptions;

/// What is said first.
struct BarNews {
  std::string text;
  bool warning = false;
  std::optional<double> progress = {};  // from 0 to 1, negative while it is not known
  std::string tip = {};
};

/// That something is being found: its stage, or `usual` while it has none.
[[nodiscard]] BarNews running_news(const std::optional<JobStatus>& running, const char* usual);

struct TableBarParts {
  const char* options =
      nullptr;  // name of the settings' button among the controls; without settings: nothing
  const char* options_hint = nullptr;  // what the settings are of
  BarNews news;
  std::function<void()> settings = {};
  std::function<void(RowCursor&)> table = {};  // none while there is nothing to show
};

class TableBar {
 public:
  /// Into the panel that is open, whose news may take some lines.
  void draw_inside(const PanelContext& context, const TableBarParts& parts);

 private:
  RowCursor cursor_;
  bool settings_ = false;
};

/// The undercuts, a row each, with the side actions that release them.
void draw_actions_panel(const PanelContext& context, TableBar& bar);
/// What the parting line is like, with its loops to choose from.
void draw_line_panel(const PanelContext& context, TableBar& bar);
/// The mold's halves with their certificate, and how far they are open.
void draw_mold_panel(const PanelContext& context, TableBar& bar);
/// What the bar of revisions remembers.
struct RevisionsBar {
  RowCursor cursor;
  bool settings = false;  // in place of the changes
};
/// What differs between the part and another revision of it, along the bottom: a row a change. Nothing where
/// nothing is compared.
void draw_revisions_bar(const PanelContext& context, RevisionsBar& bar);

/// A table of which a click chooses a row and looks at it, and a second click lets it go.
struct ChoiceTable {
  RowList list;
  const char* row;  // its rows are the controls "row 1", "row 2" …
  std::optional<std::size_t>& chosen;
  void (Commands::*look)(std::size_t);
  std::optional<std::size_t> pointed = {};     // the row that the mouse means elsewhere
  float beside = 0.0F;                         // of a row's right end, another control's; layout units
  std::span<const std::size_t> numbers = {};   // of the rows; empty: each its own
  std::string tiny = {};                       // the last row, which cannot be chosen
  void (Commands::*look_at_tiny)() = nullptr;  // what a click on it asks for
};
/// `draw_row` fills a row; the cursor may be anywhere afterwards.
void draw_choices(const PanelContext& context, const ChoiceTable& table, RowCursor& cursor,
                  const std::function<void(std::size_t, const ScreenBox&)>& draw_row);

/// Rows in which numbers are typed; one out of range is named.
[[nodiscard]] RowOptions typed_numbers(const PanelContext& context);

}  // namespace moldlight::gui
