// A uniform grid over the projection of a part, whose cells list the items that reach into them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace moldlight {

/// Cells are filled by scan conversion, not by bounding boxes, so that a long thin item is in few cells. A
/// cell with many items has a grid of its own: threads and lettering have far more facets to the area than
/// the rest.
class ProjectionGrid {
 public:
  struct Box {
    glm::dvec2 low{0.0}, high{1.0};
  };
  /// About `cells` cells over the box from `low` to `high`, nearly square, filled with these items;
  /// corners(number, out) writes the 2 or 3 corners of an item and returns how many.
  template <typename Corners>
  void fill(const Box& box, double cells, std::span<const std::uint32_t> items, const Corners& corners);

  /// Calls visit(item) for the items of every cell that the convex polygon (2 or 3 corners) reaches, a little
  /// generously; one may come several times.
  template <typename Visit>
  void for_each_item(std::span<const glm::dvec2> corners, const Visit& visit) const;

  /// How often for_each_item() would call.
  [[nodiscard]] std::size_t count_items(std::span<const glm::dvec2> corners) const;

  /// Items of the cell around a point; none outside the grid.
  [[nodiscard]] std::span<const std::uint32_t> items_at(const glm::dvec2& point) const;

 private:
  static constexpr std::uint32_t k_none = ~0U;
  static constexpr std::size_t k_many = 64;        // items of a cell that gets a grid of its own
  static constexpr std::size_t k_most_growth = 8;  // of the number of entries, by such a grid
  static constexpr std::size_t k_least_cells = 4;  // of such a grid
  static constexpr int k_most_levels = 4;          // of grids in grids
  /// Entries, beyond which cells are larger than asked for, and of the grids in cells, beyond which there are
  /// no more of these: loose facets as large as the part are in all cells.
  static constexpr std::size_t k_entries_an_item = 16, k_always_entries = 250'000;
  static constexpr std::size_t k_nested_an_item = 64, k_always_nested = 1'000'000;

  void reset(const Box& box, double cells);
  /// As many cells as suit so many items of such an extent: narrow ones for items that lie along one line.
  void shape(const Box& box, std::size_t count, const glm::dvec2& extent);
  template <typename Corners>
  [[nodiscard]] static glm::dvec2 mean_extent(std::span<const std::uint32_t> items, const Corners& corners) {
    glm::dvec2 sum(0.0), at[3];
    for (const std::uint32_t item : items) {
      const std::size_t used = corners(item, at);
      glm::dvec2 low = at[0], high = at[0];
      for (std::size_t k = 1; k < used; ++k) {
        low = glm::min(low, at[k]);
        high = glm::max(high, at[k]);
      }
      sum += high - low;
    }
    return sum / static_cast<double>(items.size());
  }
  /// False, and nothing is in the cells, where that would be more entries than `most`.
  template <typename Corners>
  [[nodiscard]] bool fill_cells(std::span<const std::uint32_t> items, const Corners& corners,
                                std::size_t most);
  /// Gives crowded cells grids of their own, of so many entries in all, of which it takes theirs.
  template <typename Corners>
  void fill_nested(const Corners& corners, int level, std::size_t& entries);
  /// Calls visit(first cell, last cell) for each row of cells that the polygon reaches.
  template <typename Visit>
  void for_each_span(std::span<const glm::dvec2> corners, const Visit& visit) const;
  [[nodiscard]] std::span<const std::uint32_t> items_between(std::size_t first, std::size_t last) const {
    return {items_.data() + first_[first], first_[last + 1] - first_[first]};
  }
  [[nodiscard]] std::size_t cell_at(const glm::dvec2& point) const {
    const glm::dvec2 at = (point - box_.low) * per_cell_;
    return row(at.y) * columns_ + column(at.x);
  }
  [[nodiscard]] std::size_t column(double x) const { return clamped(x, columns_); }
  [[nodiscard]] std::size_t row(double y) const { return clamped(y, rows_); }
  /// Cell number along an axis of a place in cells.
  [[nodiscard]] static std::size_t clamped(double place, std::size_t count) {
    return place <= 0.0 ? 0 : std::min(static_cast<std::size_t>(place), count - 1);
  }

  Box box_;
  glm::dvec2 per_cell_{1.0};  // cells per length
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> items_;
  std::vector<std::uint32_t> nested_of_cell_;  // empty if no cell has a grid of its own
  std::vector<ProjectionGrid> nested_;
};

template <typename Visit>
void ProjectionGrid::for_each_span(std::span<const glm::dvec2> corners, const Visit& visit) const {
  // In cells: far more than rounding takes from the crossings of sides that rise by k_level at least.
  constexpr double k_generous = 1e-3, k_level = 1e-5;
  struct Side {
    glm::dvec2 low, high;  // by y
    double slope;          // x per y
  };
  std::array<Side, 3> sides;
  glm::dvec2 least(1e300), most(-1e300);
  const auto in_cells = [&](std::size_t k) { return (corners[k] - box_.low) * per_cell_; };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    Side& side = sides[k];
    side.low = in_cells(k);
    least = glm::min(least, side.low);
    most = glm::max(most, side.low);
  }
  least -= k_generous;
  most += k_generous;
  if (most.x < 0.0 || most.y < 0.0 || least.x > static_cast<double>(columns_) ||
      least.y > static_cast<double>(rows_)) {
    return;
  }
  const std::size_t bottom = row(least.y), top = row(most.y);
  const std::size_t left_column = column(least.x), right_column = column(most.x);
  if (bottom == top || left_column == right_column ||
      (top - bottom == 1 && right_column - left_column == 1)) {
    for (std::size_t r = bottom; r <= top; ++r)
      visit(r * columns_ + left_column, r * columns_ + right_column);
    return;
  }
  const std::size_t count = corners.size() == 2 ? 1 : 3;
  const std::array<glm::dvec2, 3> at = {sides[0].low, sides[1].low, sides[2].low};
  for (std::size_t k = 0; k < count; ++k) {
    Side& side = sides[k];
    side.high = at[(k + 1) % corners.size()];
    if (side.high.y < side.low.y) std::swap(side.low, side.high);
    const double rise = side.high.y - side.low.y;
    side.slope = rise < k_level ? 0.0 : (side.high.x - side.low.x) / rise;
  }
  for (std::size_t r = bottom; r <= top; ++r) {
    const double slab_low = static_cast<double>(r) - k_generous;
    const double slab_high = static_cast<double>(r) + 1.0 + k_generous;
    double left = 1e300, right = -1e300;
    const auto add = [&](double x) {
      left = std::min(left, x);
      right = std::max(right, x);
    };
    for (std::size_t k = 0; k < count; ++k) {
      const Side& side = sides[k];
      if (side.high.y < slab_low || side.low.y > slab_high) continue;
      const bool level = side.slope == 0.0;
      add(level || side.low.y >= slab_low ? side.low.x : side.low.x + side.slope * (slab_low - side.low.y));
      add(level || side.high.y <= slab_high ? side.high.x
                                            : side.low.x + side.slope * (slab_high - side.low.y));
    }
    if (left > right || right + k_generous < 0.0 || left - k_generous > static_cast<double>(columns_))
      continue;
    visit(r * columns_ + column(left - k_generous), r * columns_ + column(right + k_generous));
  }
}

template <typename Visit>
void ProjectionGrid::for_each_item(std::span<const glm::dvec2> corners, const Visit& visit) const {
  for_each_span(corners, [&](std::size_t first, std::size_t last) {
    if (nested_of_cell_.empty()) {
      for (const std::uint32_t item : items_between(first, last)) visit(item);
      return;
    }
    for (std::size_t cell = first; cell <= last; ++cell) {
      if (nested_of_cell_[cell] != k_none) {
        nested_[nested_of_cell_[cell]].for_each_item(corners, visit);
        continue;
      }
      for (const std::uint32_t item : items_between(cell, cell)) visit(item);
    }
  });
}

template <typename Corners>
void ProjectionGrid::fill(const Box& box, double cells, std::span<const std::uint32_t> items,
                          const Corners& corners) {
  *this = {};  // what it was filled with before has no room beside what comes
  const glm::dvec2 extent = items.empty() ? glm::dvec2(0.0) : mean_extent(items, corners);
  const std::size_t most = k_entries_an_item * items.size() + k_always_entries;
  const auto are_too_many = [&] {
    const glm::dvec2 reach = 1.0 + extent * per_cell_;
    if (reach.x * reach.y < static_cast<double>(k_entries_an_item)) return false;  // far from too many
    std::size_t sum = 0;
    glm::dvec2 at[3];
    for (const std::uint32_t item : items) {
      const std::size_t used = corners(item, at);
      for_each_span({at, used}, [&](std::size_t first, std::size_t last) { sum += last + 1 - first; });
      if (sum > most) return true;
    }
    return false;
  };
  reset(box, cells = std::max(cells, 1.0));
  // Below one where the box is a line, of whose cells there are many all the same.
  while (columns_ * rows_ > 1 && are_too_many()) reset(box, cells *= 0.25);
  static_cast<void>(fill_cells(items, corners, ~std::size_t{0}));
  std::size_t nested = k_nested_an_item * items.size() + k_always_nested;
  fill_nested(corners, 1, nested);
}

template <typename Corners>
bool ProjectionGrid::fill_cells(std::span<const std::uint32_t> items, const Corners& corners,
                                std::size_t most) {
  const std::size_t cells = columns_ * rows_;
  struct Span {
    std::uint32_t first, last;
    std::uint32_t item;
  };
  std::vector<Span> spans;
  spans.reserve(2 * items.size());
  // Counted two places on, so that while items are put in, first_[cell + 1] is where the next one goes.
  first_.assign(cells + 2, 0);
  glm::dvec2 at[3];
  std::size_t sum = 0;
  for (const std::uint32_t item : items) {
    const std::size_t used = corners(item, at);
    for_each_span({at, used}, [&](std::size_t first, std::size_t last) {
      sum += last + 1 - first;
      spans.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), item});
      for (std::size_t cell = first; cell <= last; ++cell) ++first_[cell + 2];
    });
    if (sum > most) return false;
  }
  for (std::size_t cell = 2; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  items_.resize(first_.back());
  for (const Span& span : spans) {
    for (std::size_t cell = span.first; cell <= span.last; ++cell) items_[first_[cell + 1]++] = span.item;
  }
  first_.pop_back();
  return true;
}

template <typename Corners>
void ProjectionGrid::fill_nested(const Corners& corners, int level, std::size_t& entries) {
  nested_.clear();
  nested_of_cell_.clear();
  if (level == k_most_levels) return;
  const std::size_t cells = columns_ * rows_;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const auto in_cell = items_between(cell, cell);
    if (in_cell.size() <= k_many) continue;
    const glm::dvec2 corner(static_cast<double>(cell % columns_), static_cast<double>(cell / columns_));
    const glm::dvec2 low = box_.low + corner / per_cell_;
    ProjectionGrid nested;
    nested.shape({low, low + 1.0 / per_cell_}, in_cell.size(), mean_extent(in_cell, corners));
    // Items as large as the cell are no fewer in a part of it.
    if (nested.columns_ * nested.rows_ < k_least_cells) continue;
    if (!nested.fill_cells(in_cell, corners, std::min(k_most_growth * in_cell.size(), entries))) continue;
    entries -= nested.items_.size();
    nested.fill_nested(corners, level + 1, entries);
    if (nested_of_cell_.empty()) nested_of_cell_.assign(cells, k_none);
    nested_of_cell_[cell] = static_cast<std::uint32_t>(nested_.size());
    nested_.push_back(std::move(nested));
  }
}

}  // namespace moldlight
