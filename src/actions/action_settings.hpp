// Settings of side actions, with the table of their options.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/action_prices.hpp"
#include "actions/pins.hpp"
#include "classify/option.hpp"

namespace moldlight {

/// Lengths are in millimetres; a part whose file names no unit is taken to be in millimetres.
struct ActionSettings {
  double slide_angle_deg = 5.0;    // a slide moves within this angle of the plane across d, [0, 45]
  double incline_deg = 30.0;       // an inclined slide within this, [0, 80]
  double lifter_angle_deg = 8.0;   // of a lifter to the ejection, [1, 45]: couples its travel and its stroke
  double lifter_room_mm = 3.0;     // that a lifter needs beyond its travel: its own thickness and play
  double lifter_section_mm = 4.0;  // of a lifter's stem, each way, [0, 1000]; 0 asks for none
  double pin_diameter_mm = 1.0;    // of a pin that forms a hole, at least, [0, 1000]; 0: any
  double clearance_mm = 3.0;       // added to a slide's least travel, [0, 1000]
  double least_travel_mm = k_least_travel_mm;  // what a shorter way releases is no undercut, [0, 1000]
  double strip_strain_pct = 5.0;               // up to which a ring may be stripped off, [0, 100]
  double bundle_across_mm =
      50.8;                       // undercuts that one slide forms are no farther apart across its direction,
  double bundle_along_mm = 25.4;  // and along it (published by a vendor of cost estimation), [0, 10000]
  std::vector<glm::dvec3> side_directions = {};  // always tried, and taken as they are; not zero
  std::vector<ActionPin> pins = {};
  ActionPrices prices = default_prices();

  bool operator==(const ActionSettings&) const = default;
};

[[nodiscard]] std::span<const Option<ActionSettings>> action_options();

/// Two undercuts share a slide only if the directions they would have alone are within this angle.
inline constexpr double k_bundle_deg = 30.0;

}  // namespace moldlight
