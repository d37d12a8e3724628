#include "gui/store/settings.hpp"

namespace moldlight::gui {

std::span<const Option<WindowSettings>> window_options() {
  using S = WindowSettings;
  static const std::vector<Option<S>> k_options = {
      {"theme", "--theme", "Theme", "", "Dark or light window.",
       moldlight::choice<&S::theme>({"dark", "light"})},
      {"ui_scale", "--ui-scale", "Size", "", "Size of text and panels, on top of the monitor's own scale.",
       RealKind<S>{&S::ui_scale, 0.5, 3.0, 0.05}},
      {"navigation", "--navigation", "Navigation", "", "Which mouse buttons turn, shift and zoom.",
       moldlight::choice<&S::navigation>({"standard", "solidworks", "fusion", "blender"})},
      {"motion", "--motion", "Motion", "", "Animate camera flights and fades.", SwitchKind<S>{&S::motion}},
      {"auto_reload", "--auto-reload", "Reload", "", "Read the part again when its file changes.",
       SwitchKind<S>{&S::auto_reload}},
      {"quick_sweep", "--quick-sweep", "Sweep", "",
       "Look for the best directions by itself once a part is loaded; anew when settings have changed.",
       SwitchKind<S>{&S::quick_sweep}},
      {"halves", "--halves", "Halves", "",
       "How an opened mold is seen: as the part's own surface moved apart, or as its halves of steel, "
       "through "
       "which the part shows if they are clear. While the Mold panel is open, sections cut the closed mold, "
       "too.",
       moldlight::choice<&S::halves>({"surface", "solid", "clear"})},
  };
  return k_options;
}

}  // namespace moldlight::gui
