#include "actions/action_settings.hpp"

namespace moldlight {

std::span<const Option<ActionSettings>> action_options() {
  using S = ActionSettings;
  static const std::vector<Option<S>> k_options = {
      {"slide_angle_deg", "--slide-angle", "Slide angle", "deg",
       "A slide moves within this angle of the plane across the parting direction.",
       RealKind<S>{&S::slide_angle_deg, 0.0, 45.0, 0.5}},
      {"incline_deg", "--incline", "Incline", "deg",
       "An inclined slide moves within this angle of the plane across the parting direction.",
       RealKind<S>{&S::incline_deg, 0.0, 80.0, 1.0}},
      {"lifter_angle_deg", "--lifter-angle", "Lifter angle", "deg",
       "Angle of a lifter to the ejection: its stroke is its travel divided by the tangent.",
       RealKind<S>{&S::lifter_angle_deg, 1.0, 45.0, 0.5}},
      {"lifter_room_mm", "--lifter-room", "Lifter room", "mm",
       "What a lifter needs beyond its travel, for its own thickness and to stay clear; one with less is "
       "rejected.",
       RealKind<S>{&S::lifter_room_mm, 0.0, 1000.0, 0.5}},
      {"lifter_section_mm", "--lifter-section", "Lifter section", "mm",
       "Side of the square stem that carries a lifter out of its half; 0: none.",
       RealKind<S>{&S::lifter_section_mm, 0.0, 1000.0, 0.5}},
      {"pin_diameter_mm", "--pin-diameter", "Pin diameter", "mm",
       "A core pin is no thinner: no slide forms a round hole that is.",
       RealKind<S>{&S::pin_diameter_mm, 0.0, 1000.0, 0.1}},
      {"clearance_mm", "--clearance", "Clearance", "mm", "What a slide travels beyond the least.",
       RealKind<S>{&S::clearance_mm, 0.0, 1000.0, 0.5}},
      {"least_travel_mm", "--least-travel", "Least travel", "mm",
       "What a shorter way releases is no undercut, nor is what is within the lateral tolerance.",
       RealKind<S>{&S::least_travel_mm, 0.0, 1000.0, 0.05}},
      {"strip_strain_pct", "--strip-strain", "Strip strain", "%",
       "Largest strain at which a ring may be stripped off; 0: none is stripped.",
       RealKind<S>{&S::strip_strain_pct, 0.0, 100.0, 0.5}},
      {"bundle_across_mm", "--bundle-across", "Bundle across", "mm",
       "Undercuts that one slide forms are no farther apart across its direction.",
       RealKind<S>{&S::bundle_across_mm, 0.0, 10000.0, 0.1}},
      {"bundle_along_mm", "--bundle-along", "Bundle along", "mm",
       "Undercuts that one slide forms are no farther apart along its direction.",
       RealKind<S>{&S::bundle_along_mm, 0.0, 10000.0, 0.1}},
      {"side_directions", "--side-direction", "Side directions", "",
       "A direction that a side action may take, tried beside those of the part; may be given several times.",
       DirectionsKind<S>{&S::side_directions}},
      {"prices", "--prices", "Prices", "",
       "What each kind of action costs in the choice of the least set; a slide is 1. A JSON file such as "
       "{\"lifter\": 2}, or lifter=2,insert=5.",
       TextKind<S>{.name = "FILE.json",
                   .get = [](const S& s) { return prices_text(s.prices); },
                   .set = [](S& s, std::string_view text) { s.prices = parse_prices(text); }}},
      {"pins", "--pins", "Pins", "",
       "Undercuts that one kind of action alone may release, or none: a point on each, its area and the "
       "kind.",
       TextKind<S>{.name = "X,Y,Z,AREA,KIND;...",
                   .get = [](const S& s) { return pins_text(s.pins); },
                   .set = [](S& s, std::string_view text) { s.pins = parse_pins(text); }}},
  };
  return k_options;
}

}  // namespace moldlight
