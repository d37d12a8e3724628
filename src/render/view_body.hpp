// Solids beside the part, such as slides: translucent, over the finished picture.
#pragma once

#include <array>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/region.hpp"
#include "render/view_geometry.hpp"

namespace moldlight {

struct ViewBody {
  std::vector<ViewVertex> vertices;
  std::vector<std::array<VertexIndex, 3>> facets;
  Colour colour;
};

/// A closed mesh in the part's unit, each facet flat.
[[nodiscard]] ViewBody view_body(const TriangleMesh& mesh, const UnitFrame& frame, Colour colour);

}  // namespace moldlight
