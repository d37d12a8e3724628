#include "mesh/polygon_lift.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

constexpr double k_rounding =
    1e-9;  // of the greatest triangle, and of the box that an edge's four corners span
constexpr std::size_t k_most_turns = 64;  // of edges, for each triangle

using Ends = std::pair<std::uint32_t, std::uint32_t>;
using ThreeCorners = std::array<std::uint32_t, 3>;

/// The triangles, each found by the edges that go round it.
class Lifted {
 public:
  Lifted(std::span<const glm::dvec3> corners, const glm::dvec3& up, std::vector<ThreeCorners>& triangles)
      : corners_(corners), up_(up), triangles_(triangles) {
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      add_edges(k);
      least_ = std::max(least_, k_rounding * seen_area(triangles[k][0], triangles[k][1], triangles[k][2]));
    }
  }

  void lift() {
    const auto is_folded = [&](const ThreeCorners& t) { return seen_area(t[0], t[1], t[2]) < -least_; };
    if (std::ranges::any_of(triangles_, is_folded)) return;
    std::vector<Ends> open;
    for (const auto& [edge, triangle] : of_edge_) open.push_back(edge);
    for (std::size_t left = k_most_turns * triangles_.size(); left > 0 && !open.empty(); --left) {
      const Ends edge = open.back();
      open.pop_back();
      if (turn(edge)) {
        const auto& [a, b] = turned_;
        for (const std::uint32_t end : {edge.first, edge.second})
          for (const std::uint32_t tip : {a, b}) open.insert(open.end(), {{end, tip}, {tip, end}});
      }
    }
  }

 private:
  [[nodiscard]] glm::dvec3 across(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return glm::cross(corners_[b] - corners_[a], corners_[c] - corners_[a]);
  }
  [[nodiscard]] double seen_area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return glm::dot(across(a, b, c), up_);
  }
  void add_edges(std::size_t triangle) {
    const auto& [a, b, c] = triangles_[triangle];
    of_edge_[{a, b}] = of_edge_[{b, c}] = of_edge_[{c, a}] = triangle;
  }
  [[nodiscard]] std::uint32_t tip_beyond(const Ends& edge, std::size_t triangle) const {
    return *std::ranges::find_if(triangles_[triangle], [&](std::uint32_t corner) {
      return corner != edge.first && corner != edge.second;
    });
  }

  /// Joins the tips on both sides of an edge instead, where that is higher and folds nothing.
  bool turn(const Ends& edge) {
    const auto& [a, b] = edge;
    const auto one = of_edge_.find(edge), other = of_edge_.find({b, a});
    if (one == of_edge_.end() || other == of_edge_.end()) return false;
    const std::size_t first = one->second, second = other->second;
    const std::uint32_t c = tip_beyond(edge, first), d = tip_beyond(edge, second);
    if (seen_area(a, d, c) <= least_ || seen_area(d, b, c) <= least_) return false;
    const glm::dvec3 plane = across(a, b, c);
    const double above = glm::dot(plane, corners_[d] - corners_[a]);
    if (above <= k_rounding * glm::length(plane) * glm::distance(corners_[c], corners_[d])) return false;
    of_edge_.erase(one);
    of_edge_.erase({b, a});
    triangles_[first] = {a, d, c};
    triangles_[second] = {d, b, c};
    add_edges(first);
    add_edges(second);
    turned_ = {c, d};
    return true;
  }

  std::span<const glm::dvec3> corners_;
  glm::dvec3 up_;
  std::vector<ThreeCorners>& triangles_;
  std::map<Ends, std::size_t> of_edge_;
  double least_ = 0.0;
  Ends turned_;  // the last edge that was made
};

}  // namespace

void lift_triangles(std::span<const glm::dvec3> corners, const glm::dvec3& up,
                    std::vector<std::array<std::uint32_t, 3>>& triangles) {
  Lifted(corners, up, triangles).lift();
}

}  // namespace moldlight
