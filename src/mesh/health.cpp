#include "mesh/health.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "base/numbers.hpp"
#include "mesh/adjacency.hpp"

namespace moldlight {

namespace {

VertexIndex opposite_vertex(const TriangleMesh& mesh, HalfEdgeIndex half_edge) {
  return mesh.facets[half_edge / 3][(half_edge % 3 + 2) % 3];
}

/// Each facet is seen once: at the edge of its two lowest vertices.
std::size_t count_duplicates(const TriangleMesh& mesh, std::span<const EdgeUse> uses,
                             std::vector<VertexIndex>& thirds) {
  thirds.clear();
  for (const EdgeUse& use : uses) {
    const VertexIndex third = opposite_vertex(mesh, use.half_edge);
    if (third > use.high) thirds.push_back(third);
  }
  std::sort(thirds.begin(), thirds.end());
  return static_cast<std::size_t>(thirds.end() - std::unique(thirds.begin(), thirds.end()));
}

void count_edges(const TriangleMesh& mesh, const EdgeTable& edges, HealthReport& report) {
  bool any = false, balanced = true;
  std::vector<VertexIndex> thirds;
  edges.for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
    std::size_t upward = 0;
    for (const EdgeUse& use : uses) upward += start_vertex(mesh, use.half_edge) == low ? 1 : 0;
    any = true;
    balanced = balanced && 2 * upward == uses.size();
    if (uses.size() == 1) ++report.open_edges;
    if (uses.size() == 2 && upward != 1) ++report.inconsistent_edges;
    if (uses.size() > 2) ++report.nonmanifold_edges;
    report.duplicate_facets += count_duplicates(mesh, uses, thirds);
  });
  report.closed = any && balanced;
}

std::size_t count_used_vertices(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex vertex : facet) used[vertex] = true;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

constexpr std::uint32_t k_none = 0xFFFF'FFFF;

struct DefectEdge {
  VertexIndex low = 0, high = 0;
  FacetIndex facet = 0;
};

bool has_defect(const TriangleMesh& mesh, std::span<const EdgeUse> uses, EdgeDefect defect) {
  switch (defect) {
    case EdgeDefect::open:
      return uses.size() == 1;
    case EdgeDefect::nonmanifold:
      return uses.size() > 2;
    case EdgeDefect::inconsistent:
      return uses.size() == 2 &&
             start_vertex(mesh, uses[0].half_edge) == start_vertex(mesh, uses[1].half_edge);
  }
  return false;
}

std::vector<DefectEdge> defect_edges(const TriangleMesh& mesh, EdgeDefect defect) {
  std::vector<DefectEdge> edges;
  EdgeTable(mesh).for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
    if (!has_defect(mesh, uses, defect)) return;
    FacetIndex facet = k_no_facet;
    for (const EdgeUse& use : uses) facet = std::min(facet, facet_of(use.half_edge));
    edges.push_back({low, uses.front().high, facet});
  });
  return edges;
}

/// Walks the graph of the edges; each edge ends up in one chain.
class ChainWalk {
 public:
  ChainWalk(const TriangleMesh& mesh, const std::vector<DefectEdge>& edges)
      : mesh_(mesh),
        edges_(edges),
        used_(edges.size(), false),
        next_spoke_(mesh.vertices.size() + 1, 0),
        place_on_path_(mesh.vertices.size(), k_none) {
    for (const DefectEdge& edge : edges) {
      ++next_spoke_[edge.low + 1];
      ++next_spoke_[edge.high + 1];
    }
    std::partial_sum(next_spoke_.begin(), next_spoke_.end(), next_spoke_.begin());
    end_spoke_.assign(next_spoke_.begin(), next_spoke_.end() - 1);
    spokes_.resize(2 * edges.size());
    for (std::uint32_t edge = 0; edge < edges.size(); ++edge) {
      spokes_[end_spoke_[edges[edge].low]++] = edge;
      spokes_[end_spoke_[edges[edge].high]++] = edge;
    }
  }

  std::vector<EdgeChain> run() {
    // Loose ends first: a walk that begins elsewhere would cut the chain that ends there in two.
    for (VertexIndex vertex = 0; vertex < end_spoke_.size(); ++vertex) {
      if ((end_spoke_[vertex] - next_spoke_[vertex]) % 2 == 1) loose_ends_.push_back(vertex);
    }
    for (const VertexIndex vertex : loose_ends_) walk_from(vertex);
    for (const DefectEdge& edge : edges_) walk_from(edge.low);
    return std::move(chains_);
  }

 private:
  [[nodiscard]] std::uint32_t unused_edge_at(VertexIndex vertex) {
    std::uint32_t& spoke = next_spoke_[vertex];
    while (spoke < end_spoke_[vertex] && used_[spokes_[spoke]]) ++spoke;
    return spoke < end_spoke_[vertex] ? spokes_[spoke] : k_none;
  }

  /// Follows unused edges; whenever the path meets itself, the loop that this closes is cut off.
  void walk_from(VertexIndex vertex) {
    path_.assign(1, vertex);
    path_edges_.clear();
    place_on_path_[vertex] = 0;
    for (std::uint32_t edge = unused_edge_at(vertex); edge != k_none; edge = unused_edge_at(vertex)) {
      used_[edge] = true;
      path_edges_.push_back(edge);
      vertex = edges_[edge].low == vertex ? edges_[edge].high : edges_[edge].low;
      if (place_on_path_[vertex] == k_none) {
        place_on_path_[vertex] = static_cast<std::uint32_t>(path_.size());
        path_.push_back(vertex);
      } else {
        cut_off(place_on_path_[vertex], true);
      }
    }
    if (!path_edges_.empty()) cut_off(0, false);
    place_on_path_[path_.front()] = k_none;
  }

  void cut_off(std::uint32_t begin, bool closed) {
    EdgeChain chain;
    chain.closed = closed;
    chain.vertices.assign(path_.begin() + begin, path_.end());
    chain.facet = k_no_facet;
    for (std::size_t i = begin; i < path_edges_.size(); ++i) {
      const DefectEdge& edge = edges_[path_edges_[i]];
      chain.facet = std::min(chain.facet, edge.facet);
      chain.length += glm::distance(mesh_.vertices[edge.low], mesh_.vertices[edge.high]);
    }
    for (const VertexIndex vertex : chain.vertices) chain.bounds.add(mesh_.vertices[vertex]);
    for (std::size_t i = begin + 1; i < path_.size(); ++i) place_on_path_[path_[i]] = k_none;
    path_.resize(begin + 1);
    path_edges_.resize(begin);
    chains_.push_back(std::move(chain));
  }

  const TriangleMesh& mesh_;
  const std::vector<DefectEdge>& edges_;
  std::vector<bool> used_;                 // edges that are in a chain or on the path
  std::vector<std::uint32_t> spokes_;      // edges, grouped by vertex
  std::vector<std::uint32_t> next_spoke_;  // of each vertex: the first in spokes_ that may still be unused
  std::vector<std::uint32_t> end_spoke_;
  std::vector<VertexIndex> loose_ends_;
  std::vector<std::uint32_t> place_on_path_;  // of each vertex of the mesh, or k_none
  std::vector<VertexIndex> path_;
  std::vector<std::uint32_t> path_edges_;
  std::vector<EdgeChain> chains_;
};

}  // namespace

double signed_volume(const TriangleMesh& mesh) {
  // About the box's center, so that a part far from the origin keeps its digits.
  const glm::dvec3 center = bounds(mesh).center();
  double six_volumes = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    six_volumes += glm::dot(mesh.corner(facet, 0) - center,
                            glm::cross(mesh.corner(facet, 1) - center, mesh.corner(facet, 2) - center));
  }
  return six_volumes / 6.0;
}

HealthReport health_report(const TriangleMesh& mesh, const FacetGeometry& geometry, const EdgeTable& edges) {
  CHECK(geometry.areas.size() == mesh.facets.size());
  HealthReport report;
  report.facets = mesh.facets.size();
  report.vertices = count_used_vertices(mesh);
  report.components = connected_components(mesh, edges).count;
  report.area = geometry.total_area;
  report.volume = signed_volume(mesh);
  report.bounds = bounds(mesh);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (is_collapsed(mesh.facets[facet]) || geometry.areas[facet] <= 0.0) ++report.degenerate_facets;
  }
  count_edges(mesh, edges, report);
  return report;
}

std::vector<std::string> health_warnings(const HealthReport& report) {
  std::vector<std::string> warnings;
  if (report.area <= 0.0) {
    warnings.push_back("The part has no area: all figures are zero.");
    return warnings;
  }
  if (report.open_edges > 0) {
    warnings.push_back(
        fmt::format("{}: the part is not closed, so volume and regions seen through the gaps are in doubt.",
                    plural(report.open_edges, "open edge")));
  }
  if (report.inconsistent_edges > 0) {
    warnings.push_back(fmt::format(
        "{} between facets wound in opposite ways: some facets are inside out and their region is in doubt.",
        plural(report.inconsistent_edges, "edge")));
  }
  if (report.nonmanifold_edges > 0) {
    warnings.push_back(fmt::format(
        "{} shared by more than two facets: {}.", plural(report.nonmanifold_edges, "edge"),
        report.closed ? "bodies touch there, the figures hold" : "inside and outside are in doubt there"));
  }
  if (report.closed && report.volume < 0.0) {
    warnings.push_back("The part is inside out (its volume is negative): every region is in doubt.");
  }
  if (report.duplicate_facets > 0) {
    warnings.push_back(
        fmt::format("{}: such area counts twice.", plural(report.duplicate_facets, "duplicate facet")));
  }
  if (report.degenerate_facets > 0) {
    warnings.push_back(
        fmt::format("{} without area: left out of the figures.", plural(report.degenerate_facets, "facet")));
  }
  return warnings;
}

std::vector<EdgeChain> defect_chains(const TriangleMesh& mesh, EdgeDefect defect) {
  const std::vector<DefectEdge> edges = defect_edges(mesh, defect);
  if (edges.empty()) return {};
  std::vector<EdgeChain> chains = ChainWalk(mesh, edges).run();
  std::ranges::stable_sort(chains, std::greater{}, &EdgeChain::length);
  return chains;
}

}  // namespace moldlight
