// What the picture of the part shows, and how the window looks and behaves for its user, with their tables of
// options: all that is set in the window and changes no figure.
#pragma once

#include <cstdint>
#include <span>

#include "mold/region.hpp"
#include "render/view_settings.hpp"
#include "session/option.hpp"

namespace moldlight::gui {

enum class Colouring : std::uint8_t { regions, draft };

struct LookSettings {
  Palette palette = Palette::paper;
  Colouring colouring = Colouring::regions;
  double open_mold = 0.0;       // [0, 1]: how far core and cavity surface are moved apart along +-d
  double others_opacity = 1.0;  // [0.05, 1]: of all surface but the undercuts
  bool section = false;         // cut the part by a plane across d
  double section_height = 0.5;  // [0, 1] of the part's extent along d; what lies above is cut away
  bool hatching = true;         // stripes on undercuts
  bool feature_edges = true;
  bool facet_edges = false;
  bool near_vertical = false;               // mark near-vertical facets
  bool contour_edges = false;               // concave and convex contour edges of the direction
  bool arrows = true;                       // the parting arrows
  RegionsBy regions_by = RegionsBy::exact;  // of a direction at rest; one that moves has the maps' regions
  bool mark_difference = false;             // where shadow maps and exact regions differ

  bool operator==(const LookSettings&) const = default;
};

[[nodiscard]] std::span<const Option<LookSettings>> look_options();

enum class NavigationPreset : std::uint8_t { standard, solidworks, fusion, blender };

/// Whatever the part.
struct WindowSettings {
  Theme theme = Theme::dark;
  double ui_scale = 1.0;  // [0.5, 3], on top of the monitor's content scale
  NavigationPreset navigation = NavigationPreset::standard;
  bool motion = true;       // camera flights and fades
  bool auto_reload = true;  // when the part's file changes

  bool operator==(const WindowSettings&) const = default;
};

[[nodiscard]] std::span<const Option<WindowSettings>> window_options();

}  // namespace moldlight::gui
