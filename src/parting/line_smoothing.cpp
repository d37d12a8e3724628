#include "parting/line_smoothing.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/piece_edges.hpp"

namespace moldlight {

namespace {

constexpr int k_most_smoothings = 12;
constexpr double k_least_gain = 1e-3;  // of a loop's length with its climb
/// Where more pieces are around a vertex, as where thousands meet in one, the line stays as it is.
constexpr std::size_t k_most_around = 1000;
constexpr double k_off_surface = 1e-4;  // of the diagonal

double cost_of(const std::vector<glm::dvec3>& points, const glm::dvec3& d) {
  double cost = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k)
    cost += line_cost(points[(k + 1) % points.size()] - points[k], d);
  return cost;
}

}  // namespace

LineSmoother::LineSmoother(const Assignment& assignment)
    : assignment_(assignment), first_(assignment.mesh.vertices.size() + 1, 0) {
  const SplitMesh& mesh = assignment.mesh;
  Bounds box;
  for (const SplitPiece& piece : mesh.pieces) {
    for (const VertexIndex v : piece.corners) {
      ++first_[v + 1];
      box.add(mesh.vertices[v]);
    }
  }
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  pieces_.resize(first_.back());
  std::vector<std::uint32_t> filled(first_.begin(), first_.end() - 1);
  for (PieceIndex piece = 0; piece < mesh.pieces.size(); ++piece) {
    for (const VertexIndex v : mesh.pieces[piece].corners) pieces_[filled[v]++] = piece;
  }
  if (!mesh.pieces.empty()) tolerance_ = k_off_surface * glm::distance(box.min, box.max);
}

std::vector<PieceIndex> LineSmoother::around(VertexIndex vertex) const {
  std::vector<PieceIndex> found;
  if (first_[vertex + 1] - first_[vertex] > k_most_around) return found;
  std::vector<VertexIndex> corners;
  for (std::uint32_t k = first_[vertex]; k < first_[vertex + 1]; ++k) {
    const auto& of_piece = assignment_.mesh.pieces[pieces_[k]].corners;
    corners.insert(corners.end(), of_piece.begin(), of_piece.end());
  }
  std::ranges::sort(corners);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (const VertexIndex v : corners) {
    if (found.size() + first_[v + 1] - first_[v] > k_most_around) return {};
    found.insert(found.end(), pieces_.begin() + first_[v], pieces_.begin() + first_[v + 1]);
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

LineSmoother::Nearest LineSmoother::nearest(std::span<const PieceIndex> pieces, const glm::dvec3& at) const {
  Nearest nearest{.to_free = INFINITY, .to_others = INFINITY};
  for (const PieceIndex piece : pieces) {
    const auto& corners = assignment_.mesh.pieces[piece].corners;
    const glm::dvec3 on =
        nearest_in_triangle(at, {assignment_.mesh.vertices[corners[0]], assignment_.mesh.vertices[corners[1]],
                                 assignment_.mesh.vertices[corners[2]]});
    const double away = glm::distance(on, at);
    double& least = assignment_.free[piece] != 0 ? nearest.to_free : nearest.to_others;
    if (away >= least) continue;
    least = away;
    if (assignment_.free[piece] != 0) nearest.free = on;
  }
  return nearest;
}

bool LineSmoother::may_run(std::span<const PieceIndex> near_a, std::span<const PieceIndex> near_b,
                           const glm::dvec3& a, const glm::dvec3& b) const {
  for (const double share : {0.25, 0.5, 0.75}) {
    const glm::dvec3 at = glm::mix(a, b, share);
    Nearest found = nearest(near_a, at);
    const Nearest other = nearest(near_b, at);
    found.to_free = std::min(found.to_free, other.to_free);
    found.to_others = std::min(found.to_others, other.to_others);
    if (found.to_free > tolerance_ || found.to_free > found.to_others + 1e-3 * tolerance_) return false;
  }
  return true;
}

std::vector<glm::dvec3> LineSmoother::smoothed(const Loop& loop) const {
  const std::size_t count = loop.vertices.size();
  const glm::dvec3& d = assignment_.direction;
  std::vector<glm::dvec3> points;
  for (const VertexIndex v : loop.vertices) points.push_back(assignment_.mesh.vertices[v]);
  const std::vector<glm::dvec3> before = points;
  std::vector<std::uint8_t> movable(count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    if (assignment_.crease[loop.edges[k]] != 0 ||
        assignment_.crease[loop.edges[(k + count - 1) % count]] != 0)
      continue;
    bool any_free = false, any_action = false;
    for (std::uint32_t i = first_[loop.vertices[k]]; i < first_[loop.vertices[k] + 1]; ++i) {
      any_free = any_free || assignment_.free[pieces_[i]] != 0;
      any_action = any_action || assignment_.sides[pieces_[i]] == MoldSide::action;
    }
    movable[k] = any_free && !any_action ? 1 : 0;
  }
  if (count < 4 || std::ranges::find(movable, 1) == movable.end()) return points;
  std::vector<std::vector<PieceIndex>> near(count);
  for (std::size_t k = 0; k < count; ++k) {
    if (movable[k] != 0 || movable[(k + 1) % count] != 0 || movable[(k + count - 1) % count] != 0)
      near[k] = around(loop.vertices[k]);
  }
  for (int round = 0; round < k_most_smoothings; ++round) {
    double gained = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      if (movable[k] == 0) continue;
      const std::size_t prior = (k + count - 1) % count, next = (k + 1) % count;
      const glm::dvec3 &a = points[prior], &b = points[next], along = b - a;
      const double squared = glm::dot(along, along);
      if (squared <= 0.0) continue;
      const double share = std::clamp(glm::dot(points[k] - a, along) / squared, 0.1, 0.9);
      const double cost = line_cost(points[k] - a, d) + line_cost(b - points[k], d);
      for (const double step : {1.0, 0.5, 0.25}) {
        const Nearest found = nearest(near[k], glm::mix(points[k], a + share * along, step));
        const double becomes = line_cost(found.free - a, d) + line_cost(b - found.free, d);
        if (!std::isfinite(found.to_free) || becomes >= cost * (1.0 - 1e-6)) continue;
        if (!may_run(near[prior], near[k], a, found.free) || !may_run(near[k], near[next], found.free, b))
          continue;
        points[k] = found.free;
        gained += cost - becomes;
        break;
      }
    }
    if (gained <= 1e-4 * cost_of(points, d)) break;
  }
  return cost_of(points, d) < (1.0 - k_least_gain) * cost_of(before, d) ? points : before;
}

}  // namespace moldlight
