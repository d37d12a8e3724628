// One facet, cut into convex cells along segments. Cells share their edges: an edge that is cut for one of
// its two cells is cut for the other, so that neighbours name the same vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "mold/region.hpp"

namespace moldlight {

struct CutSegment {
  glm::dvec2 start, end;
};

/// How far a triangle is cut.
struct CutLimit {
  std::size_t most_cells = std::size_t{1} << 22U;  // past these, what is left is not cut
  bool sampled = false;    // the segments are a lattice, and no cell is of one region for certain
  std::uint32_t seed = 0;  // of the points that stand for cells of which that is not certain
};

/// Keeps its room from facet to facet. Lengths are those of the unit frame, in the facet's plane.
class FacetCells {
 public:
  /// Cuts the triangle along the segments, which it uses up; a cut runs through its whole cell. `label` says
  /// the region of the cell around a point. With `keep_cells`,
  /// cells are kept, those of one region that a cut made joined again; else only areas are summed.
  template <typename Label>
  void cut(const std::array<glm::dvec2, 3>& corners, std::vector<CutSegment>& segments, const CutLimit& limit,
           bool keep_cells, const Label& label);

  /// In place of cut() for a triangle that nothing cuts.
  void keep_whole(Region region, double area);

  /// Of the regions, after cut().
  [[nodiscard]] const std::array<double, k_region_count>& areas() const { return areas_; }
  /// Of the cells that were not cut although segments run through them, the squares of the areas summed up:
  /// one point stands for each.
  [[nodiscard]] double squared_doubt() const { return squared_doubt_; }

  // The cells kept, after cut(): polygons over points; 0, 1, 2 are the triangle's corners. Only points that
  // some cell has for a corner are named.
  struct Cell {
    Region region = Region::both;
    std::uint32_t begin = 0, end = 0;  // of outlines()
  };
  [[nodiscard]] std::span<const Cell> cells() const { return cells_; }
  [[nodiscard]] std::span<const std::uint32_t> outlines() const { return outlines_; }
  [[nodiscard]] const glm::dvec2& point(std::uint32_t number) const { return points_[number]; }
  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  /// Side k of the triangle (from corner k to corner k + 1) that a point lies on; 3: none of them.
  [[nodiscard]] std::uint32_t side_of(std::uint32_t number) const { return point_sides_[number]; }

 private:
  static constexpr std::uint32_t k_none = ~0U;
  /// An edge between two points. Once cut it has two children, which meet in the point between.
  struct Edge {
    std::uint32_t from, to;
    std::uint32_t first_child = k_none;  // the second one is the next
    std::uint32_t line;                  // what it lies on: a side of the triangle (0, 1, 2) or a cut
  };
  /// An edge as a cell runs through it.
  struct Use {
    std::uint32_t edge;
    bool reversed;
  };
  struct Kept {
    Region region;
    std::uint32_t begin, end;  // of kept_uses_
  };
  /// Region of a whole cell, or that it is of several.
  static constexpr int k_mixed = -1;

  template <typename Label>
  int process(std::vector<Use>& outline, std::vector<CutSegment>& segments, std::size_t most_cells,
              const Label& label);
  template <typename Label>
  int finish(const std::vector<Use>& outline, bool certain, const Label& label);
  /// Any point of it is as likely.
  [[nodiscard]] glm::dvec2 random_point(const std::vector<Use>& outline);
  void begin(const std::array<glm::dvec2, 3>& corners);
  [[nodiscard]] std::uint32_t start_of(const Use& use) const {
    return use.reversed ? edges_[use.edge].to : edges_[use.edge].from;
  }
  void append_leaves(const Use& use, std::vector<Use>& out) const;
  /// The line to cut along next; an empty one if none of the segments is worth it.
  struct Line {
    glm::dvec2 origin{0.0}, normal{0.0};
  };
  [[nodiscard]] Line choose_line(const std::vector<Use>& outline, const std::vector<CutSegment>& segments,
                                 bool halve) const;
  /// Cuts the outline in two; false if the line leaves it in one.
  bool split(const std::vector<Use>& outline, const Line& line, std::vector<Use>& left,
             std::vector<Use>& right);
  static void distribute(const std::vector<CutSegment>& segments, const Line& line,
                         std::vector<CutSegment>& left, std::vector<CutSegment>& right);
  std::uint32_t cut_edge(const Use& use, const glm::dvec2& at);
  struct Shape {
    double area = 0.0;
    glm::dvec2 centroid{0.0};
  };
  [[nodiscard]] Shape shape_of(const std::vector<Use>& outline) const;
  void keep(const std::vector<Use>& outline, Region region);
  void make_outlines();

  std::vector<glm::dvec2> points_;
  std::vector<std::uint32_t> point_sides_;
  std::vector<Edge> edges_;
  std::array<double, k_region_count> areas_{};
  bool keep_cells_ = false;
  double squared_doubt_ = 0.0;
  bool sampled_ = false;
  std::uint64_t random_ = 0;
  std::uint32_t next_line_ = 3;
  std::vector<Kept> kept_;
  std::vector<Use> kept_uses_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> outlines_;
  std::vector<std::uint8_t> is_corner_;
  std::vector<double> heights_;  // of an outline's points over the line that cuts it
};

template <typename Label>
void FacetCells::cut(const std::array<glm::dvec2, 3>& corners, std::vector<CutSegment>& segments,
                     const CutLimit& limit, bool keep_cells, const Label& label) {
  keep_cells_ = keep_cells;
  sampled_ = limit.sampled;
  random_ = limit.seed;
  begin(corners);
  std::vector<Use> outline = {{0, false}, {1, false}, {2, false}};
  process(outline, segments, limit.most_cells, label);
  if (keep_cells_) make_outlines();
}

template <typename Label>
int FacetCells::process(std::vector<Use>& outline, std::vector<CutSegment>& segments, std::size_t most_cells,
                        const Label& label) {
  bool halve = true;
  while (!segments.empty()) {
    if (most_cells <= 1) return finish(outline, false, label);
    const Line line = choose_line(outline, segments, halve);
    if (line.normal == glm::dvec2(0.0)) break;
    std::vector<CutSegment> left_segments, right_segments;
    distribute(segments, line, left_segments, right_segments);
    std::vector<Use> left, right;
    if (!split(outline, line, left, right)) {
      // The cell lies on one side: what is left of the segments lies there too.
      left_segments.insert(left_segments.end(), right_segments.begin(), right_segments.end());
      segments = std::move(left_segments);
      halve = false;
      continue;
    }
    // Each side may have cells as it has segments.
    const std::size_t left_share = left_segments.size() + 1, shares = left_share + right_segments.size() + 1;
    const std::size_t left_most =
        std::clamp<std::size_t>(most_cells * left_share / shares, 1, most_cells - 1);
    segments = {};
    const std::size_t kept_before = kept_.size(), uses_before = kept_uses_.size();
    const int left_region = process(left, left_segments, left_most, label);
    const int right_region = process(right, right_segments, most_cells - left_most, label);
    if (left_region != right_region || left_region == k_mixed) return k_mixed;
    if (keep_cells_) {
      kept_.resize(kept_before);
      kept_uses_.resize(uses_before);
      keep(outline, static_cast<Region>(left_region));
    }
    return left_region;
  }
  return finish(outline, !sampled_, label);
}

template <typename Label>
int FacetCells::finish(const std::vector<Use>& outline, bool certain, const Label& label) {
  const Shape shape = shape_of(outline);
  const Region region = label(certain ? shape.centroid : random_point(outline));
  if (!certain) squared_doubt_ += shape.area * shape.area;
  areas_[static_cast<std::size_t>(region)] += shape.area;
  if (keep_cells_) keep(outline, region);
  return static_cast<int>(region);
}

}  // namespace moldlight
