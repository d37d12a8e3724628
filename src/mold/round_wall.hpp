// The axis of the cylinder or cone to which a facet belongs.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"

namespace moldlight {

struct RoundWall {
  glm::dvec3 axis{0.0};  // unit, on the half-sphere of half_sphere()
  double area = 0.0;     // model units squared
};

/// The round wall around `facet`: facets, joined over edges that bend by less than 37.5 degrees,
/// whose normals have one angle to the axis and turn about it by 60 degrees at least, in four steps or more.
/// Nothing where there is none.
[[nodiscard]] std::optional<RoundWall> round_wall(const FacetGeometry& geometry, const Adjacency& adjacency,
                                                  FacetIndex facet);

}  // namespace moldlight
