#include "mold/exact/split_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include "base/check.hpp"

namespace moldlight {

namespace {

/// Cut points of two facets on their common edge that are nearer than this, in the unit frame, are one: an
/// edge that is shorter has one at most.
constexpr double k_same_point = 1e-11;
/// A corner that bends by less than this many radians is a point of a straight side.
constexpr double k_straight_rad = 1e-7;
constexpr std::size_t k_split_grain = 1024;  // facets a task

/// Slivers of two cells that points which became one have folded onto each other: the same corners, wound in
/// opposite ways.
void leave_out_folds(std::vector<SplitPiece>& pieces, std::size_t first) {
  std::vector<std::array<VertexIndex, 3>> corners;
  for (std::size_t k = first; k < pieces.size(); ++k) {
    corners.push_back(pieces[k].corners);
    std::ranges::sort(corners.back());
  }
  std::vector<std::array<VertexIndex, 3>> sorted = corners;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) == sorted.end()) return;
  std::size_t kept = first;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto [begin, end] = std::equal_range(sorted.begin(), sorted.end(), corners[k]);
    if (end - begin == 1) pieces[kept++] = pieces[first + k];
  }
  pieces.resize(kept);
}

}  // namespace

SplitAssembly::SplitAssembly(const ExactPart& part)
    : part_(part),
      regions_(part.mesh().facets.size(), Region::both),
      split_of_facet_(part.mesh().facets.size(), k_none) {}

void SplitAssembly::add(FacetIndex facet, const FacetCells& cells) {
  CHECK(facet < regions_.size() && !cells.cells().empty());
  if (cells.cells().size() == 1) {
    regions_[facet] = cells.cells().front().region;
    return;
  }
  SplitFacet split{.facet = facet,
                   .points = std::vector<Point>(3),
                   .cells = {cells.cells().begin(), cells.cells().end()},
                   .outlines = {}};
  std::vector<std::uint32_t> renumbered(cells.point_count(), k_none);
  for (std::uint32_t k = 0; k < 3; ++k) renumbered[k] = k;
  std::uint32_t points = 3;
  for (const std::uint32_t number : cells.outlines()) {
    if (renumbered[number] == k_none) renumbered[number] = points++;
  }
  split.points.reserve(points);
  split.outlines.reserve(cells.outlines().size());
  const glm::dvec2 origin = cells.point(0), to_1 = cells.point(1) - origin, to_2 = cells.point(2) - origin;
  const double twice_area = to_1.x * to_2.y - to_1.y * to_2.x;
  for (const std::uint32_t number : cells.outlines()) {
    if (renumbered[number] == split.points.size()) {
      Point point;
      const std::uint32_t from = cells.side_of(number), to = (from + 1) % 3;
      point.side = from & 3U;
      const glm::dvec2 at = cells.point(number) - origin;
      if (from == k_inside) {
        point.at = {(at.x * to_2.y - at.y * to_2.x) / twice_area,
                    (to_1.x * at.y - to_1.y * at.x) / twice_area};
      } else {
        const glm::dvec2 side = cells.point(to) - cells.point(from);
        const double share = glm::dot(cells.point(number) - cells.point(from), side) / glm::dot(side, side);
        CHECK(std::isfinite(share));
        const auto& corners = part_.mesh().facets[facet];
        point.at[0] = corners[from] < corners[to] ? share : 1.0 - share;
      }
      split.points.push_back(point);
    }
    split.outlines.push_back(renumbered[number]);
  }
  added_.local().push_back(std::move(split));
}

SplitMesh SplitAssembly::finish(const Progress& progress) {
  progress.report("joining the split mesh", 0.0);
  for (std::vector<SplitFacet>& some : added_) {
    std::move(some.begin(), some.end(), std::back_inserter(split_));
    some.clear();
  }
  tbb::parallel_sort(split_.begin(), split_.end(),
                     [](const SplitFacet& a, const SplitFacet& b) { return a.facet < b.facet; });
  for (std::uint32_t k = 0; k < split_.size(); ++k) split_of_facet_[split_[k].facet] = k;
  mesh_.vertices = part_.mesh().vertices;
  join_side_points();
  number_inner_points();
  adopt_regions_without_area();
  progress.report("joining the split mesh", 0.5);
  const std::size_t facets = part_.mesh().facets.size();
  std::vector<std::vector<SplitPiece>> parts((facets + k_split_grain - 1) / k_split_grain);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) {
    std::vector<VertexIndex> polygon;
    parts[k].reserve(k_split_grain + k_split_grain / 2);
    for (std::size_t facet = k * k_split_grain; facet < std::min((k + 1) * k_split_grain, facets); ++facet) {
      append_pieces(static_cast<FacetIndex>(facet), parts[k], polygon);
    }
  });
  split_ = {};
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  mesh_.pieces.reserve(count);
  for (auto& part : parts) {
    mesh_.pieces.insert(mesh_.pieces.end(), part.begin(), part.end());
    part = {};
  }
  leave_out_unused_vertices();
  return std::move(mesh_);
}

/// Those that only folds had; the part's own stay.
void SplitAssembly::leave_out_unused_vertices() {
  const std::size_t own = part_.mesh().vertices.size();
  std::vector<VertexIndex> number(mesh_.vertices.size(), 0);
  std::fill_n(number.begin(), own, 1);
  for (const SplitPiece& piece : mesh_.pieces) {
    for (const VertexIndex corner : piece.corners) number[corner] = 1;
  }
  if (std::ranges::find(number, 0U) == number.end()) return;
  VertexIndex kept = 0;
  for (std::size_t k = 0; k < number.size(); ++k) {
    if (number[k] != 0) mesh_.vertices[kept] = mesh_.vertices[k];
    number[k] = std::exchange(kept, kept + number[k]);
  }
  mesh_.vertices.resize(kept);
  for (SplitPiece& piece : mesh_.pieces) {
    for (VertexIndex& corner : piece.corners) corner = number[corner];
  }
}

void SplitAssembly::join_side_points() {
  struct SidePoint {
    std::uint32_t edge;
    double along;
    std::uint32_t split, point;
  };
  std::vector<SidePoint> on_sides;
  for (std::uint32_t k = 0; k < split_.size(); ++k) {
    for (std::uint32_t p = 3; p < split_[k].points.size(); ++p) {
      const Point& point = split_[k].points[p];
      if (point.side != k_inside)
        on_sides.push_back({part_.side_edges()[split_[k].facet][point.side], point.at[0], k, p});
    }
  }
  tbb::parallel_sort(on_sides.begin(), on_sides.end(), [](const SidePoint& a, const SidePoint& b) {
    if (a.edge != b.edge) return a.edge < b.edge;
    if (a.along != b.along) return a.along < b.along;
    return a.split != b.split ? a.split < b.split : a.point < b.point;
  });
  first_on_edge_.assign(part_.edges().size() + 1, 0);
  for (std::size_t begin = 0, end = 0; begin < on_sides.size(); begin = end) {
    CHECK(on_sides[begin].edge < part_.edges().size());
    const ExactEdge& edge = part_.edges()[on_sides[begin].edge];
    const double tolerance =
        k_same_point / glm::distance(part_.positions()[edge.a], part_.positions()[edge.b]);
    std::uint32_t place = 0;
    double last = 0.0;
    for (; end < on_sides.size() && on_sides[end].edge == on_sides[begin].edge; ++end) {
      const SidePoint& at = on_sides[end];
      if (end == begin || at.along - last > tolerance) {
        last = at.along;
        ++place;
        edge_vertices_.push_back(static_cast<VertexIndex>(mesh_.vertices.size()));
        const glm::dvec3& a = part_.mesh().vertices[edge.a];
        mesh_.vertices.push_back(a + at.along * (part_.mesh().vertices[edge.b] - a));
      }
      Point& point = split_[at.split].points[at.point];
      point.vertex = edge_vertices_.back();
      point.place = (place - 1) & 0x3FFFFFFFU;
    }
    first_on_edge_[on_sides[begin].edge + 1] = place;
  }
  std::partial_sum(first_on_edge_.begin(), first_on_edge_.end(), first_on_edge_.begin());
}

void SplitAssembly::number_inner_points() {
  for (SplitFacet& split : split_) {
    const auto& corners = part_.mesh().facets[split.facet];
    for (std::size_t k = 0; k < split.points.size(); ++k) {
      Point& point = split.points[k];
      if (k < 3) {
        point.vertex = corners[k];
      } else if (point.side == k_inside) {
        point.vertex = static_cast<VertexIndex>(mesh_.vertices.size());
        mesh_.vertices.push_back((1.0 - point.at[0] - point.at[1]) * part_.mesh().vertices[corners[0]] +
                                 point.at[0] * part_.mesh().vertices[corners[1]] +
                                 point.at[1] * part_.mesh().vertices[corners[2]]);
      }
      CHECK(point.vertex < mesh_.vertices.size());
    }
  }
}

/// A facet without area, such as closes a seam between edges of different lengths, is of the region across
/// its longest side, so that it makes no border of its own.
void SplitAssembly::adopt_regions_without_area() {
  for (FacetIndex facet = 0; facet < regions_.size(); ++facet) {
    if (part_.geometry().areas[facet] > 0.0) continue;
    double longest = 0.0;
    for (const std::uint32_t number : part_.side_edges()[facet]) {
      if (number == ExactPart::k_no_edge) continue;
      const ExactEdge& edge = part_.edges()[number];
      const FacetIndex other = edge.left == facet ? edge.right : edge.left;
      const double length = glm::distance(part_.positions()[edge.a], part_.positions()[edge.b]);
      if (other == k_no_facet || part_.geometry().areas[other] <= 0.0 || length <= longest) continue;
      longest = length;
      const std::uint32_t split = split_of_facet_[other];
      regions_[facet] = split == k_none ? regions_[other] : split_[split].cells.front().region;
    }
  }
}

std::size_t SplitAssembly::vertices_on(std::uint32_t edge) const {
  return edge == ExactPart::k_no_edge ? 0 : first_on_edge_[edge + 1] - first_on_edge_[edge];
}

void SplitAssembly::append_outline(FacetIndex facet, std::span<const std::uint32_t> outline,
                                   const SplitFacet* split, std::vector<VertexIndex>& polygon) const {
  const auto& corners = part_.mesh().facets[facet];
  const auto vertex_of = [&](std::uint32_t k) { return k < 3 ? corners[k] : split->points[k].vertex; };
  const auto on_side = [&](std::uint32_t k, std::uint32_t side) {
    return k < 3 ? k == side || k == (side + 1) % 3 : split->points[k].side == side;
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::uint32_t from = outline[i], to = outline[(i + 1) % outline.size()];
    polygon.push_back(vertex_of(from));
    for (std::uint32_t side = 0; side < 3; ++side) {
      if (!on_side(from, side) || !on_side(to, side)) continue;
      const std::uint32_t edge = part_.side_edges()[facet][side];
      const auto count = static_cast<std::ptrdiff_t>(vertices_on(edge));
      if (count == 0) continue;
      const bool rises = corners[side] < corners[(side + 1) % 3];
      const auto place_of = [&](std::uint32_t k) -> std::ptrdiff_t {
        if (k >= 3) {
          CHECK(split->points[k].place < vertices_on(edge));
          return split->points[k].place;
        }
        return (k == side) == rises ? -1 : count;
      };
      const VertexIndex* on_edge = edge_vertices_.data() + first_on_edge_[edge];
      std::ptrdiff_t place = place_of(from);
      const std::ptrdiff_t last = place_of(to);
      if (place < last) {
        while (++place < last) polygon.push_back(on_edge[place]);
      } else {
        while (--place > last) polygon.push_back(on_edge[place]);
      }
    }
  }
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.back() == polygon.front()) polygon.pop_back();
}

void SplitAssembly::append_pieces(FacetIndex facet, std::vector<SplitPiece>& pieces,
                                  std::vector<VertexIndex>& polygon) const {
  const auto& sides = part_.side_edges()[facet];
  if (sides[0] == ExactPart::k_no_edge) return;  // two equal corners
  const std::uint32_t number = split_of_facet_[facet];
  if (number != k_none) {
    const SplitFacet& split = split_[number];
    const std::size_t first = pieces.size();
    for (const FacetCells::Cell& cell : split.cells) {
      polygon.clear();
      append_outline(facet, std::span(split.outlines).subspan(cell.begin, cell.end - cell.begin), &split,
                     polygon);
      triangulate(polygon, {.corners = {}, .facet = facet, .region = cell.region}, pieces);
    }
    leave_out_folds(pieces, first);
    return;
  }
  const SplitPiece whole{.corners = part_.mesh().facets[facet], .facet = facet, .region = regions_[facet]};
  if (vertices_on(sides[0]) + vertices_on(sides[1]) + vertices_on(sides[2]) == 0) {
    pieces.push_back(whole);
    return;
  }
  constexpr std::array<std::uint32_t, 3> k_corners = {0, 1, 2};
  polygon.clear();
  append_outline(facet, k_corners, nullptr, polygon);
  triangulate(polygon, whole, pieces);
}

bool SplitAssembly::is_corner(const std::vector<VertexIndex>& polygon, std::size_t k) const {
  const std::size_t count = polygon.size();
  const glm::dvec3& at = mesh_.vertices[polygon[k]];
  const glm::dvec3 before = mesh_.vertices[polygon[(k + count - 1) % count]] - at;
  const glm::dvec3 after = mesh_.vertices[polygon[(k + 1) % count]] - at;
  return glm::length(glm::cross(before, after)) > k_straight_rad * glm::length(before) * glm::length(after);
}

/// Cuts off corners beside points of straight sides until none is left, then fans: no triangle without area.
void SplitAssembly::triangulate(std::vector<VertexIndex>& polygon, const SplitPiece& like,
                                std::vector<SplitPiece>& pieces) const {
  const auto emit = [&](VertexIndex a, VertexIndex b, VertexIndex c) {
    SplitPiece piece = like;
    piece.corners = {a, b, c};
    pieces.push_back(piece);
  };
  bool cut = polygon.size() > 3;
  while (cut && polygon.size() > 3) {
    cut = false;
    for (std::size_t k = 0; k < polygon.size() && polygon.size() > 3; ++k) {
      const std::size_t count = polygon.size(), before = (k + count - 1) % count, after = (k + 1) % count;
      if (!is_corner(polygon, k) || (is_corner(polygon, before) && is_corner(polygon, after))) continue;
      emit(polygon[before], polygon[k], polygon[after]);
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(k));
      cut = true;
      break;
    }
  }
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) emit(polygon[0], polygon[k], polygon[k + 1]);
}

}  // namespace moldlight
