// Rays along one direction and against it, tested one by one in double against all facets near them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/facet_geometry.hpp"
#include "mold/region.hpp"
#include "support/shapes.hpp"

namespace moldlight::test {

class ParallelRays {
 public:
  /// References must outlive it; `direction` is a unit vector. `closed`: whether the mesh has an inside.
  ParallelRays(const TriangleMesh& mesh, const FacetGeometry& geometry, const glm::dvec3& direction,
               bool closed);

  /// Region of a point on a facet by the truth of accessibility; the facet itself never hides it. On an open
  /// part only facets that face the ray hide up and down facets. None where a ray passes or starts
  /// within 1e-9 of the diagonal of an edge or facet, too close to call.
  [[nodiscard]] std::optional<Region> region(const glm::dvec3& point, FacetIndex facet,
                                             const ShapeSettings& settings) const;

 private:
  enum class Answer : std::uint8_t { free, blocked, unclear };
  struct Flat {
    double x, y;
  };
  [[nodiscard]] Flat flat(const glm::dvec3& point) const;
  [[nodiscard]] Answer ray(const glm::dvec3& from, double sense, FacetIndex own, bool facing_only) const;
  [[nodiscard]] std::size_t cell(double x, double low) const;

  const TriangleMesh& mesh_;
  const FacetGeometry& geometry_;
  glm::dvec3 center_, x_, y_, direction_;
  bool closed_;
  double margin_, low_x_, low_y_, cell_size_;
  std::size_t cells_;  // along each side
  std::vector<Flat> points_;
  std::vector<std::vector<FacetIndex>> facets_in_;
};

}  // namespace moldlight::test
