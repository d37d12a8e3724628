// The undercuts along the bottom, a row each, with the side actions that release them.
#pragma once

#include <memory>
#include <optional>

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
  /// By the keyboard, where the table that was just drawn has it; `page` in rows.
  void choose_row(const PanelContext& context, int page);

  std::optional<int> marked_row_;  // by the keyboard
  bool row_moved_ = false, settings_ = false;
};

}  // namespace moldlight::gui
