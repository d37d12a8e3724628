// The window's own file browser: no dialog program of the desktop is needed.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "gui/panels/panels.hpp"

namespace moldlight::gui {

class FileBrowser {
 public:
  /// Draws the dialog while it is open; asks to open the part that is chosen.
  void draw(const PanelContext& context);

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    std::uintmax_t bytes = 0;
  };
  void enter(const std::filesystem::path& folder);
  void draw_head(const PanelContext& context);
  void draw_list(const PanelContext& context);

  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string problem_;
  std::array<char, 128> filter_{};
  bool all_files_ = false;
  bool open_ = false;
};

}  // namespace moldlight::gui
