// OpenMesh accepts oriented manifolds only. So every edge that does not join two facets is cut first: corners
// stay one vertex only where they are connected through joining edges. What is left is a manifold with
// borders. OpenMesh walks around a vertex for each facet there: edges of crowded ones are cut, too, and
// joined afterwards.
#include "mesh/adjacency.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"
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

CutMesh cut_mesh(const TriangleMesh& mesh, const EdgeTable& edges) {
  CutMesh cut;
  cut.joins.assign(3 * mesh.facets.size(), false);
  UnionFind corners(3 * mesh.facets.size());
  std::vector<std::uint32_t> facets_at(mesh.vertices.size(), 0);
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex vertex : facet) ++facets_at[vertex];
  }
  edges.for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
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

constexpr std::size_t next(std::size_t corner) { return (corner + 1) % 3; }

/// Corner of `facet` at which its edge to vertex `to` starts from `from`; 3 if it has none.
std::size_t edge_corner(const std::array<VertexIndex, 3>& facet, VertexIndex from, VertexIndex to) {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    if (facet[corner] == from && facet[next(corner)] == to) return corner;
  }
  return 3;
}

double corner_angle(const TriangleMesh& mesh, FacetIndex facet, std::size_t corner) {
  const auto& vertices = mesh.facets[facet];
  const glm::dvec3 one = mesh.vertices[vertices[next(corner)]] - mesh.vertices[vertices[corner]];
  const glm::dvec3 other = mesh.vertices[vertices[next(next(corner))]] - mesh.vertices[vertices[corner]];
  return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

}  // namespace

EdgeTable::EdgeTable(const TriangleMesh& mesh) : first_use_(mesh.vertices.size() + 1, 0) {
  CHECK(mesh.facets.size() < std::numeric_limits<HalfEdgeIndex>::max() / 3);
  const auto for_each_half_edge = [&mesh](auto&& visit) {
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      const auto& corners = mesh.facets[facet];
      if (is_collapsed(corners)) continue;
      for (HalfEdgeIndex edge = 0; edge < 3; ++edge) {
        const auto [low, high] = std::minmax(corners[edge], corners[(edge + 1) % 3]);
        visit(low, high, 3 * facet + edge);
      }
    }
  };

  for_each_half_edge([this](VertexIndex low, VertexIndex, HalfEdgeIndex) { ++first_use_[low + 1]; });
  for (std::size_t vertex = 1; vertex < first_use_.size(); ++vertex)
    first_use_[vertex] += first_use_[vertex - 1];

  uses_.resize(first_use_.back());
  std::vector<HalfEdgeIndex> next_free(first_use_.begin(), first_use_.end() - 1);
  for_each_half_edge([&](VertexIndex low, VertexIndex high, HalfEdgeIndex half_edge) {
    uses_[next_free[low]++] = {high, half_edge};
  });

  for (std::size_t low = 0; low + 1 < first_use_.size(); ++low) {
    std::ranges::sort(uses_.begin() + first_use_[low], uses_.begin() + first_use_[low + 1], {},
                      [](const EdgeUse& use) { return std::pair(use.high, use.half_edge); });
  }
}

Adjacency build_adjacency(const TriangleMesh& mesh, const EdgeTable& edges, const Progress& progress) {
  const CutMesh cut = cut_mesh(mesh, edges);

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

Components connected_components(const TriangleMesh& mesh, const EdgeTable& edges) {
  UnionFind facets(mesh.facets.size());
  edges.for_each_edge([&](VertexIndex, std::span<const EdgeUse> uses) {
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

std::vector<bool> solid_facets(const TriangleMesh& mesh, const Adjacency& adjacency) {
  const std::size_t count = mesh.facets.size();
  UnionFind bodies(count);
  // Edges that do not join just two facets, by their vertices.
  struct Use {
    VertexIndex low, high;
    FacetIndex facet;
    int sense;
  };
  std::vector<Use> uses;
  for (FacetIndex facet = 0; facet < count; ++facet) {
    const auto& corners = mesh.facets[facet];
    if (is_collapsed(corners)) continue;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const FacetIndex across = adjacency.across[facet][corner];
      if (across != k_no_facet) {
        bodies.join(facet, across);
        continue;
      }
      const VertexIndex from = corners[corner], to = corners[(corner + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), facet, from < to ? 1 : -1});
    }
  }
  std::ranges::sort(uses, {}, [](const Use& use) { return std::tuple(use.low, use.high, use.facet); });
  std::vector<FacetIndex> open;
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    int balance = 0;
    for (; end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high;
         ++end) {
      balance += uses[end].sense;
      bodies.join(uses[begin].facet, uses[end].facet);
    }
    if (balance != 0) open.push_back(uses[begin].facet);
  }
  std::vector<bool> solid_body(count, true), solid(count);
  for (const FacetIndex facet : open) solid_body[bodies.find(facet)] = false;
  for (FacetIndex facet = 0; facet < count; ++facet) solid[facet] = solid_body[bodies.find(facet)];
  return solid;
}

std::vector<bool> void_facets(const TriangleMesh& mesh, const Adjacency& adjacency) {
  const std::size_t count = mesh.facets.size();
  UnionFind shells(count);
  for (FacetIndex facet = 0; facet < count; ++facet) {
    for (const FacetIndex across : adjacency.across[facet]) {
      if (across != k_no_facet) shells.join(facet, across);
    }
  }
  const glm::dvec3 origin = bounds(mesh).center();
  std::vector<double> volumes(count, 0.0);                                     // six times, by shell
  std::map<std::tuple<std::uint32_t, VertexIndex, VertexIndex>, int> balance;  // of a shell at its cut edges
  for (FacetIndex facet = 0; facet < count; ++facet) {
    const auto& corners = mesh.facets[facet];
    if (is_collapsed(corners)) continue;
    const std::uint32_t shell = shells.find(facet);
    volumes[shell] +=
        glm::dot(mesh.vertices[corners[0]] - origin,
                 glm::cross(mesh.vertices[corners[1]] - origin, mesh.vertices[corners[2]] - origin));
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (adjacency.across[facet][corner] != k_no_facet) continue;
      const VertexIndex from = corners[corner], to = corners[(corner + 1) % 3];
      balance[{shell, std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  std::vector<bool> closed(count, true), found(count);
  for (const auto& [edge, sum] : balance) {
    if (sum != 0) closed[std::get<0>(edge)] = false;
  }
  for (FacetIndex facet = 0; facet < count; ++facet) {
    const std::uint32_t shell = shells.find(facet);
    found[facet] = closed[shell] && volumes[shell] < 0.0;
  }
  return found;
}

BentEdges bent_edges(const TriangleMesh& mesh, const FacetGeometry& geometry, const Adjacency& adjacency) {
  BentEdges edges;
  for (FacetIndex left = 0; left < mesh.facets.size(); ++left) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const FacetIndex right = adjacency.across[left][corner];
      if (right == k_no_facet || right < left) continue;
      if (geometry.areas[left] <= 0.0 || geometry.areas[right] <= 0.0) continue;
      const VertexIndex a = mesh.facets[left][corner];
      const VertexIndex b = mesh.facets[left][(corner + 1) % 3];
      const glm::dvec3 along = mesh.vertices[b] - mesh.vertices[a];
      // Positive where the right facet turns down from the left one's plane: less than a half space of solid.
      const double bend = glm::dot(glm::cross(geometry.normals[left], geometry.normals[right]), along);
      const double threshold = k_flat_bend_rad * glm::length(along);
      if (bend > threshold) edges.convex.push_back({a, b, left, right});
      if (bend < -threshold) edges.concave.push_back({a, b, left, right});
    }
  }
  return edges;
}

SmoothCorners smooth_corners(const TriangleMesh& mesh, const FacetGeometry& geometry,
                             const Adjacency& adjacency, double crease_deg) {
  const double threshold = std::cos(glm::radians(crease_deg));
  const std::size_t facets = mesh.facets.size();
  UnionFind corners(3 * facets);
  const auto number = [](FacetIndex facet, std::size_t corner) {
    return static_cast<std::uint32_t>(3 * facet + corner);
  };
  for (FacetIndex facet = 0; facet < facets; ++facet) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const FacetIndex across = adjacency.across[facet][corner];
      if (across == k_no_facet || across < facet) continue;
      if (glm::dot(geometry.normals[facet], geometry.normals[across]) < threshold) continue;
      const VertexIndex a = mesh.facets[facet][corner], b = mesh.facets[facet][next(corner)];
      const std::size_t back = edge_corner(mesh.facets[across], b, a);
      if (back == 3) continue;
      corners.join(number(facet, corner), number(across, next(back)));
      corners.join(number(facet, next(corner)), number(across, back));
    }
  }

  SmoothCorners smooth;
  smooth.of_facet.resize(facets);
  std::vector<glm::dvec3> sums;
  std::vector<VertexIndex> split(3 * facets);
  for (FacetIndex facet = 0; facet < facets; ++facet) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t own = number(facet, corner), first = corners.find(own);
      // The lowest corner stands for its set, so it is met first.
      if (first == own) {
        split[own] = static_cast<VertexIndex>(smooth.source.size());
        smooth.source.push_back(mesh.facets[facet][corner]);
        sums.emplace_back(0.0);
      }
      const VertexIndex vertex = split[first];
      smooth.of_facet[facet][corner] = vertex;
      // Weights by area keep large planes plane: their neighbours in a fillet take the bend.
      sums[vertex] += geometry.areas[facet] * corner_angle(mesh, facet, corner) * geometry.normals[facet];
    }
  }
  smooth.normals.reserve(sums.size());
  for (const glm::dvec3& sum : sums) {
    const double length = glm::length(sum);
    smooth.normals.push_back(length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0F, 0.0F, 1.0F));
  }
  return smooth;
}

std::vector<EdgeEnds> crease_edges(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                   const Adjacency& adjacency, double crease_deg) {
  const double threshold = std::cos(glm::radians(crease_deg));
  std::vector<EdgeEnds> edges;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (geometry.areas[facet] <= 0.0) continue;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const FacetIndex across = adjacency.across[facet][corner];
      if (across != k_no_facet) {
        if (across < facet || geometry.areas[across] <= 0.0) continue;
        if (glm::dot(geometry.normals[facet], geometry.normals[across]) >= threshold) continue;
      }
      edges.push_back({mesh.facets[facet][corner], mesh.facets[facet][next(corner)]});
    }
  }
  return edges;
}

}  // namespace moldlight
