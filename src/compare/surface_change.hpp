// Surface of two parts that is new or gone, and surface of both that is of another region: by place.
#pragma once

#include <cstdint>
#include <vector>

#include "compare/left_overs.hpp"
#include "compare/overlay.hpp"

namespace moldlight {

/// An area and how far it may be off, the part's unit squared.
struct MeasuredArea {
  double area = 0.0, error = 0.0;
};

/// Surface of either part that hangs together and is farther from the other part than the tolerance
/// somewhere. Lengths are in the part's unit.
struct ChangedPlace {
  MeasuredArea gone, added;  // of A alone, of B alone
  MeasuredVolume volume;     // that came, negative: that went; where both parts are closed
  bool joined = false;       // of places that do not enclose what came or went each by itself
  glm::dvec3 centre{0.0};    // of the area
  Bounds bounds{};
};

/// Surface in both parts that hangs together and changes its region.
struct ChangedRegion {
  Region from = Region::core, to = Region::core;
  double area = 0.0;
  glm::dvec3 centre{0.0};
  Bounds bounds{};
};

struct SurfaceChange {
  OverlayTolerance tolerance;
  double chords = 0.0;  // the most that the tessellations are taken to be off, both together
  MeasuredArea gone, added;
  bool closed = false;                 // both parts are, so that volumes are known
  double volume_elsewhere = 0.0;       // that came off all places: tolerance or tessellation explain it
  std::vector<ChangedPlace> places;    // the largest first
  std::vector<ChangedRegion> regions;  // the largest first; of less than a speck left out
  Overlay of_a, of_b;                  // of A on B, and the reverse
  /// Place of each of their left-over pieces, and region change of each of of_a.regions; or k_no_change:
  /// what the tolerance or the tessellation explains.
  std::vector<std::uint32_t> place_of_a, place_of_b, change_of_region;
  /// Places of left-over pieces as above, with what is explained but touches a place: the thin ends of what
  /// came or went.
  std::vector<std::uint32_t> touched_of_a, touched_of_b;

  [[nodiscard]] bool any() const { return !places.empty() || !regions.empty(); }
  /// Area of all that changes its region.
  [[nodiscard]] double other_region() const {
    double sum = 0.0;
    for (const ChangedRegion& region : regions) sum += region.area;
    return sum;
  }
};

/// Of a part and its equal: each piece lies on itself.
[[nodiscard]] SurfaceChange no_surface_change(const OverlaySide& side, const OverlayTolerance& tolerance);
/// `apart` is the tolerance in the part's unit, > 0. Throws Cancelled.
[[nodiscard]] SurfaceChange find_surface_change(const OverlaySide& a, const OverlaySide& b,
                                                const OverlayTolerance& tolerance, const Progress& progress);

}  // namespace moldlight
