#include "actions/action_settings.hpp"

namespace moldlight {

std::span<const Option<ActionSettings>> action_options() {
  using S = ActionSettings;
  static const std::vector<Option<S>> k_options = {
      {"slide_angle_deg", "--slide-angle", "Slide angle", "deg",
       "Largest angle between a slide's travel and the plane across the parting direction.",
       RealKind<S>{&S::slide_angle_deg, 0.0, 45.0, 0.5}},
      {"incline_deg", "--incline", "Incline", "deg",
       "Largest angle between an inclined slide's travel and the plane across the parting direction.",
       RealKind<S>{&S::incline_deg, 0.0, 80.0, 1.0}},
      {"lifter_angle_deg", "--lifter-angle", "Lifter angle", "deg",
       "Angle between a lifter and the ejection. Its stroke is its travel divided by the tangent of this "
       "angle.",
       RealKind<S>{&S::lifter_angle_deg, 1.0, 45.0, 0.5}},
      {"lifter_room_mm", "--lifter-room", "Lifter room", "mm",
       "Room that a lifter needs beyond its travel, for its thickness and clearance. A lifter with less is "
       "rejected.",
       RealKind<S>{&S::lifter_room_mm, 0.0, 1000.0, 0.5}},
      {"lifter_section_mm", "--lifter-section", "Lifter section", "mm",
       "Width of the square stem on which a lifter stands, from its head to the ejector plate. A lifter "
       "without a place for it is rejected. 0: not asked for.",
       RealKind<S>{&S::lifter_section_mm, 0.0, 1000.0, 0.5}},
      {"pin_diameter_mm", "--pin-diameter", "Pin diameter", "mm",
       "Least diameter of a core pin. No action forms a thinner hole. 0: any diameter.",
       RealKind<S>{&S::pin_diameter_mm, 0.0, 1000.0, 0.1}},
      {"clearance_mm", "--clearance", "Clearance", "mm",
       "Travel of a slide beyond the least that clears the part.",
       RealKind<S>{&S::clearance_mm, 0.0, 1000.0, 0.5}},
      {"least_travel_mm", "--least-travel", "Least travel", "mm",
       "Surface that a shorter travel releases is not an undercut. Nor is surface within the lateral "
       "tolerance.",
       RealKind<S>{&S::least_travel_mm, 0.0, 1000.0, 0.05}},
      {"strip_strain_pct", "--strip-strain", "Strip strain", "%",
       "Permitted strain of a stripped ring. 0: no ring is stripped.",
       RealKind<S>{&S::strip_strain_pct, 0.0, 100.0, 0.5}},
      {"bundle_across_mm", "--bundle-across", "Bundle across", "mm",
       "Largest distance between undercuts of one slide, across its direction.",
       RealKind<S>{&S::bundle_across_mm, 0.0, 10000.0, 0.1}},
      {"bundle_along_mm", "--bundle-along", "Bundle along", "mm",
       "Largest distance between undercuts of one slide, along its direction.",
       RealKind<S>{&S::bundle_along_mm, 0.0, 10000.0, 0.1}},
      {"side_directions", "--side-direction", "Side directions", "",
       "An extra direction for side actions. May be given several times.",
       DirectionsKind<S>{&S::side_directions}},
      {"prices", "--prices", "Prices", "",
       "Price of each kind of action when the cheapest set is chosen. A slide costs 1. Give a JSON file such "
       "as {\"lifter\": 2}, or lifter=2,insert=5.",
       TextKind<S>{.name = "FILE.json",
                   .get = [](const S& s) { return prices_text(s.prices); },
                   .set = [](S& s, std::string_view text) { s.prices = parse_prices(text); }}},
      {"pins", "--pins", "Pins", "",
       "Reserve an undercut for one kind of action, or for none: a point on it, its area and the kind.",
       TextKind<S>{.name = "X,Y,Z,AREA,KIND;...",
                   .get = [](const S& s) { return pins_text(s.pins); },
                   .set = [](S& s, std::string_view text) { s.pins = parse_pins(text); }}},
  };
  return k_options;
}

}  // namespace moldlight
