#include "support/parallel_rays.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "mold/draft.hpp"

namespace moldlight::test {
namespace {

constexpr double k_too_close = 1e-9;  // of the diagonal

}  // namespace

ParallelRays::ParallelRays(const TriangleMesh& mesh, const FacetGeometry& geometry,
                           const glm::dvec3& direction, bool closed)
    : mesh_(mesh), geometry_(geometry), direction_(direction), closed_(closed) {
  const Bounds box = bounds(mesh);
  const glm::dvec3 helper = std::abs(direction.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  center_ = 0.5 * (box.min + box.max);
  x_ = glm::normalize(glm::cross(helper, direction));
  y_ = glm::cross(direction, x_);
  margin_ = k_too_close * box.diagonal();
  low_x_ = low_y_ = -0.51 * box.diagonal();
  cells_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(mesh.facets.size()))) + 1;
  cell_size_ = 1.02 * box.diagonal() / static_cast<double>(cells_);
  for (const glm::dvec3& vertex : mesh.vertices) points_.push_back(flat(vertex));
  facets_in_.resize(cells_ * cells_);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const Flat a = points_[mesh.facets[facet][0]], b = points_[mesh.facets[facet][1]],
               c = points_[mesh.facets[facet][2]];
    const std::size_t x0 = cell(std::min({a.x, b.x, c.x}) - margin_, low_x_),
                      x1 = cell(std::max({a.x, b.x, c.x}) + margin_, low_x_),
                      y0 = cell(std::min({a.y, b.y, c.y}) - margin_, low_y_),
                      y1 = cell(std::max({a.y, b.y, c.y}) + margin_, low_y_);
    for (std::size_t x = x0; x <= x1; ++x) {
      for (std::size_t y = y0; y <= y1; ++y) facets_in_[x * cells_ + y].push_back(facet);
    }
  }
}

ParallelRays::Flat ParallelRays::flat(const glm::dvec3& point) const {
  return {glm::dot(point - center_, x_), glm::dot(point - center_, y_)};
}

std::size_t ParallelRays::cell(double x, double low) const {
  return static_cast<std::size_t>(
      std::clamp(std::floor((x - low) / cell_size_), 0.0, static_cast<double>(cells_ - 1)));
}

ParallelRays::Answer ParallelRays::ray(const glm::dvec3& from, double sense, FacetIndex own,
                                       bool facing_only) const {
  const Flat p = flat(from);
  bool unclear = false;
  for (const FacetIndex facet : facets_in_[cell(p.x, low_x_) * cells_ + cell(p.y, low_y_)]) {
    const glm::dvec3& normal = geometry_.normals[facet];
    const double facing = sense * glm::dot(normal, direction_);
    if (facet == own || normal == glm::dvec3(0.0) || (facing_only && facing >= 0.0)) continue;
    // How far the point lies inside each side, in the projection.
    const auto& corners = mesh_.facets[facet];
    double inside = std::numeric_limits<double>::infinity();
    Flat low = points_[corners[0]], high = low;
    for (std::size_t side = 0; side < 3; ++side) {
      const Flat a = points_[corners[side]], b = points_[corners[(side + 1) % 3]];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const double over = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      if (length > 0.0) inside = std::min(inside, (facing * sense > 0.0 ? over : -over) / length);
      low = {std::min(low.x, a.x), std::min(low.y, a.y)};
      high = {std::max(high.x, a.x), std::max(high.y, a.y)};
    }
    if (inside < -margin_ || p.x < low.x - margin_ || p.x > high.x + margin_ || p.y < low.y - margin_ ||
        p.y > high.y + margin_)
      continue;
    const double ahead = glm::dot(mesh_.vertices[corners[0]] - from, normal) * (facing < 0.0 ? -1.0 : 1.0);
    if (ahead < -margin_) continue;
    if (ahead > margin_ && inside > margin_) return Answer::blocked;
    unclear = true;
  }
  return unclear ? Answer::unclear : Answer::free;
}

std::optional<Region> ParallelRays::region(const glm::dvec3& point, FacetIndex facet,
                                           const ShapeSettings& settings) const {
  const glm::dvec3& normal = geometry_.normals[facet];
  const FacetClass kind = facet_class(normal, direction_, settings.tau_deg);
  if (kind != FacetClass::near_vertical) {
    const bool up = kind == FacetClass::up;
    const Answer answer = ray(point, up ? 1.0 : -1.0, facet, !closed_);
    if (answer == Answer::unclear) return std::nullopt;
    return region_of(up && answer == Answer::free, !up && answer == Answer::free);
  }
  const glm::dvec3 from =
      point + settings.lateral_tolerance * glm::normalize(normal - glm::dot(normal, direction_) * direction_);
  const Answer plus = ray(from, 1.0, k_no_facet, false), minus = ray(from, -1.0, k_no_facet, false);
  if (plus == Answer::unclear || minus == Answer::unclear) return std::nullopt;
  return region_of(plus == Answer::free, minus == Answer::free);
}

}  // namespace moldlight::test
