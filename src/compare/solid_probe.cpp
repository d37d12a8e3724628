#include "compare/solid_probe.hpp"

#include <array>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtx/exterior_product.hpp>
#include <glm/matrix.hpp>

namespace moldlight {

namespace {}  // namespace

SolidProbe::SolidProbe(const TriangleMesh& mesh) : mesh_(mesh) {
  const glm::dvec3 z(std::sqrt(1.0 / 6.0), std::sqrt(1.0 / 3.0), std::sqrt(1.0 / 2.0));
  const glm::dvec3 x = glm::normalize(glm::cross(z, glm::dvec3(0.3, -0.8, 0.52)));
  turn_ = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
  ProjectionGrid::Box box{glm::dvec2(INFINITY), glm::dvec2(-INFINITY)};
  for (const glm::dvec3& vertex : mesh.vertices) {
    turned_.push_back(turn_ * vertex);
    box.low = glm::min(box.low, glm::dvec2(turned_.back()));
    box.high = glm::max(box.high, glm::dvec2(turned_.back()));
  }
  std::vector<std::uint32_t> items(mesh.facets.size());
  std::iota(items.begin(), items.end(), 0U);
  grid_.fill(box, static_cast<double>(items.size()), items, [&](std::uint32_t facet, glm::dvec2* out) {
    for (std::size_t k = 0; k < 3; ++k) out[k] = glm::dvec2(turned_[mesh.facets[facet][k]]);
    return std::size_t{3};
  });
}

int SolidProbe::winding(const glm::dvec3& point) const {
  const glm::dvec3 at = turn_ * point;
  int winding = 0;
  for (const std::uint32_t facet : grid_.items_at(glm::dvec2(at))) {
    const auto& corners = mesh_.facets[facet];
    std::array<double, 3> weight{};
    int left = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      // From the lower vertex to the higher one, so that both facets at an edge decide alike.
      const VertexIndex from = corners[k], to = corners[(k + 1) % 3];
      const bool rises = from < to;
      const glm::dvec2 a = glm::dvec2(turned_[rises ? from : to]) - glm::dvec2(at),
                       b = glm::dvec2(turned_[rises ? to : from]) - glm::dvec2(at);
      const double side = glm::cross(a, b);
      if ((side >= 0.0) == rises) ++left;
      weight[(k + 2) % 3] = rises ? side : -side;
    }
    if (left != 0 && left != 3) continue;
    const double whole = weight[0] + weight[1] + weight[2];
    if (!(std::abs(whole) > 0.0)) continue;
    double height = 0.0;
    for (std::size_t k = 0; k < 3; ++k) height += weight[k] / whole * turned_[corners[k]].z;
    if (height > at.z) winding += left == 3 ? 1 : -1;
  }
  return winding;
}

}  // namespace moldlight
