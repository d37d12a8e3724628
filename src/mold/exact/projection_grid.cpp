#include "mold/exact/projection_grid.hpp"

namespace moldlight {

namespace {

constexpr double k_most_along = 4096.0;  // cells along a side

}  // namespace

void ProjectionGrid::reset(const glm::dvec2& low, const glm::dvec2& high, double cells) {
  const glm::dvec2 size = {std::max(high.x - low.x, 1e-9), std::max(high.y - low.y, 1e-9)};
  const double side = std::sqrt(size.x * size.y / std::max(cells, 1.0));
  const auto along = [&](double length) { return std::floor(std::clamp(length / side, 1.0, k_most_along)); };
  columns_ = static_cast<std::size_t>(along(size.x));
  rows_ = static_cast<std::size_t>(along(size.y));
  low_ = low;
  per_cell_ = {static_cast<double>(columns_) / size.x, static_cast<double>(rows_) / size.y};
}

std::span<const std::uint32_t> ProjectionGrid::items_at(const glm::dvec2& point) const {
  const glm::dvec2 at = (point - low_) * per_cell_;
  if (at.x < 0.0 || at.y < 0.0 || at.x > static_cast<double>(columns_) || at.y > static_cast<double>(rows_)) {
    return {};
  }
  const std::size_t cell = row(at.y) * columns_ + column(at.x);
  return items_between(cell, cell);
}

}  // namespace moldlight
