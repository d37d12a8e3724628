// Common parts of the bars of undercuts, mold, draft and revisions: a line that says what there is, and
// below it, while the bar is unfolded, either its settings or a table to choose a row from.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "gui/draw/bottom_panel.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

struct RowOptions;

/// What a bar says in its line.
struct BarNews {
  std::string text;
  bool warning = false;
  std::optional<double> progress = {};  // from 0 to 1, negative while it is not known
  std::string tip = {};
};

struct TableBarParts {
  const char* name;                    // stands in the line, and the fold is kept under it
  const char* fold;                    // the names of its buttons among the controls
  const char* options = nullptr;       // without settings: nothing
  const char* options_hint = nullptr;  // what the settings are of
  const char* unfold_hint = "Unfold";
  BarNews news;
  std::function<void(BottomHeader&)> before = {};            // buttons right of these
  std::function<void(BottomHeader&, bool open)> after = {};  // and left of them
  std::function<void()> settings = {};
  std::function<void(RowCursor&)> table = {};  // none while there is nothing to show
};

class TableBar {
 public:
  void draw(const PanelContext& context, const TableBarParts& parts);

 private:
  void draw_line(const PanelContext& context, const TableBarParts& parts, bool open);

  RowCursor cursor_;
  bool settings_ = false;
};

/// The undercuts, a row each, with the side actions that release them. Nothing for a part without undercuts.
void draw_actions_bar(const PanelContext& context, TableBar& bar);
/// The mold's verdict, the loops of the parting line to choose from, the halves with their certificate.
void draw_mold_bar(const PanelContext& context, TableBar& bar);
/// What differs between the part and another revision of it: a row a change. Nothing where nothing is
/// compared.
void draw_revisions_bar(const PanelContext& context, TableBar& bar);

/// A table of which a click chooses a row and looks at it, and a second click lets it go.
struct ChoiceTable {
  RowList list;
  const char* row;  // its rows are the controls "row 1", "row 2" …
  std::optional<std::size_t>& chosen;
  void (Commands::*look)(std::size_t);
  std::optional<std::size_t> pointed = {};    // the row that the mouse means elsewhere
  float beside = 0.0F;                        // of a row's right end, another control's; layout units
  std::span<const std::size_t> numbers = {};  // of the rows; empty: each its own
  std::string tiny = {};                      // the last row, which cannot be chosen
};
/// `draw_row` fills a row; the cursor may be anywhere afterwards.
void draw_choices(const PanelContext& context, const ChoiceTable& table, RowCursor& cursor,
                  const std::function<void(std::size_t, const ScreenBox&)>& draw_row);

/// Rows in which numbers are typed; one out of range is told.
[[nodiscard]] RowOptions typed_numbers(const PanelContext& context);

}  // namespace moldlight::gui
