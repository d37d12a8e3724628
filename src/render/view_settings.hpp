// How the part is shown. Nothing here changes what it is classified as.
#pragma once

#include <cstdint>
#include <optional>

#include "mesh/triangle_mesh.hpp"
#include "mold/region.hpp"

namespace moldlight {

enum class Theme : std::uint8_t { dark, light };
enum class ColourMode : std::uint8_t { regions, draft_angle, plain };
/// What lies behind the part: the theme's gradient, one colour, or nothing (alpha 0).
enum class Backdrop : std::uint8_t { gradient, flat, none };

/// What tells the regions: the computed ones of the split surface, or look-ups in the shadow maps. Where a
/// subject has but one of them, it is that.
enum class RegionsBy : std::uint8_t { exact, maps };

/// Lengths are in the unit frame. What is changed here restarts the refinement of a picture at rest.
struct ViewSettings {
  Theme theme = Theme::dark;
  Backdrop backdrop = Backdrop::gradient;
  Palette palette = Palette::paper;
  ColourMode colour_mode = ColourMode::regions;
  RegionsBy regions_by = RegionsBy::exact;
  bool mark_difference = false;  // where shadow maps and exact regions differ
  bool hatch_undercut = true;
  bool feature_edges = true;  // edges sharper than the crease angle, and open ones
  bool facet_edges = false;
  bool contour_edges = false;  // of the parting direction: convex ones light, concave ones dark
  bool near_vertical = false;  // level lines on facets that are neither up nor down
  bool parting_arrows = false;
  bool ambient_occlusion = true;
  double tau_deg = 1.0;         // for the scale of the draft colours
  double open_mold = 0.0;       // core surface moves by this along +d, cavity surface along -d; [0, 1]
  double others_opacity = 1.0;  // of everything but the undercuts, [0, 1]
  std::optional<double> section =
      {};                    // what lies beyond this offset along +d from the frame's origin is cut away
  double pixel_scale = 1.0;  // widths of lines and hatches in units of a pixel
  int samples = 16;          // pictures at rest average this many shifted ones, [1, 64]

  bool operator==(const ViewSettings&) const = default;
};

/// What is marked on top of a finished picture; changing it costs next to nothing.
struct ViewMarks {
  std::optional<FacetIndex> hovered = {};   // under the cursor
  std::optional<FacetIndex> blocking = {};  // what is in the hovered point's way
  double undercut_glow = 0.0;               // [0, 1]: for a pulse when an undercut appears

  bool operator==(const ViewMarks&) const = default;
};

}  // namespace moldlight
