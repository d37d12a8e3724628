// Facts about the part's surface: at the point under the cursor, of the face that was chosen, and between
// two places. What a picture of a place is to show.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "classify/classification.hpp"
#include "classify/part_model.hpp"
#include "mesh/faces.hpp"
#include "mold/draft.hpp"
#include "render/part_view.hpp"
#include "render/view_geometry.hpp"

namespace moldlight {

/// Six points at this distance from the centre, along the axes.
[[nodiscard]] inline std::vector<glm::vec3> points_around(const glm::vec3& centre, double reach) {
  std::vector<glm::vec3> points;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-reach, reach}) {
      points.push_back(centre);
      points.back()[axis] += static_cast<float>(side);
    }
  }
  return points;
}

/// What stands in a point's way.
struct Blocker {
  FacetIndex facet = 0;
  double distance = 0.0;           // model units, along the direction of removal
  bool above = true;               // towards +d
  glm::vec3 from{0.0F}, at{0.0F};  // ends of the way there, unit frame

  bool operator==(const Blocker&) const = default;
};

/// The surface under the cursor.
struct Hover {
  PickedPoint point;
  double draft_deg = 0.0;
  FacetClass facet_class = FacetClass::up;
  std::optional<Blocker> blocker;  // the nearest, where something blocks
};

/// Draft, class and, for an undercut, what blocks it: found by exact rays, so that it names one facet.
[[nodiscard]] Hover describe(const PartModel& model, const Query& query, const PickedPoint& point);

/// In a section plane, how far it is from the cursor's place to the outline on both sides.
struct CutSpan {
  double length = 0.0;               // model units
  bool material = true;              // thickness of it; else a gap between two walls
  glm::vec3 start{0.0F}, end{0.0F};  // unit frame

  bool operator==(const CutSpan&) const = default;
};

/// The span at a point of the plane, in material or not: across the parting direction, and where the whole
/// plane lies across it in the way that is shortest. Nothing where one side is open.
[[nodiscard]] std::optional<CutSpan> cut_span(const PartModel& model, const CutPlane& plane,
                                              const glm::dvec3& direction, const glm::dvec3& point);

/// What a face is made of, for the last measuring.
struct FaceFigures {
  RegionValues areas;                                  // model units squared
  double least_draft_deg = 0.0, most_draft_deg = 0.0;  // of its facets
};

struct ChosenFace {
  std::uint32_t number = 0;            // among the part's faces
  std::optional<FaceFigures> figures;  // none yet
};

[[nodiscard]] FaceFigures face_figures(const PartModel& model, const Classification& result,
                                       std::span<const FacetIndex> face);

/// What a picture of a face is to show: its corners, and some of what is around it; unit frame.
[[nodiscard]] std::vector<glm::vec3> surroundings(const PartModel& model, std::span<const FacetIndex> face);

/// The edges between facets of a face and others.
[[nodiscard]] std::vector<ViewSegment> outline_of(const PartModel& model, const Faces& faces,
                                                  std::uint32_t number);

/// A place of the surface.
struct MeasuredPlace {
  glm::dvec3 at{0.0};                // model units
  glm::dvec3 normal{0.0, 0.0, 1.0};  // of the facet, outward, unit
};

[[nodiscard]] MeasuredPlace measured_place(const PartModel& model, const PickedPoint& point);

/// The tool while it is on.
struct Measuring {
  std::vector<MeasuredPlace> places;  // that were clicked; two at most

  /// Takes a place; a third one begins anew.
  void add(const MeasuredPlace& place) {
    if (places.size() == 2) places.clear();
    places.push_back(place);
  }
};

/// Lengths in model units.
struct MeasuredPair {
  double distance = 0.0;
  double along = 0.0, across = 0.0;      // the parting direction
  double angle_deg = 0.0;                // between the normals, [0, 180]
  std::optional<double> between_planes;  // of facets that are parallel
};
[[nodiscard]] MeasuredPair measured(const MeasuredPlace& a, const MeasuredPlace& b,
                                    const glm::dvec3& direction);

}  // namespace moldlight
