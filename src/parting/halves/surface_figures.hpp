// Figures of the parting surface: areas, slopes, and the share that a toolmaker mills in one plane.
#pragma once

#include <cstddef>

#include "parting/halves/sheets.hpp"

namespace moldlight {

/// The sheet `parting`: what hangs together with the block's rim, and the shut-offs. Heights are along z.
struct SurfaceFigures {
  double parting_area = 0.0, shut_off_area = 0.0, steepest_deg = 0.0;
  double too_steep_area = 0.0;  // steeper than asked
  // Of what hangs together with the rim.
  double shelf_height = 0.0, shelf_area = 0.0;  // the plane across z that has the most of it
  double ramp_area = 0.0;                       // leans by more than rounding
  double low = 0.0, high = 0.0;
  double rim_low = 0.0, rim_high = 0.0;
  std::size_t faces = 0;  // parts without a kink, of the shut-offs, too

  [[nodiscard]] double rim_range() const { return rim_high - rim_low; }
  /// Share of the surface around the part that its shelf has.
  [[nodiscard]] double shelf_share() const { return parting_area > 0.0 ? shelf_area / parting_area : 0.0; }
};

/// Slopes are those of facets that are wider than `narrow`, less what a height that is off by `tolerance`
/// makes of them.
struct SlopeLimit {
  double slope_deg = 0.0, narrow = 0.0, tolerance = 0.0;
};
[[nodiscard]] SurfaceFigures surface_figures(const Sheets& sheets, const SlopeLimit& limit);

}  // namespace moldlight
