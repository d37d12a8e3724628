#include "actions/action_settings.hpp"

#include "mesh/length_unit.hpp"

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
       "told "
       "as such, and taken for want of others.",
       RealKind<S>{&S::lifter_room_mm, 0.0, 1000.0, 0.5}},
      {"clearance_mm", "--clearance", "Clearance", "mm", "What a slide travels beyond the least.",
       RealKind<S>{&S::clearance_mm, 0.0, 1000.0, 0.5}},
      {"strip_strain_pct", "--strip-strain", "Strip strain", "%",
       "Largest strain at which a ring may be stripped off; 0: any is told, and the verdict left to you.",
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
      {"pins", "--pins", "Pins", "",
       "Undercuts that one kind of action alone may release, or none: a point on each, its area and the "
       "kind.",
       TextKind<S>{.name = "X,Y,Z,AREA,KIND;...",
                   .get = [](const S& s) { return pins_text(s.pins); },
                   .set = [](S& s, std::string_view text) { s.pins = parse_pins(text); }}},
  };
  return k_options;
}

double unit_per_mm(const Part& part) {
  const auto unit = find_length_unit(part.unit);
  return 1.0 / (unit ? unit->mm : 1.0);
}

}  // namespace moldlight
