#include "mold/exact/projection_grid.hpp"

namespace moldlight {

namespace {

constexpr double k_most_along = 4096.0;  // cells along a side
constexpr double k_least_extent = 1e-12;
constexpr double k_most_per_item = 4.0;  // cells of a grid in a cell

}  // namespace

void ProjectionGrid::reset(const Box& box, double cells) {
  const glm::dvec2 size = glm::max(box.high - box.low, glm::dvec2(k_least_extent));
  const double side = std::sqrt(size.x * size.y / cells);
  const auto along = [&](double length) { return std::floor(std::clamp(length / side, 1.0, k_most_along)); };
  columns_ = static_cast<std::size_t>(along(size.x));
  rows_ = static_cast<std::size_t>(along(size.y));
  box_ = box;
  per_cell_ = {static_cast<double>(columns_) / size.x, static_cast<double>(rows_) / size.y};
}

void ProjectionGrid::shape(const Box& box, std::size_t count, const glm::dvec2& extent) {
  const glm::dvec2 size = glm::max(box.high - box.low, glm::dvec2(k_least_extent));
  const double most = k_most_per_item * static_cast<double>(count);
  const auto wanted = [&](double length, double of_item) {
    return std::clamp(length / std::max(of_item, k_least_extent), 1.0, most);
  };
  glm::dvec2 cells(wanted(size.x, extent.x), wanted(size.y, extent.y));
  // Too many: the ones along which items are longer stay, as long as there are any.
  if (cells.x * cells.y > most) {
    (cells.x > cells.y ? cells.x : cells.y) = std::max(most / std::min(cells.x, cells.y), 1.0);
  }
  if (cells.x * cells.y > most) cells = glm::dvec2(std::sqrt(most));
  columns_ = static_cast<std::size_t>(cells.x);
  rows_ = static_cast<std::size_t>(cells.y);
  box_ = box;
  per_cell_ = {static_cast<double>(columns_) / size.x, static_cast<double>(rows_) / size.y};
}

std::size_t ProjectionGrid::count_items(std::span<const glm::dvec2> corners) const {
  std::size_t sum = 0;
  for_each_span(corners, [&](std::size_t first, std::size_t last) {
    sum += items_between(first, last).size();
    if (nested_of_cell_.empty()) return;
    for (std::size_t cell = first; cell <= last; ++cell) {
      if (nested_of_cell_[cell] == k_none) continue;
      sum += nested_[nested_of_cell_[cell]].count_items(corners);
      sum -= items_between(cell, cell).size();
    }
  });
  return sum;
}

std::span<const std::uint32_t> ProjectionGrid::items_at(const glm::dvec2& point) const {
  if (point.x < box_.low.x || point.y < box_.low.y || point.x > box_.high.x || point.y > box_.high.y)
    return {};
  // Whoever is in a cell is in the grid of the cell, whatever rounding says of its border.
  const ProjectionGrid* grid = this;
  std::size_t cell = cell_at(point);
  while (!grid->nested_of_cell_.empty() && grid->nested_of_cell_[cell] != k_none) {
    grid = &grid->nested_[grid->nested_of_cell_[cell]];
    cell = grid->cell_at(point);
  }
  return grid->items_between(cell, cell);
}

}  // namespace moldlight
