// Steps of a repair that drop, split and turn facets, and close holes.

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/polygon_triangulation.hpp"
#include "mesh/repair.hpp"

namespace moldlight {

namespace {

constexpr HalfEdgeIndex k_no_half_edge = std::numeric_limits<HalfEdgeIndex>::max();
constexpr int k_flatten_passes = 8;

/// Keeps the facets that `stays` says, in order; returns how many went.
std::size_t keep_facets(MeshInRepair& state, const std::vector<bool>& stays) {
  std::size_t kept = 0;
  for (std::size_t facet = 0; facet < stays.size(); ++facet) {
    if (!stays[facet]) continue;
    state.mesh.facets[kept] = state.mesh.facets[facet];
    state.origin[kept] = state.origin[facet];
    state.body[kept] = state.body[facet];
    ++kept;
  }
  state.mesh.facets.resize(kept);
  state.origin.resize(kept);
  state.body.resize(kept);
  return stays.size() - kept;
}

/// The half-edge that runs the other way along the same edge, where just two facets use it.
std::vector<HalfEdgeIndex> opposite_half_edges(const TriangleMesh& mesh) {
  std::vector<HalfEdgeIndex> opposite(3 * mesh.facets.size(), k_no_half_edge);
  EdgeTable(mesh).for_each_edge([&](VertexIndex, std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const HalfEdgeIndex a = uses[0].half_edge, b = uses[1].half_edge;
    if (start_vertex(mesh, a) == start_vertex(mesh, b)) return;
    opposite[a] = b;
    opposite[b] = a;
  });
  return opposite;
}

double twice_area(const TriangleMesh& mesh, FacetIndex facet) {
  return glm::length(twice_area_vector(mesh, facet));
}

int longest_edge(const TriangleMesh& mesh, FacetIndex facet) {
  int longest = 0;
  double length = -1.0;
  for (int edge = 0; edge < 3; ++edge) {
    const double this_length = glm::distance(mesh.corner(facet, edge), mesh.corner(facet, (edge + 1) % 3));
    if (this_length > length) {
      length = this_length;
      longest = edge;
    }
  }
  return longest;
}

/// A facet next to another; `agrees` where they run through the edge in opposite senses.
struct Neighbour {
  FacetIndex facet = k_no_facet;
  bool agrees = true;
};

std::vector<std::array<Neighbour, 3>> neighbours_of(const TriangleMesh& mesh) {
  std::vector<std::array<Neighbour, 3>> neighbours(mesh.facets.size());
  EdgeTable(mesh).for_each_edge([&](VertexIndex, std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const HalfEdgeIndex a = uses[0].half_edge, b = uses[1].half_edge;
    const bool agrees = start_vertex(mesh, a) != start_vertex(mesh, b);
    neighbours[facet_of(a)][a % 3] = {facet_of(b), agrees};
    neighbours[facet_of(b)][b % 3] = {facet_of(a), agrees};
  });
  return neighbours;
}

constexpr std::uint64_t k_cutting_work = 500'000'000;

/// The rim of a hole runs against the open edge of the facet beside it.
struct RimEdge {
  VertexIndex from = 0, to = 0;
  FacetIndex beside = 0;
};

std::vector<RimEdge> rim_edges(const TriangleMesh& mesh) {
  std::vector<RimEdge> rim;
  EdgeTable(mesh).for_each_edge([&](VertexIndex, std::span<const EdgeUse> uses) {
    if (uses.size() != 1) return;
    const HalfEdgeIndex open = uses[0].half_edge;
    rim.push_back({end_vertex(mesh, open), start_vertex(mesh, open), facet_of(open)});
  });
  std::ranges::sort(rim, {}, [](const RimEdge& edge) { return std::pair(edge.from, edge.to); });
  return rim;
}

/// Rings of rim edges that pass no vertex twice, each rim edge at most once.
std::vector<std::vector<RimEdge>> rings_of(const std::vector<RimEdge>& rim, std::size_t vertex_count) {
  std::vector<bool> used(rim.size(), false);
  std::vector<std::size_t> place_in_path(vertex_count, rim.size());
  std::vector<std::vector<RimEdge>> rings;
  std::vector<RimEdge> path;
  const auto next_from = [&](VertexIndex vertex) -> std::optional<std::size_t> {
    auto edge = std::lower_bound(rim.begin(), rim.end(), vertex,
                                 [](const RimEdge& e, VertexIndex v) { return e.from < v; });
    for (; edge != rim.end() && edge->from == vertex; ++edge) {
      const auto index = static_cast<std::size_t>(edge - rim.begin());
      if (!used[index]) return index;
    }
    return std::nullopt;
  };
  for (std::size_t start = 0; start < rim.size(); ++start) {
    if (used[start]) continue;
    VertexIndex at = rim[start].from;
    place_in_path[at] = 0;
    while (const auto next = next_from(at)) {
      used[*next] = true;
      path.push_back(rim[*next]);
      at = rim[*next].to;
      if (place_in_path[at] == rim.size()) {
        place_in_path[at] = path.size();
        continue;
      }
      const auto ring_start = path.begin() + static_cast<std::ptrdiff_t>(place_in_path[at]);
      rings.emplace_back(ring_start, path.end());
      for (auto edge = ring_start; edge != path.end(); ++edge) {
        if (edge->to != at) place_in_path[edge->to] = rim.size();
      }
      path.erase(ring_start, path.end());
      if (path.empty()) break;
    }
    place_in_path[rim[start].from] = rim.size();
    for (const RimEdge& edge : path) place_in_path[edge.from] = place_in_path[edge.to] = rim.size();
    path.clear();
  }
  return rings;
}

double area_of(const std::vector<glm::dvec3>& points,
               const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  double area = 0.0;
  for (const auto& [a, b, c] : triangles) {
    area += 0.5 * glm::length(glm::cross(points[b] - points[a], points[c] - points[a]));
  }
  return area;
}

}  // namespace

std::size_t drop_collapsed_facets(MeshInRepair& state) {
  std::vector<bool> stays;
  for (const auto& facet : state.mesh.facets) stays.push_back(!is_collapsed(facet));
  return keep_facets(state, stays);
}

std::size_t flatten_facets_without_area(MeshInRepair& state) {
  TriangleMesh& mesh = state.mesh;
  std::size_t flattened = 0;
  for (int pass = 0; pass < k_flatten_passes; ++pass) {
    const std::vector<HalfEdgeIndex> opposite = opposite_half_edges(mesh);
    std::vector<bool> changed(mesh.facets.size(), false);
    const std::size_t before = flattened;
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      if (changed[facet] || is_collapsed(mesh.facets[facet]) || twice_area(mesh, facet) > 0.0) continue;
      const HalfEdgeIndex edge = 3 * facet + static_cast<HalfEdgeIndex>(longest_edge(mesh, facet));
      if (opposite[edge] == k_no_half_edge) continue;
      const FacetIndex across = facet_of(opposite[edge]);
      if (changed[across] || twice_area(mesh, across) <= 0.0) continue;
      const VertexIndex from = start_vertex(mesh, edge), to = end_vertex(mesh, edge);
      const VertexIndex third = mesh.facets[facet][(edge % 3 + 2) % 3];
      const VertexIndex tip = mesh.facets[across][(opposite[edge] % 3 + 2) % 3];
      if (tip == third) continue;
      // The facet across runs from `to` to `from`; its halves meet in the edge from the tip to the third
      // corner.
      mesh.facets[across] = {to, third, tip};
      mesh.facets[facet] = {third, from, tip};
      state.origin[facet] = state.origin[across];
      changed[facet] = changed[across] = true;
      ++flattened;
    }
    if (flattened == before) break;
  }
  return flattened;
}

std::size_t drop_duplicate_facets(MeshInRepair& state) {
  struct Entry {
    std::array<VertexIndex, 3> sorted;
    FacetIndex facet;
    bool odd;  // winding against the sorted one
  };
  std::vector<Entry> entries;
  for (FacetIndex facet = 0; facet < state.mesh.facets.size(); ++facet) {
    std::array<VertexIndex, 3> corners = state.mesh.facets[facet];
    if (is_collapsed(corners)) continue;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    const bool odd = corners[1] > corners[2];
    if (odd) std::swap(corners[1], corners[2]);
    entries.push_back({corners, facet, odd});
  }
  std::ranges::sort(entries, {}, [](const Entry& entry) { return std::pair(entry.sorted, entry.facet); });
  std::vector<bool> stays(state.mesh.facets.size(), true);
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    std::ptrdiff_t even = 0;
    while (end < entries.size() && entries[end].sorted == entries[begin].sorted)
      even += entries[end++].odd ? -1 : 1;
    if (end - begin == 1) continue;
    for (std::size_t i = begin; i < end; ++i) stays[entries[i].facet] = false;
    if (even == 0) continue;
    const auto kept = std::find_if(entries.begin() + static_cast<std::ptrdiff_t>(begin), entries.end(),
                                   [&](const Entry& entry) { return entry.odd == (even < 0); });
    stays[kept->facet] = true;
  }
  return keep_facets(state, stays);
}

std::size_t count_open_edges(const TriangleMesh& mesh) {
  std::size_t count = 0;
  EdgeTable(mesh).for_each_edge(
      [&](VertexIndex, std::span<const EdgeUse> uses) { count += uses.size() == 1 ? 1 : 0; });
  return count;
}

std::size_t make_winding_consistent(TriangleMesh& mesh) {
  const std::vector<std::array<Neighbour, 3>> neighbours = neighbours_of(mesh);
  std::vector<bool> seen(mesh.facets.size(), false), turned(mesh.facets.size(), false);
  std::size_t count = 0;
  std::vector<FacetIndex> patch;
  for (FacetIndex first = 0; first < mesh.facets.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = true;
    patch.assign(1, first);
    double area_kept = 0.0, area_turned = 0.0;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      const FacetIndex facet = patch[next];
      (turned[facet] ? area_turned : area_kept) += 0.5 * twice_area(mesh, facet);
      for (const Neighbour& neighbour : neighbours[facet]) {
        if (neighbour.facet == k_no_facet || seen[neighbour.facet]) continue;
        seen[neighbour.facet] = true;
        turned[neighbour.facet] = turned[facet] != !neighbour.agrees;
        patch.push_back(neighbour.facet);
      }
    }
    for (const FacetIndex facet : patch) {
      if (turned[facet] == (area_turned > area_kept)) continue;
      std::swap(mesh.facets[facet][1], mesh.facets[facet][2]);
      ++count;
    }
  }
  return count;
}

FilledHoles fill_holes(MeshInRepair& state, double largest_area, std::size_t most_edges,
                       const Progress& progress) {
  TriangleMesh& mesh = state.mesh;
  FilledHoles filled;
  PolygonTriangulator triangulator(k_cutting_work);
  std::vector<glm::dvec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const std::vector<RimEdge>& ring : rings_of(rim_edges(mesh), mesh.vertices.size())) {
    if (ring.size() < 3 || ring.size() > most_edges) continue;
    if (progress.cancelled()) throw Cancelled();
    points.clear();
    for (const RimEdge& edge : ring) points.push_back(mesh.vertices[edge.from]);
    if (triangulator.triangulate(points, triangles) == PolygonCut::fan_of_odd) continue;
    const double area = area_of(points, triangles);
    if (area > largest_area) continue;
    ++filled.holes;
    filled.facets += triangles.size();
    filled.area += area;
    for (const auto& [a, b, c] : triangles) {
      mesh.facets.push_back({ring[a].from, ring[b].from, ring[c].from});
      state.origin.push_back(k_no_facet);
      state.body.push_back(state.body[ring[0].beside]);
    }
  }
  return filled;
}

}  // namespace moldlight
