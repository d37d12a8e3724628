// All panels of a frame, and what some of them remember.
#pragma once

#include <span>
#include <vector>

#include "gui/input/keys.hpp"
#include "gui/panels/export_dialog.hpp"
#include "gui/panels/file_browser.hpp"
#include "gui/panels/panels.hpp"
#include "gui/panels/sweep_panel.hpp"

namespace moldlight::gui {

class Workspace {
 public:
  struct Textures {
    MapTextures maps;
    std::span<const unsigned> shipped_parts;
    std::vector<unsigned> candidates;  // of the sweep, one each; 0 for none yet
  };
  void draw(const PanelContext& context, const Textures& textures);
  void give_up_drag() { ball_.active = large_ball_.active = false; }

 private:
  BallDrag ball_, large_ball_;
  SweepPanel sweep_;
  FileBrowser browser_;
  ExportDialog export_;
};

}  // namespace moldlight::gui
