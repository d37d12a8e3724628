// Solids beside the part: those that side actions move, translucent over the finished picture; and the steel
// of a mold around it, which is surface of the picture itself.
#pragma once

#include <array>
#include <cstdint>
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

/// Which body of a mold: a half, or what is left to a loose insert.
enum class Steel : std::uint8_t { core, cavity, insert };
inline constexpr std::size_t k_steels = 3;

struct ViewSolid {
  ViewBody body;
  Steel steel = Steel::core;
  std::vector<ViewSegment> edges;  // sharper than the crease angle
};
/// A closed mesh in the part's unit, each facet flat.
[[nodiscard]] ViewSolid view_solid(const TriangleMesh& mesh, const UnitFrame& frame, Steel steel);

}  // namespace moldlight
