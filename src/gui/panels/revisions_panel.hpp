// What differs between the part and another revision of it, along the bottom: a row a change.
#pragma once

#include "gui/draw/bottom_panel.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

class RevisionsPanel {
 public:
  /// Nothing where nothing is compared.
  void draw(const PanelContext& context);

 private:
  void draw_header(const PanelContext& context, bool open);
  void draw_settings(const PanelContext& context) const;
  void draw_table(const PanelContext& context);
  void draw_row(const PanelContext& context, std::size_t change);

  RowCursor cursor_;
  bool settings_ = false;
};

}  // namespace moldlight::gui
