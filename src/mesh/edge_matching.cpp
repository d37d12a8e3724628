// A step of a repair: open edges that run along each other share their vertices.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/repair.hpp"

namespace moldlight {

namespace {

/// A cube of space with edges of the tolerance; numbers too great for integers are fine.
struct Cell {
  double x, y, z;
  [[nodiscard]] bool operator==(const Cell&) const = default;
};
struct CellHash {
  [[nodiscard]] std::size_t operator()(const Cell& cell) const {
    const std::hash<double> hash;
    return (hash(cell.x) * 31 + hash(cell.y)) * 31 + hash(cell.z);
  }
};

std::vector<bool> vertices_of_open_edges(const TriangleMesh& mesh) {
  std::vector<bool> marked(mesh.vertices.size(), false);
  EdgeTable(mesh).for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
    if (uses.size() == 1) marked[low] = marked[uses[0].high] = true;
  });
  return marked;
}

/// Vertices that others were welded to, findable by place.
class Anchors {
 public:
  Anchors(const TriangleMesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance) {}

  /// The nearest anchor within the tolerance, the first of equally near ones; the vertex becomes one where
  /// there is none.
  [[nodiscard]] VertexIndex find_or_add(VertexIndex vertex) {
    const glm::dvec3& point = mesh_.vertices[vertex];
    const Cell home = {std::floor(point.x / tolerance_), std::floor(point.y / tolerance_),
                       std::floor(point.z / tolerance_)};
    VertexIndex nearest = vertex;
    double least = tolerance_;
    for (double dx = -1.0; dx <= 1.0; dx += 1.0) {
      for (double dy = -1.0; dy <= 1.0; dy += 1.0) {
        for (double dz = -1.0; dz <= 1.0; dz += 1.0) {
          const auto cell = cells_.find({home.x + dx, home.y + dy, home.z + dz});
          if (cell == cells_.end()) continue;
          for (const VertexIndex anchor : cell->second) {
            const double distance = glm::distance(point, mesh_.vertices[anchor]);
            if (distance < least || (distance == least && (nearest == vertex || anchor < nearest))) {
              least = distance;
              nearest = anchor;
            }
          }
        }
      }
    }
    if (nearest == vertex) cells_[home].push_back(vertex);
    return nearest;
  }

 private:
  const TriangleMesh& mesh_;
  double tolerance_;
  std::unordered_map<Cell, std::vector<VertexIndex>, CellHash> cells_;
};

/// As its facet runs through it, without a partner in the other sense.
struct OpenEdge {
  VertexIndex from = 0, to = 0;
  FacetIndex facet = 0;
  bool matched = false;
};

/// Edges that run back along others are matched with them, the longer one cut at the end of the shorter.
class EdgeMatching {
 public:
  EdgeMatching(MeshInRepair& state, double tolerance)
      : state_(state), tolerance_(tolerance), at_(state.mesh.vertices.size()) {
    EdgeTable(state.mesh).for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
      // Of an edge of several bodies, what has no partner in the other sense.
      std::array<std::vector<HalfEdgeIndex>, 2> senses;
      for (const EdgeUse& use : uses)
        senses[start_vertex(state.mesh, use.half_edge) == low ? 0 : 1].push_back(use.half_edge);
      const auto& [rising, falling] = senses;
      const auto& more = rising.size() > falling.size() ? rising : falling;
      for (std::size_t k = std::min(rising.size(), falling.size()); k < more.size(); ++k)
        add({start_vertex(state.mesh, more[k]), end_vertex(state.mesh, more[k]), facet_of(more[k])});
    });
    for (const OpenEdge& edge : edges_) waiting_.push_back(edge.from);
  }

  std::size_t cut_all() {
    std::size_t cuts = 0;
    while (!waiting_.empty()) {
      const std::optional<Pair> pair = best_pair(waiting_.back());
      if (!pair) {
        waiting_.pop_back();
        continue;
      }
      match(*pair);
      ++cuts;
    }
    return cuts;
  }

 private:
  /// The longer one ends or begins where the shorter does the opposite.
  struct Pair {
    std::uint32_t longer = 0, shorter = 0;
    bool longer_ends = false;
  };

  void add(const OpenEdge& edge) {
    const auto number = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back(edge);
    at_[edge.from].push_back(number);
    at_[edge.to].push_back(number);
  }

  [[nodiscard]] std::optional<Pair> best_pair(VertexIndex vertex) const {
    std::optional<Pair> best;
    double least = tolerance_;
    const auto& vertices = state_.mesh.vertices;
    for (const std::uint32_t into : at_[vertex]) {
      if (edges_[into].matched || edges_[into].to != vertex) continue;
      for (const std::uint32_t out_of : at_[vertex]) {
        if (edges_[out_of].matched || edges_[out_of].from != vertex) continue;
        if (edges_[into].from == edges_[out_of].to) continue;
        const glm::dvec3 back = vertices[edges_[into].from] - vertices[vertex];
        const glm::dvec3 on = vertices[edges_[out_of].to] - vertices[vertex];
        const bool longer_ends = glm::length(back) > glm::length(on);
        const glm::dvec3& longer = longer_ends ? back : on;
        const glm::dvec3& shorter = longer_ends ? on : back;
        if (glm::dot(longer, shorter) <= 0.0) continue;
        const double beside = glm::length(glm::cross(glm::normalize(longer), shorter));
        if (beside >= least) continue;
        least = beside;
        best = longer_ends ? Pair{into, out_of, true} : Pair{out_of, into, false};
      }
    }
    return best;
  }

  void match(const Pair& pair) {
    edges_[pair.shorter].matched = edges_[pair.longer].matched = true;
    const OpenEdge longer = edges_[pair.longer], shorter = edges_[pair.shorter];
    const VertexIndex middle = pair.longer_ends ? shorter.to : shorter.from;
    // One half keeps the facet's number.
    auto& corners = state_.mesh.facets[longer.facet];
    const auto k = static_cast<std::size_t>(std::ranges::find(corners, longer.from) - corners.begin());
    CHECK(k < 3 && corners[(k + 1) % 3] == longer.to);
    const VertexIndex tip = corners[(k + 2) % 3];
    corners = {longer.from, middle, tip};
    const auto half = static_cast<FacetIndex>(state_.mesh.facets.size());
    state_.mesh.facets.push_back({middle, longer.to, tip});
    state_.origin.push_back(state_.origin[longer.facet]);
    state_.body.push_back(state_.body[longer.facet]);
    for (const std::uint32_t other : at_[longer.to]) {
      OpenEdge& edge = edges_[other];
      if (edge.facet == longer.facet && edge.from == longer.to && edge.to == tip) edge.facet = half;
    }
    if (pair.longer_ends) {
      add({longer.from, middle, longer.facet});
    } else {
      add({middle, longer.to, half});
    }
    waiting_.push_back(middle);
  }

  MeshInRepair& state_;
  double tolerance_;
  std::vector<OpenEdge> edges_;
  std::vector<std::vector<std::uint32_t>> at_;  // edges at each vertex
  std::vector<VertexIndex> waiting_;
};

}  // namespace

std::size_t weld_near_vertices(TriangleMesh& mesh, double tolerance, const Progress& progress) {
  constexpr VertexIndex k_between = 4096;  // two looks at whether to go on
  if (!(tolerance > 0.0)) return 0;
  const std::vector<bool> is_open = vertices_of_open_edges(mesh);
  std::vector<VertexIndex> new_vertex(mesh.vertices.size());
  Anchors anchors(mesh, tolerance);
  std::size_t welded = 0;
  for (VertexIndex vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    if (vertex % k_between == 0)
      progress.report("repairing", static_cast<double>(vertex) / static_cast<double>(mesh.vertices.size()));
    new_vertex[vertex] = is_open[vertex] ? anchors.find_or_add(vertex) : vertex;
    if (new_vertex[vertex] != vertex) ++welded;
  }
  for (auto& facet : mesh.facets) {
    for (VertexIndex& corner : facet) corner = new_vertex[corner];
  }
  return welded;
}

std::size_t match_open_edges(MeshInRepair& state, double tolerance) {
  return EdgeMatching(state, tolerance).cut_all();
}

}  // namespace moldlight
