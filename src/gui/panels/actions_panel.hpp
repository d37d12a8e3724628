// The undercuts along the bottom, a row each, with the side actions that release them.
#pragma once

#include <memory>
#include <optional>

#include "gui/draw/bottom_panel.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

class ActionsPanel {
 public:
  /// Nothing for a part without undercuts.
  void draw(const PanelContext& context);

 private:
  void draw_header(const PanelContext& context, bool open);
  void draw_settings(const PanelContext& context) const;
  void draw_table(const PanelContext& context);
  void draw_row(const PanelContext& context, std::size_t undercut);

  RowCursor cursor_;
  bool settings_ = false;
};

}  // namespace moldlight::gui
