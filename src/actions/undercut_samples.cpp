// Points on undercuts, by which pulls are tried.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "actions/undercut.hpp"
#include "classify/map_comparison.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

namespace {

/// From that across from the longest edge to that across from the shortest.
std::array<glm::dvec3, 3> by_edges(const std::array<glm::dvec3, 3>& given) {
  std::array<std::pair<double, glm::dvec3>, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = {glm::distance(given[(k + 1) % 3], given[(k + 2) % 3]), given[k]};
  std::ranges::stable_sort(corners, std::greater(), [](const auto& each) { return each.first; });
  return {corners[0].second, corners[1].second, corners[2].second};
}

std::array<glm::dvec3, 3> corners_of(const SplitMesh& split, std::uint32_t piece) {
  return {split.corner(piece, 0), split.corner(piece, 1), split.corner(piece, 2)};
}

/// Spreads places over what of one facet is undercut: the same ones however that is cut into pieces,
/// whichever way round it is seen.
class FacetPlaces {
 public:
  /// Its pieces, not empty, and a number by which facets of one shape have other places.
  FacetPlaces(const TriangleMesh& mesh, const SplitMesh& split, std::span<const std::uint32_t> pieces,
              std::uint64_t number)
      : split_(split), pieces_(pieces), number_(number) {
    const FacetIndex facet = split.pieces[pieces.front()].facet;
    const auto [tip, far, near] =
        by_edges({mesh.corner(facet, 0), mesh.corner(facet, 1), mesh.corner(facet, 2)});
    // Along its longest edge, and from there to the corner across.
    along_ = direction(far - near);
    across_ = direction((tip - near) - glm::dot(tip - near, along_) * along_);
    origin_ = near;
    for (const std::uint32_t piece : pieces) {
      for (const glm::dvec3& corner : corners_of(split, piece)) {
        low_ = glm::min(low_, flat(corner));
        high_ = glm::max(high_, flat(corner));
      }
    }
  }

  /// One after another; in a piece where the facet is too thin for that.
  [[nodiscard]] glm::dvec3 next() {
    constexpr std::uint64_t k_most_places = 256;
    for (std::uint64_t tries = 0; tries < k_most_places; ++tries) {
      const glm::dvec2 at = glm::mix(low_, high_, square_place(++number_));
      if (std::ranges::any_of(pieces_, [&](std::uint32_t piece) { return is_in(piece, at); }))
        return origin_ + at.x * along_ + at.y * across_;
    }
    const auto largest = std::ranges::max_element(
        pieces_, {}, [&](std::uint32_t piece) { return piece_area(split_, split_.pieces[piece]); });
    const auto [a, b, c] = by_edges(corners_of(split_, *largest));
    return triangle_place(number_).in(a, b, c);
  }

 private:
  [[nodiscard]] static glm::dvec3 direction(const glm::dvec3& way) {
    const double length = glm::length(way);
    return length > 0.0 ? way / length : glm::dvec3(0.0);
  }
  [[nodiscard]] glm::dvec2 flat(const glm::dvec3& point) const {
    return {glm::dot(point - origin_, along_), glm::dot(point - origin_, across_)};
  }
  [[nodiscard]] bool is_in(std::uint32_t piece, const glm::dvec2& at) const {
    std::array<double, 3> sides;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 from = flat(split_.corner(piece, k)), to = flat(split_.corner(piece, (k + 1) % 3));
      sides[k] = (to.x - from.x) * (at.y - from.y) - (to.y - from.y) * (at.x - from.x);
    }
    return std::ranges::min(sides) >= 0.0 || std::ranges::max(sides) <= 0.0;
  }

  const SplitMesh& split_;
  std::span<const std::uint32_t> pieces_;
  glm::dvec3 along_, across_, origin_;
  glm::dvec2 low_{std::numeric_limits<double>::infinity()}, high_{-std::numeric_limits<double>::infinity()};
  std::uint64_t number_;
};

}  // namespace

std::vector<UndercutSample> sample_undercut(const PartModel& model, const SplitMesh& split,
                                            const Undercut& undercut, std::size_t count) {
  std::vector<UndercutSample> samples;
  const double step = undercut.area / static_cast<double>(count);
  double sum = 0.0, next = 0.5 * step;
  for (std::size_t first = 0, end = 0; first < undercut.pieces.size(); first = end) {
    const FacetIndex facet = split.pieces[undercut.pieces[first]].facet;
    for (; end < undercut.pieces.size() && split.pieces[undercut.pieces[end]].facet == facet; ++end)
      sum += piece_area(split, split.pieces[undercut.pieces[end]]);
    if (next >= sum || samples.size() >= count) continue;
    FacetPlaces places(model.part.mesh, split, std::span(undercut.pieces).subspan(first, end - first),
                       samples.size());
    for (; next < sum && samples.size() < count; next += step)
      samples.push_back({model.frame.to_unit(places.next()), model.geometry.normals[facet], step});
  }
  // By the fractional parts of multiples of the golden ratio, which fill every interval evenly.
  std::vector<UndercutSample> spread;
  std::vector<std::size_t> order(samples.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto place = [](std::size_t k) {
    return std::fmod(0.6180339887498949 * static_cast<double>(k), 1.0);
  };
  std::ranges::stable_sort(order, {}, place);
  std::vector<std::size_t> rank(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) rank[order[k]] = k;
  for (const std::size_t k : rank) spread.push_back(samples[k]);
  return spread;
}

std::vector<UndercutSample> deepest_corners(const PartModel& model, const SplitMesh& split,
                                            const Undercut& undercut, const glm::dvec3& direction,
                                            std::size_t count) {
  struct Corner {
    long long height;  // heights that rounding alone distinguishes are in the order of the pieces
    std::uint32_t piece;
    std::size_t k;
  };
  const double rounding = 1e-6 * model.frame.diagonal;
  std::vector<Corner> corners;
  for (const std::uint32_t piece : undercut.pieces) {
    if (piece_area(split, split.pieces[piece]) <= 0.0) continue;
    for (std::size_t k = 0; k < 3; ++k)
      corners.push_back({std::llround(glm::dot(split.corner(piece, k), direction) / rounding), piece, k});
  }
  count = std::min(count, corners.size());
  std::ranges::stable_sort(corners, {}, &Corner::height);
  constexpr double k_inward = 1e-4;
  std::vector<UndercutSample> samples;
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [height, piece, which] = corners[k];
    const glm::dvec3 at = glm::mix(split.corner(piece, which), split.middle(piece), k_inward);
    samples.push_back({model.frame.to_unit(at), model.geometry.normals[split.pieces[piece].facet], 0.0});
  }
  return samples;
}

}  // namespace moldlight
