// What `classify` writes, from the window.
#pragma once

#include <array>
#include <string>

#include "gui/panels/panels.hpp"

namespace moldlight::gui {

class ExportDialog {
 public:
  /// Draws the dialog while it is open; asks for the export when it is confirmed.
  void draw(const PanelContext& context);

 private:
  [[nodiscard]] Export chosen() const;

  bool open_ = false;
  std::array<char, 1024> base_{};  // path without extension
  bool json_ = true, facets_ = false, faces_ = false, mesh_ = true, split_ = false, borders_ = false,
       picture_ = true;
  int mesh_format_ = 0;
};

}  // namespace moldlight::gui
