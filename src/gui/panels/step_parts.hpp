// Common parts of the steps: the marks along the top, what a step says first, notes, and lists from which a
// row is chosen.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "gui/draw/bottom_panel.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

struct RowOptions;

/// Behind a step's name: a count, or a sign of how it stands; nothing while that is not known.
struct StepMark {
  enum class Sign : std::uint8_t { none, good, warning, working } sign = Sign::none;
  std::string text = {};  // a short one: a count, a direction
  std::string tip = {};   // what the step has, or what it needs
};
[[nodiscard]] StepMark step_mark(const AppState& state, Step step);

/// What a step remembers.
struct StepMemory {
  RowCursor cursor;
  bool settings = false;  // are shown in place of the rest
};

/// What a step says first.
struct StepNews {
  std::string text;
  bool warning = false;
  std::optional<double> progress = {};  // from 0 to 1, negative while it is not known
};
/// A gear beside it.
struct StepSettings {
  const char* id = nullptr;  // none: no gear
  const char* tip = "";
};
void draw_news(const PanelContext& context, StepMemory& memory, const StepNews& news,
               const StepSettings& settings = {});

/// Text over as many lines as it needs, with a sign before it.
struct Note {
  std::string_view text;
  std::optional<Icon> icon = {};
  bool warning = false;
  float alpha = 1.0F;
};
void draw_note(const Ui& ui, const Note& note);
/// A name at the left, what it is at the right.
void draw_fact(const Ui& ui, std::string_view name, std::string_view value);

/// A row's texts: a strong one in front, two at the ends of the first line, a quiet one below.
struct TwoLines {
  std::string number, name = {}, figure, below = {};
  ImU32 colour = 0, below_colour = 0;
  float room = 0.0F;              // at the right end for another control, layout units
  std::optional<ImU32> dot = {};  // before the name
};
inline constexpr float k_two_lines = 40.0F;  // height of such a row, layout units
void draw_two_lines(const Ui& ui, const ScreenBox& row, const TwoLines& texts);

/// A list of which a click chooses a row and looks at it, and a second click lets it go.
struct ChoiceTable {
  RowList list;
  const char* row;  // its rows are the controls "row 1", "row 2" …
  std::optional<std::size_t>& chosen;
  void (Commands::*look)(std::size_t);
  std::optional<std::size_t> pointed = {};    // the row that the mouse means elsewhere
  float beside = 0.0F;                        // of a row's right end, another control's; layout units
  std::span<const std::size_t> numbers = {};  // of the rows; empty: each its own
};
/// `draw_row` fills a row; the cursor may be anywhere afterwards.
void draw_choices(const PanelContext& context, const ChoiceTable& table, RowCursor& cursor,
                  const std::function<void(std::size_t, const ScreenBox&)>& draw_row);

/// Rows in which numbers are typed; one out of range is told.
[[nodiscard]] RowOptions typed_numbers(const PanelContext& context);

void draw_undercuts_step(const PanelContext& context, StepMemory& memory);
void draw_parting_line_step(const PanelContext& context, StepMemory& memory);
void draw_mold_step(const PanelContext& context, StepMemory& memory);
void draw_report_step(const PanelContext& context);
/// What a presentation says of the step, at the foot of the picture.
void draw_caption(const PanelContext& context);
/// What differs between the part and another revision of it, along the bottom: a row a change. Nothing where
/// nothing is compared.
void draw_revisions_panel(const PanelContext& context, StepMemory& memory);

}  // namespace moldlight::gui
