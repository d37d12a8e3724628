// Shortcuts from a mesh to its exact regions, and how far two results are apart.
#pragma once

#include <glm/vec3.hpp>

#include "mesh/facet_geometry.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/exact/exact_regions.hpp"
#include "support/shapes.hpp"

namespace moldlight::test {

/// A mesh with all that its exact regions are made of.
class ExactModel {
 public:
  explicit ExactModel(TriangleMesh mesh);
  ExactModel(const ExactModel&) = delete;  // the part refers to the members
  ExactModel& operator=(const ExactModel&) = delete;

  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
  [[nodiscard]] const FacetGeometry& geometry() const { return geometry_; }
  [[nodiscard]] const ExactPart& part() const { return part_; }
  [[nodiscard]] double diagonal() const { return frame_.diagonal; }

  [[nodiscard]] ExactQuery query(const glm::dvec3& direction, const ShapeSettings& settings) const;
  [[nodiscard]] ExactAreas areas(const glm::dvec3& direction, const ShapeSettings& settings) const;
  [[nodiscard]] ExactSplit split(const glm::dvec3& direction, const ShapeSettings& settings) const;

  /// tau of 1 degree and a lateral tolerance of 1/2048 of the diagonal.
  [[nodiscard]] ShapeSettings default_settings() const;

 private:
  TriangleMesh mesh_;
  FacetGeometry geometry_;
  UnitFrame frame_;
  ExactPart part_;
};

[[nodiscard]] ExactAreas exact_areas_of(const TriangleMesh& mesh, const glm::dvec3& direction,
                                        const ShapeSettings& settings);

/// Largest difference of a region's area.
[[nodiscard]] double largest_difference(const RegionValues& a, const RegionValues& b);

/// Core and cavity exchanged.
[[nodiscard]] RegionValues swapped_sides(RegionValues areas);

/// x, y, z and two that are no axis of anything.
[[nodiscard]] std::vector<glm::dvec3> five_directions();

}  // namespace moldlight::test
