#include "pieces/locked_loops.hpp"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "mesh/union_find.hpp"
#include "parting/piece_edges.hpp"

namespace moldlight {

namespace {

constexpr std::uint32_t k_no_edge = ~0U;
/// Pairs of segments that are looked at: some seconds of one core.
constexpr double k_most_pairs_of_segments = 2e9;
/// How far cycles are moved off the surface, in diagonals of the mesh: more than the needles that splitting
/// leaves are wide, and less than walls are thick.
constexpr double k_off = 1e-6;
/// No direction of any mesh.
const glm::dvec3 k_viewed = glm::normalize(glm::dvec3(0.5377, 0.3161, 0.7817));

/// A forest over nodes that edges join: towards which node each goes, and by which edge.
struct Forest {
  explicit Forest(std::size_t nodes) : parent(nodes, 0), edge(nodes, k_no_edge), depth(nodes, 0) {}
  std::vector<std::uint32_t> parent, edge, depth;

  /// The edges from one node to another; `forward` is false for those that are run from parent to child.
  template <typename Visit>
  void path(std::uint32_t from, std::uint32_t to, Visit&& visit) const {
    std::vector<std::uint32_t> back;
    while (from != to) {
      std::uint32_t& lower = depth[from] >= depth[to] ? from : to;
      if (&lower == &from)
        visit(edge[from], from);
      else
        back.push_back(to);
      lower = parent[lower];
    }
    for (auto node = back.rbegin(); node != back.rend(); ++node) visit(edge[*node], parent[*node]);
  }
};

/// What joins two nodes.
struct Joint {
  std::uint32_t a = 0, b = 0, edge = 0;
};

Forest spanning_forest(std::size_t nodes, std::span<const Joint> joints) {
  std::vector<std::uint32_t> first(nodes + 1, 0);
  for (const Joint& joint : joints) ++first[joint.a], ++first[joint.b];
  std::inclusive_scan(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> at(2 * joints.size());
  for (std::uint32_t k = 0; k < joints.size(); ++k) at[--first[joints[k].a]] = at[--first[joints[k].b]] = k;
  Forest forest(nodes);
  std::vector<std::uint8_t> reached(nodes, 0);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t root = 0; root < nodes; ++root) {
    if (reached[root] != 0) continue;
    reached[root] = 1;
    queue.assign(1, root);
    for (std::size_t k = 0; k < queue.size(); ++k) {
      const std::uint32_t node = queue[k];
      for (std::uint32_t i = first[node]; i < first[node + 1]; ++i) {
        const Joint& joint = joints[at[i]];
        const std::uint32_t other = joint.a == node ? joint.b : joint.a;
        if (reached[other] != 0) continue;
        reached[other] = 1;
        forest.parent[other] = node;
        forest.edge[other] = joint.edge;
        forest.depth[other] = forest.depth[node] + 1;
        queue.push_back(other);
      }
    }
  }
  return forest;
}

/// An edge that a cycle runs along, or a piece's side that one crosses, in the sense of the edge or against.
struct Step {
  std::uint32_t edge = 0;
  bool forward = true;
};
using Cycle = std::vector<Step>;

class LoopFinder {
 public:
  LoopFinder(const SplitMesh& mesh, std::span<const glm::dvec3> normals,
             std::span<const std::uint32_t> formed_by)
      : mesh_(mesh), formed_by_(formed_by), edges_(piece_edges(mesh)) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), k_viewed));
    const glm::dvec3 up = glm::cross(k_viewed, right);
    const auto seen = [&](const glm::dvec3& p) {
      return glm::dvec3(glm::dot(p, right), glm::dot(p, up), glm::dot(p, k_viewed));
    };
    Bounds box;
    for (const glm::dvec3& vertex : mesh.vertices) box.add(vertex);
    const double off = k_off * box.diagonal();
    const auto moved = [&](const glm::dvec3& point, const glm::dvec3& normal, double by) {
      const double length = glm::length(normal);
      return seen(length > 0.0 ? point + by / length * normal : point);
    };
    const auto normal_of = [&](PieceIndex piece) { return normals[mesh.pieces[piece].facet]; };
    std::vector<glm::dvec3> outward(mesh.vertices.size(), glm::dvec3(0.0));
    for (PieceIndex piece = 0; piece < mesh.pieces.size(); ++piece) {
      const double area = glm::length(twice_piece_area(mesh, piece));
      for (const VertexIndex corner : mesh.pieces[piece].corners) outward[corner] += area * normal_of(piece);
      middles_.push_back(moved(mesh.middle(piece), normal_of(piece), -off));
    }
    for (std::size_t k = 0; k < mesh.vertices.size(); ++k)
      corners_.push_back(moved(mesh.vertices[k], outward[k], off));
    for (const PieceEdge& edge : edges_.edges) {
      const glm::dvec3 across = edge.right == k_no_piece ? glm::dvec3(0.0) : normal_of(edge.right);
      passed_.push_back(moved(0.5 * (mesh.vertices[edge.from] + mesh.vertices[edge.to]),
                              normal_of(edge.left) + across, -off));
    }
  }

  [[nodiscard]] bool closed() const {
    return std::ranges::all_of(edges_.edges, [](const PieceEdge& edge) { return edge.right != k_no_piece; });
  }
  /// Cycles on what piece `by` of the mold forms; with those that bound a surface of it among them.
  [[nodiscard]] std::vector<Cycle> along(std::uint32_t by) const;
  /// Cycles from piece to piece that generate those of the whole surface.
  [[nodiscard]] std::vector<Cycle> across() const;
  [[nodiscard]] int linking(const Cycle& along, const Cycle& across) const;

 private:
  /// Edges of which neither forest has need: each closes a cycle.
  struct Basis {
    Forest vertices, pieces;
    std::vector<std::uint32_t> rest;
  };
  [[nodiscard]] Basis basis(const auto& counts) const;
  [[nodiscard]] std::vector<Cycle> closed_by(std::span<const std::uint32_t> rest, const Forest& forest,
                                             std::uint32_t PieceEdge::*from,
                                             std::uint32_t PieceEdge::*to) const;

  const SplitMesh& mesh_;
  std::span<const std::uint32_t> formed_by_;
  PieceEdges edges_;
  // As seen along k_viewed: corners outside of the solid, middles of pieces and of edges inside.
  std::vector<glm::dvec3> corners_, middles_, passed_;
};

LoopFinder::Basis LoopFinder::basis(const auto& counts) const {
  std::vector<Joint> joints;
  for (std::uint32_t k = 0; k < edges_.edges.size(); ++k) {
    const PieceEdge& edge = edges_.edges[k];
    if (counts(edge.left) || counts(edge.right)) joints.push_back({edge.from, edge.to, k});
  }
  Forest vertices = spanning_forest(mesh_.vertices.size(), joints);
  std::vector<std::uint8_t> used(edges_.edges.size(), 0);
  const auto take = [&](const Forest& forest) {
    for (const std::uint32_t edge : forest.edge)
      if (edge != k_no_edge) used[edge] = 1;
  };
  take(vertices);
  std::vector<Joint> over;
  for (const Joint& joint : joints) {
    const PieceEdge& edge = edges_.edges[joint.edge];
    if (used[joint.edge] == 0 && counts(edge.left) && counts(edge.right))
      over.push_back({edge.left, edge.right, joint.edge});
  }
  Forest pieces = spanning_forest(mesh_.pieces.size(), over);
  take(pieces);
  std::vector<std::uint32_t> rest;
  for (const Joint& joint : joints)
    if (used[joint.edge] == 0) rest.push_back(joint.edge);
  return {std::move(vertices), std::move(pieces), std::move(rest)};
}

/// Each edge of the rest, run over or crossed, and back through the forest. An edge goes `from` one of its
/// two nodes `to` the other.
std::vector<Cycle> LoopFinder::closed_by(std::span<const std::uint32_t> rest, const Forest& forest,
                                         std::uint32_t PieceEdge::*from, std::uint32_t PieceEdge::*to) const {
  std::vector<Cycle> cycles;
  for (const std::uint32_t last : rest) {
    Cycle cycle = {{last, true}};
    forest.path(edges_.edges[last].*to, edges_.edges[last].*from,
                [&](std::uint32_t edge, std::uint32_t node) {
                  cycle.push_back({edge, edges_.edges[edge].*from == node});
                });
    cycles.push_back(std::move(cycle));
  }
  return cycles;
}

std::vector<Cycle> LoopFinder::along(std::uint32_t by) const {
  const Basis found = basis([&](PieceIndex piece) { return formed_by_[piece] == by; });
  return closed_by(found.rest, found.vertices, &PieceEdge::from, &PieceEdge::to);
}

std::vector<Cycle> LoopFinder::across() const {
  const Basis found = basis([](PieceIndex) { return true; });
  return closed_by(found.rest, found.pieces, &PieceEdge::left, &PieceEdge::right);
}

double turn(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.y - a.y * b.x; }

/// Of the crossings as seen those where the first runs over the second, by their sense.
int LoopFinder::linking(const Cycle& along, const Cycle& across) const {
  int sum = 0;
  for (const Step& over : along) {
    const PieceEdge& edge = edges_.edges[over.edge];
    const glm::dvec3 &from = corners_[over.forward ? edge.from : edge.to],
                     &to = corners_[over.forward ? edge.to : edge.from];
    const glm::dvec3 way = to - from;
    const double low = std::min(from.x, to.x), high = std::max(from.x, to.x), top = std::max(from.z, to.z);
    for (const Step& under : across) {
      const PieceEdge& crossed = edges_.edges[under.edge];
      const glm::dvec3 &first = middles_[under.forward ? crossed.left : crossed.right],
                       &second = middles_[under.forward ? crossed.right : crossed.left];
      const glm::dvec3& passed = passed_[under.edge];
      for (const auto& [start, end] : {std::pair(first, passed), std::pair(passed, second)}) {
        if (std::max(start.x, end.x) < low || std::min(start.x, end.x) > high ||
            std::min(start.z, end.z) > top)
          continue;
        const double before = turn(way, start - from), after = turn(way, end - from);
        if ((before > 0.0) == (after > 0.0)) continue;
        const glm::dvec3 other = end - start;
        const double back = turn(other, from - start), ahead = turn(other, to - start);
        if ((back > 0.0) == (ahead > 0.0)) continue;
        const double height = from.z + way.z * back / (back - ahead);
        if (height > start.z + other.z * before / (before - after)) sum += after > before ? 1 : -1;
      }
    }
  }
  return sum;
}

/// Of a matrix of whole numbers, modulo a prime.
std::size_t rank_of(std::vector<std::vector<std::int64_t>> rows) {
  constexpr std::int64_t k_prime = 2'147'483'647;
  const auto inverse = [&](std::int64_t value) {
    std::int64_t result = 1;
    for (std::int64_t power = k_prime - 2; power > 0; power /= 2, value = value * value % k_prime)
      if (power % 2 == 1) result = result * value % k_prime;
    return result;
  };
  for (auto& row : rows)
    for (std::int64_t& value : row) value = (value % k_prime + k_prime) % k_prime;
  std::size_t rank = 0;
  for (std::size_t column = 0; !rows.empty() && column < rows[0].size() && rank < rows.size(); ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const auto& row) { return row[column] != 0; });
    if (pivot == rows.end()) continue;
    std::swap(*pivot, rows[rank]);
    const std::int64_t scale = inverse(rows[rank][column]);
    for (std::size_t k = rank + 1; k < rows.size(); ++k) {
      const std::int64_t factor = rows[k][column] * scale % k_prime;
      for (std::size_t c = column; factor != 0 && c < rows[k].size(); ++c)
        rows[k][c] = (rows[k][c] + (k_prime - factor) * rows[rank][c]) % k_prime;
    }
    ++rank;
  }
  return rank;
}

}  // namespace

std::optional<std::vector<std::size_t>> locked_loops(const SplitMesh& mesh,
                                                     std::span<const glm::dvec3> normals,
                                                     std::span<const std::uint32_t> formed_by,
                                                     std::size_t count, const Progress& progress) {
  const LoopFinder finder(mesh, normals, formed_by);
  if (!finder.closed()) return std::nullopt;
  const std::vector<Cycle> inside = finder.across();
  const auto steps = [](const std::vector<Cycle>& cycles) {
    return std::accumulate(cycles.begin(), cycles.end(), 0.0, [](double sum, const Cycle& cycle) {
      return sum + 2.0 * static_cast<double>(cycle.size());
    });
  };
  std::vector<std::size_t> found(count, 0);
  for (std::uint32_t by = 0; by < count && !inside.empty(); ++by) {
    const std::vector<Cycle> outside = finder.along(by);
    if (steps(outside) * steps(inside) > k_most_pairs_of_segments) return std::nullopt;
    std::vector<std::vector<std::int64_t>> rows(outside.size());
    tbb::parallel_for(std::size_t{0}, outside.size(), [&](std::size_t k) {
      for (const Cycle& cycle : inside)
        rows[k].push_back(progress.cancelled() ? 0 : finder.linking(outside[k], cycle));
    });
    if (progress.cancelled()) throw Cancelled();
    found[by] = rank_of(std::move(rows));
  }
  return found;
}

}  // namespace moldlight
