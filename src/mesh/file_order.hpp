// The order of vertices and facets in which a part is worked on, and the way back to the file's. Files list
// the same surface in any order; worked on in one order by place, it gives the same answers to the bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/part.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Numbers the vertices along a curve through space that keeps neighbours together (Morton's), laid along
/// the vertices' axes of inertia, so that copies that are turned or mirrored are worked on in the same order,
/// too; where these are alike, the file's axes take their part. Each facet begins with its lowest vertex, and
/// those of a body are in the order of their vertices. Part::file_facets keeps the file's order. Vertices
/// must be welded and in use.
void put_in_place_order(Part& part);

/// The facet's number in the file; -1 for one that a repair added.
[[nodiscard]] inline std::int64_t file_facet(const Part& part, FacetIndex facet) {
  if (part.file_facets.empty()) return facet;
  return part.file_facets[facet] == k_no_facet ? -1 : std::int64_t{part.file_facets[facet]};
}

/// The facets as the file lists them, what a repair added at the end of its body.
[[nodiscard]] std::vector<FacetIndex> facets_as_listed(const Part& part);

/// Values of the part's facets, those of facets_as_listed() in turn; none for none.
template <typename T>
[[nodiscard]] std::vector<T> as_listed(const Part& part, const std::vector<T>& values) {
  std::vector<T> listed;
  if (values.empty()) return listed;
  listed.reserve(values.size());
  for (const FacetIndex facet : facets_as_listed(part)) listed.push_back(values[facet]);
  return listed;
}

/// The vertices in the order in which those facets first use them.
[[nodiscard]] std::vector<VertexIndex> vertices_as_listed(const Part& part);

/// The mesh with its facets as the file lists them and vertices in the order of first use.
[[nodiscard]] TriangleMesh mesh_as_listed(const Part& part);

}  // namespace moldlight
