// A map of the parting directions: Lambert's equal-area picture of the half-sphere about +z, coloured by
// undercut area.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mold/direction_field.hpp"
#include "picture/canvas.hpp"
#include "picture/legend.hpp"

namespace moldlight {

struct UndercutField {
  DirectionField areas;
  double worst = 0.0;  // area at the dark end of the colours
};

/// A direction marked on the map; on the rim its opposite is marked, too.
struct SphereMark {
  glm::dvec3 direction{0, 0, 1};  // unit
  std::string label = {};         // none where there is no room for it, or it is empty
  bool best = false;
  double tilt_deg = 0.0;  // a circle so wide is drawn around it, unless the mark hides it; 0 for none
};

/// Directions about one, a unit vector, and its opposite that a proof left open.
struct SphereCap {
  glm::dvec3 direction{0, 0, 1};
  double radius_deg = 0.0;
};

struct MapPlace {
  glm::dvec2 centre{0.0};  // pixels
  double radius = 1.0;
};

/// Beyond the radius it takes up to 34 pixels at scale 1 for the names of the axes. Where no direction was
/// evaluated the map is gray and hatched.
void draw_sphere_map(Canvas& canvas, const MapPlace& place, const UndercutField& field,
                     const std::vector<SphereMark>& marks, const LegendStyle& style);

/// Rings around caps, over a map that is drawn; small ones are drawn large enough to be seen.
void draw_open_caps(Canvas& canvas, const MapPlace& place, const std::vector<SphereCap>& caps, double scale);

/// A small sample of such a ring, for a legend.
void draw_open_sample(Canvas& canvas, const glm::dvec2& at, double scale);

/// The pattern of directions of which nothing is known, in a box.
void draw_unknown(Canvas& canvas, const Box& box, const LegendStyle& style);

/// A small sample of a mark, for a legend.
void draw_mark(Canvas& canvas, const glm::dvec2& at, bool best, double scale);

/// A round mark and the room that its label takes; pixels.
struct LabelledMark {
  glm::dvec2 centre{0.0};
  double radius = 0.0;
  glm::dvec2 label{0.0};
};

/// A box for each label, as near to its mark as there is room, the first marks first; none where there is no
/// room within a few label heights. `taken` are boxes that labels keep clear of; `room` holds all labels.
[[nodiscard]] std::vector<std::optional<Box>> place_labels(std::span<const LabelledMark> marks,
                                                           std::span<const Box> taken, const Box& room);

}  // namespace moldlight
