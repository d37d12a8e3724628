#include "support/exact_crossing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace moldlight::test {

namespace {

__extension__ using Wide = __int128;
using Place = std::array<std::int64_t, 3>;

/// Sign of the volume of (a, b, c, d), exact for coordinates below 2^39.
int side(const Place& a, const Place& b, const Place& c, const Place& d) {
  const auto away = [&](const Place& p, std::size_t k) { return static_cast<Wide>(p[k] - a[k]); };
  const Wide volume = away(b, 0) * (away(c, 1) * away(d, 2) - away(c, 2) * away(d, 1)) -
                      away(b, 1) * (away(c, 0) * away(d, 2) - away(c, 2) * away(d, 0)) +
                      away(b, 2) * (away(c, 0) * away(d, 1) - away(c, 1) * away(d, 0));
  return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

struct Box {
  Place low, high;
};

/// Whether an edge of `a` runs through the inside of `b`.
bool pierces(const std::array<Place, 3>& a, const std::array<Place, 3>& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Place &p = a[k], &q = a[(k + 1) % 3];
    const int from = side(b[0], b[1], b[2], p), to = side(b[0], b[1], b[2], q);
    if (from * to >= 0) continue;
    const int first = side(p, q, b[0], b[1]);
    if (first != 0 && first == side(p, q, b[1], b[2]) && first == side(p, q, b[2], b[0])) return true;
  }
  return false;
}

}  // namespace

std::size_t exactly_crossing_pairs(const TriangleMesh& mesh) {
  double most = 0.0;
  for (const glm::dvec3& v : mesh.vertices)
    most = std::max({most, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (most <= 0.0) return 0;
  int exponent = 0;
  std::frexp(most, &exponent);
  std::vector<std::array<Place, 3>> facets(mesh.facets.size());
  std::vector<Box> boxes(mesh.facets.size());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3& v = mesh.vertices[mesh.facets[facet][k]];
      for (int axis = 0; axis < 3; ++axis)
        facets[facet][k][static_cast<std::size_t>(axis)] = std::llround(std::ldexp(v[axis], 38 - exponent));
    }
    boxes[facet] = {facets[facet][0], facets[facet][0]};
    for (const Place& p : facets[facet]) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        boxes[facet].low[axis] = std::min(boxes[facet].low[axis], p[axis]);
        boxes[facet].high[axis] = std::max(boxes[facet].high[axis], p[axis]);
      }
    }
  }
  // Facets by cells over two axes; a pair is looked at in the first cell that both are in.
  constexpr std::int64_t k_cells = 256, k_cell = (std::int64_t{1} << 39) / k_cells;
  const auto cell = [](std::int64_t at) {
    return std::clamp<std::int64_t>((at + (std::int64_t{1} << 38)) / k_cell, 0, k_cells - 1);
  };
  std::vector<std::vector<FacetIndex>> cells(k_cells * k_cells);
  for (FacetIndex facet = 0; facet < facets.size(); ++facet) {
    for (std::int64_t x = cell(boxes[facet].low[0]); x <= cell(boxes[facet].high[0]); ++x) {
      for (std::int64_t y = cell(boxes[facet].low[1]); y <= cell(boxes[facet].high[1]); ++y)
        cells[static_cast<std::size_t>(x * k_cells + y)].push_back(facet);
    }
  }
  std::size_t pairs = 0;
  for (std::size_t place = 0; place < cells.size(); ++place) {
    for (std::size_t i = 0; i < cells[place].size(); ++i) {
      for (std::size_t j = i + 1; j < cells[place].size(); ++j) {
        const FacetIndex f = cells[place][i], g = cells[place][j];
        bool apart = false;
        for (std::size_t axis = 0; axis < 3; ++axis)
          apart =
              apart || boxes[f].high[axis] < boxes[g].low[axis] || boxes[g].high[axis] < boxes[f].low[axis];
        if (apart) continue;
        const std::int64_t x = cell(std::max(boxes[f].low[0], boxes[g].low[0])),
                           y = cell(std::max(boxes[f].low[1], boxes[g].low[1]));
        if (static_cast<std::size_t>(x * k_cells + y) != place) continue;
        if (pierces(facets[f], facets[g]) || pierces(facets[g], facets[f])) ++pairs;
      }
    }
  }
  return pairs;
}

}  // namespace moldlight::test
