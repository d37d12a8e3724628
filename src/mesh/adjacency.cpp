// OpenMesh accepts oriented manifolds only. So every edge that does not join two facets is cut first: corners
// stay one vertex only where they are connected through joining edges. What is left is a manifold with
// borders. OpenMesh walks around a vertex for each facet there: edges of crowded ones are cut, too, and
// joined afterwards.
#include "mesh/adjacency.hpp"

#include <algorithm>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "mesh/edge_table.hpp"
#include "mesh/union_find.hpp"

namespace moldlight {
namespace {

/// Corner c of facet f has number 3 * f + c, like the half-edge that starts there.
struct CutMesh {
  std::vector<std::array<HalfEdgeIndex, 2>> crowded;  // edges that join, of vertices of many facets
  std::vector<bool> joins;                            // of each half-edge: it joins its facet to another
  std::vector<std::uint32_t> copy;                    // vertex copy of each corner
  std::uint32_t copy_count = 0;
};

constexpr std::uint32_t k_crowded = 256;  // facets of a vertex
constexpr FacetIndex k_facets_a_report = 4096;

HalfEdgeIndex next_in_facet(HalfEdgeIndex half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}

CutMesh cut_mesh(const TriangleMesh& mesh) {
  CutMesh cut;
  cut.joins.assign(3 * mesh.facets.size(), false);
  UnionFind corners(3 * mesh.facets.size());
  std::vector<std::uint32_t> facets_at(mesh.vertices.size(), 0);
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex vertex : facet) ++facets_at[vertex];
  }
  EdgeTable(mesh).for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const HalfEdgeIndex a = uses[0].half_edge, b = uses[1].half_edge;
    if (start_vertex(mesh, a) == start_vertex(mesh, b)) return;
    if (std::max(facets_at[low], facets_at[uses[0].high]) > k_crowded) {
      cut.crowded.push_back({a, b});
      return;
    }
    cut.joins[a] = cut.joins[b] = true;
    corners.join(a, next_in_facet(b));
    corners.join(next_in_facet(a), b);
  });

  cut.copy.resize(3 * mesh.facets.size());
  for (std::uint32_t corner = 0; corner < cut.copy.size(); ++corner) {
    const std::uint32_t first = corners.find(corner);
    cut.copy[corner] = first == corner ? cut.copy_count++ : cut.copy[first];
  }
  return cut;
}

OpenMesh::VertexHandle vertex_handle(std::uint32_t number) {
  return OpenMesh::VertexHandle(static_cast<int>(number));
}

}  // namespace

Adjacency build_adjacency(const TriangleMesh& mesh, const Progress& progress) {
  const CutMesh cut = cut_mesh(mesh);

  OpenMesh::TriConnectivity half_edges;
  omerr().disable();  // OpenMesh reports refused facets on stderr; they are dealt with below
  half_edges.reserve(cut.copy_count, 3 * mesh.facets.size() / 2 + 3, mesh.facets.size());
  for (std::uint32_t copy = 0; copy < cut.copy_count; ++copy) half_edges.new_vertex();

  std::vector<FacetIndex> facet_of_face;
  facet_of_face.reserve(mesh.facets.size());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (facet % k_facets_a_report == 0) progress.report("finding neighbours", 0.0);
    if (is_collapsed(mesh.facets[facet])) continue;
    const std::uint32_t* copies = &cut.copy[3 * facet];
    if (!half_edges.add_face(vertex_handle(copies[0]), vertex_handle(copies[1]), vertex_handle(copies[2]))
             .is_valid()) {
      const auto a = half_edges.new_vertex(), b = half_edges.new_vertex(), c = half_edges.new_vertex();
      half_edges.add_face(a, b, c);
    }
    facet_of_face.push_back(facet);
  }

  Adjacency adjacency;
  adjacency.across.assign(mesh.facets.size(), {k_no_facet, k_no_facet, k_no_facet});
  for (std::size_t face = 0; face < facet_of_face.size(); ++face) {
    const FacetIndex facet = facet_of_face[face];
    // OpenMesh starts a face at its last edge (corner 2 to corner 0).
    auto half_edge = half_edges.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(face)));
    for (const HalfEdgeIndex edge : {2u, 0u, 1u}) {
      const auto other = half_edges.face_handle(half_edges.opposite_halfedge_handle(half_edge));
      // Both ends of a cut edge can be one copy each when the facets around them are connected; it stays cut.
      if (other.is_valid() && cut.joins[3 * facet + edge]) {
        adjacency.across[facet][edge] = facet_of_face[static_cast<std::size_t>(other.idx())];
      }
      half_edge = half_edges.next_halfedge_handle(half_edge);
    }
  }
  for (const auto& [a, b] : cut.crowded) {
    adjacency.across[facet_of(a)][a % 3] = facet_of(b);
    adjacency.across[facet_of(b)][b % 3] = facet_of(a);
  }
  return adjacency;
}

Components connected_components(const TriangleMesh& mesh) {
  UnionFind facets(mesh.facets.size());
  EdgeTable(mesh).for_each_edge([&](VertexIndex, std::span<const EdgeUse> uses) {
    for (const EdgeUse& use : uses.subspan(1))
      facets.join(facet_of(uses[0].half_edge), facet_of(use.half_edge));
  });

  Components components;
  components.of_facet.assign(mesh.facets.size(), k_no_facet);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (is_collapsed(mesh.facets[facet])) continue;
    const FacetIndex first = facets.find(facet);
    components.of_facet[facet] =
        first == facet ? static_cast<FacetIndex>(components.count++) : components.of_facet[first];
  }
  return components;
}

}  // namespace moldlight
