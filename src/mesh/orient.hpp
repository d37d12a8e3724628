// Turning parts and bodies that a file holds inside out. Voids are distinguished from such bodies by where
// they lie.
#pragma once

#include <cstddef>
#include <string>

#include "mesh/adjacency.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

struct TurnedFacets {
  std::size_t facets = 0;           // turned
  std::size_t components = 0;       // that these make up
  std::size_t components_left = 0;  // as they were
};

/// Reverses the facets of components (see connected_components) that are inside out. Facet k stays facet k
/// and keeps its corner 0; corners 1 and 2 change places.
///
/// Only components whose winding is consistent and whose volume is negative, however least surfaces close
/// their gaps, are considered. Such a component is right where the components around it make material of the
/// place it lies in (their winding number there is positive): it is then the skin of a void. Everywhere else
/// it is a body turned inside out, and so are the positive components directly inside it: voids of a part
/// that is inside out as a whole. A positive component inside an outward one stays as it is: bodies of one
/// file may overlap. The edges, of the mesh as it comes in, are then no longer its own where facets were
/// turned.
TurnedFacets turn_if_inside_out(TriangleMesh& mesh, const EdgeTable& edges);
inline TurnedFacets turn_if_inside_out(TriangleMesh& mesh) {
  return turn_if_inside_out(mesh, EdgeTable(mesh));
}

/// One sentence for the user; empty when nothing was turned.
[[nodiscard]] std::string turned_warning(const TurnedFacets& turned);

}  // namespace moldlight
