// What a lifter stands on, and whether there is a place for it.
#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "actions/release.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// A straight bar that leads from a lifter's head through its half down to the ejector plate, inclined
/// against the lifter's travel. Its section across the parting direction is a square.
struct Stem {
  glm::dvec3 top{0.0};     // middle of its upper end
  glm::dvec3 way{0.0};     // from there down, unit
  glm::dvec3 travel{0.0};  // the lifter's, unit
  glm::dvec3 across{0.0};  // to that and to the parting direction, unit
  double width = 0.0;
  double behind = 0.0;  // what the lifter forms, to its middle
};

struct StemSettings {
  double width = 0.0;      // share of the diagonal; 0 asks for no stem
  double angle_deg = 0.0;  // to the ejection
};

/// The stem that stands nearest to what a lifter forms: clear of the part where the mold is closed, with a
/// wall round it of a quarter of its width, and as the lifter travels. None where there is no such place
/// within three widths behind the samples. Unit frame.
[[nodiscard]] std::optional<Stem> find_stem(const Release& release, FreeLengths& lengths,
                                            const LifterWay& way, const StemSettings& settings);

/// As a closed solid, from its top so far down, in the units of all.
[[nodiscard]] TriangleMesh stem_solid(const Stem& stem, double length);

}  // namespace moldlight
