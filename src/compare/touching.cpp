#include "compare/touching.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

namespace {

/// Along the extent; a cell is never smaller than what polygons reach.
constexpr double k_cells = 128.0;
constexpr double k_places_a_polygon = 256.0, k_always_places = 4e6;
constexpr std::size_t k_steps_between = 64;  // two looks at whether to go on

struct InCell {
  std::uint64_t cell;
  std::uint32_t polygon;

  auto operator<=>(const InCell&) const = default;
};

bool overlap(const Bounds& a, const Bounds& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.min[axis] > b.max[axis] || b.min[axis] > a.max[axis]) return false;
  }
  return true;
}

/// 21 bits an axis; what lies farther out shares cells, which costs time alone.
std::uint64_t cell_number(const glm::i64vec3& cell) {
  constexpr std::uint64_t k_mask = (1ULL << 21) - 1;
  return (static_cast<std::uint64_t>(cell.x) & k_mask) << 42 |
         (static_cast<std::uint64_t>(cell.y) & k_mask) << 21 | (static_cast<std::uint64_t>(cell.z) & k_mask);
}

/// At least so large, and so that the boxes are in some tens of cells each: one polygon may be as long as the
/// part, or longer where the two parts are of very different size.
double cell_size(const std::vector<Bounds>& boxes, double least) {
  const double most = k_places_a_polygon * static_cast<double>(boxes.size()) + k_always_places;
  for (double size = std::max(least, 1e-300);; size *= 2.0) {
    double places = 0.0;
    for (const Bounds& box : boxes) {
      if (box.min.x > box.max.x) continue;
      const glm::dvec3 cells = (box.max - box.min) / size + 1.0;
      places += cells.x * cells.y * cells.z;
    }
    if (!(places > most)) return size;
  }
}

}  // namespace

void visit_touching(const std::vector<ReachingPolygon>& polygons, double extent,
                    const std::function<double(std::uint32_t, std::uint32_t)>& reach,
                    const std::function<void(std::uint32_t, std::uint32_t)>& touch,
                    const Progress& progress) {
  double greatest = 0.0;
  for (const ReachingPolygon& one : polygons) greatest = std::max(greatest, one.reach);
  std::vector<Bounds> boxes(polygons.size());
  for (std::uint32_t k = 0; k < polygons.size(); ++k) {
    if (polygons[k].polygon->empty()) continue;
    for (const glm::dvec3& corner : *polygons[k].polygon) boxes[k].add(corner);
    boxes[k].min -= polygons[k].reach;
    boxes[k].max += polygons[k].reach;
  }
  const double size = cell_size(boxes, std::max(extent / k_cells, 4.0 * greatest));
  std::vector<InCell> places;
  const auto cell_at = [size](double at) { return static_cast<std::int64_t>(std::floor(at / size)); };
  for (std::uint32_t k = 0; k < polygons.size(); ++k) {
    if (polygons[k].polygon->empty()) continue;
    const glm::dvec3 &low = boxes[k].min, &high = boxes[k].max;
    for (std::int64_t x = cell_at(low.x); x <= cell_at(high.x); ++x)
      for (std::int64_t y = cell_at(low.y); y <= cell_at(high.y); ++y)
        for (std::int64_t z = cell_at(low.z); z <= cell_at(high.z); ++z)
          places.push_back({cell_number({x, y, z}), k});
  }
  std::ranges::sort(places);
  for (std::size_t first = 0, last = 0; first < places.size(); first = last) {
    while (last < places.size() && places[last].cell == places[first].cell) ++last;
    const std::span here(places.data() + first, last - first);
    std::ranges::stable_sort(here, {}, [&](const InCell& one) { return boxes[one.polygon].min.x; });
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (i % k_steps_between == 0)
        progress.report("finding what changed",
                        static_cast<double>(first) / static_cast<double>(places.size()));
      for (std::size_t k = i + 1; k < here.size(); ++k) {
        const std::uint32_t a = here[i].polygon, b = here[k].polygon;
        if (boxes[b].min.x > boxes[a].max.x) break;
        if (!overlap(boxes[a], boxes[b])) continue;
        const double within = reach(a, b);
        if (within >= 0.0 && rims_touch(*polygons[a].polygon, *polygons[b].polygon, within)) touch(a, b);
      }
    }
  }
}

UnionFind joined_where_touching(const std::vector<ReachingPolygon>& polygons, double extent,
                                const Progress& progress) {
  UnionFind joined(polygons.size());
  visit_touching(
      polygons, extent,
      [&](std::uint32_t a, std::uint32_t b) {
        return joined.find(a) == joined.find(b) ? -1.0 : polygons[a].reach + polygons[b].reach;
      },
      [&](std::uint32_t a, std::uint32_t b) { joined.join(a, b); }, progress);
  return joined;
}

}  // namespace moldlight
