// What is measured between two places of the surface.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/part_model.hpp"
#include "render/part_view.hpp"

namespace moldlight::gui {

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
  void add(const MeasuredPlace& place);
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

}  // namespace moldlight::gui
