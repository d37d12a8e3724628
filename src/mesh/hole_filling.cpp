#include <algorithm>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/edge_table.hpp"
#include "mesh/polygon_triangulation.hpp"
#include "mesh/repair_steps.hpp"

namespace moldlight {

namespace {

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
  std::sort(rim.begin(), rim.end(), [](const RimEdge& a, const RimEdge& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  });
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

FilledHoles fill_holes(MeshInRepair& state, double largest_area, std::size_t most_edges) {
  TriangleMesh& mesh = state.mesh;
  FilledHoles filled;
  PolygonTriangulator triangulator(k_cutting_work);
  std::vector<glm::dvec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const std::vector<RimEdge>& ring : rings_of(rim_edges(mesh), mesh.vertices.size())) {
    if (ring.size() < 3 || ring.size() > most_edges) continue;
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
