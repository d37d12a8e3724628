// The mold along the bottom: its verdict, the loops of the parting line as a table to choose from, the halves
// with their certificate.
#pragma once

#include "gui/draw/bottom_panel.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

class MoldPanel {
 public:
  void draw(const PanelContext& context);

 private:
  void draw_header(const PanelContext& context, bool open);
  void draw_settings(const PanelContext& context) const;
  void draw_table(const PanelContext& context);
  void draw_row(const PanelContext& context, std::size_t loop);

  RowCursor cursor_;
  bool settings_ = false;
};

/// Not while directions are compared or chosen on the large ball, which leaves no room for it.
[[nodiscard]] bool has_mold_panel(const AppState& state);

/// Why there are no halves, where, and what to change; empty where there are. The solids must be there.
[[nodiscard]] std::string halves_refusal(const AppState& state);

/// A line of what is said of the halves.
struct HalvesLine {
  std::string text;
  bool doubt = false;  // something is to be done
};
[[nodiscard]] std::vector<HalvesLine> halves_lines(const AppState& state);

}  // namespace moldlight::gui
