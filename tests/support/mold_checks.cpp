#include "support/mold_checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "mesh/facet_geometry.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/exact/exact_regions.hpp"
#include "support/random.hpp"

namespace moldlight::test {

namespace {

/// Facets by cells of the xy-plane.
class FacetColumns {
 public:
  FacetColumns(const TriangleMesh& mesh, const Bounds& box, int cells)
      : mesh_(mesh), box_(box), cells_(cells) {
    lists_.resize(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      Bounds around;
      for (int k = 0; k < 3; ++k) around.add(mesh.corner(facet, k));
      for (int x = cell(around.min.x, 0); x <= cell(around.max.x, 0); ++x) {
        for (int y = cell(around.min.y, 1); y <= cell(around.max.y, 1); ++y) list(x, y).push_back(facet);
      }
    }
  }

  /// Whether the point lies inside, by the facets above it.
  [[nodiscard]] bool holds(const glm::dvec3& p) {
    int winding = 0;
    for (const FacetIndex facet : list(cell(p.x, 0), cell(p.y, 1))) {
      const glm::dvec3 &a = mesh_.corner(facet, 0), &b = mesh_.corner(facet, 1), &c = mesh_.corner(facet, 2);
      const auto side = [&](const glm::dvec3& from, const glm::dvec3& to) {
        // The same value, of the other sign, from the facet across.
        const bool rises = std::pair(from.x, from.y) < std::pair(to.x, to.y);
        const glm::dvec3 &low = rises ? from : to, &high = rises ? to : from;
        const double area = (high.x - low.x) * (p.y - low.y) - (high.y - low.y) * (p.x - low.x);
        return rises ? area : -area;
      };
      const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
      const bool inside = ab > 0.0 && bc > 0.0 && ca > 0.0, turned = ab < 0.0 && bc < 0.0 && ca < 0.0;
      if (!inside && !turned) continue;
      const double z = (bc * a.z + ca * b.z + ab * c.z) / (ab + bc + ca);
      if (z > p.z) winding += inside ? 1 : -1;
    }
    return winding != 0;
  }

 private:
  [[nodiscard]] int cell(double at, int axis) const {
    const double share = (at - box_.min[axis]) / (box_.max[axis] - box_.min[axis]);
    return std::clamp(static_cast<int>(share * cells_), 0, cells_ - 1);
  }
  std::vector<FacetIndex>& list(int x, int y) {
    return lists_[static_cast<std::size_t>(x) * static_cast<std::size_t>(cells_) +
                  static_cast<std::size_t>(y)];
  }

  const TriangleMesh& mesh_;
  Bounds box_;
  int cells_;
  std::vector<std::vector<FacetIndex>> lists_;
};

}  // namespace

double undercut_share(const TriangleMesh& body, const glm::dvec3& lid, double tau_deg) {
  const FacetGeometry geometry = facet_geometry(body);
  const ExactPart part(body, geometry, unit_frame(bounds(body)), Progress{});
  const ExactAreas found =
      exact_areas(part, {.direction = lid, .tau_deg = tau_deg, .lateral = 1e-6}, Progress{});
  return found.areas[Region::undercut] / geometry.total_area;
}

std::size_t crossed_facets(const TriangleMesh& body) {
  const FacetGeometry geometry = facet_geometry(body);
  const ExactPart part(body, geometry, unit_frame(bounds(body)), Progress{});
  std::size_t crossed = 0;
  for (FacetIndex facet = 0; facet < body.facets.size(); ++facet)
    crossed += part.crossings(facet).empty() ? 0 : 1;
  return crossed;
}

std::size_t misplaced_points(std::span<const TriangleMesh> bodies, std::size_t count, std::uint32_t seed) {
  Bounds box;
  for (const TriangleMesh& body : bodies) {
    for (const glm::dvec3& vertex : body.vertices) box.add(vertex);
  }
  std::vector<FacetColumns> columns;
  for (const TriangleMesh& body : bodies) columns.emplace_back(body, box, 200);
  Random random(seed);
  std::size_t misplaced = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec3 p(random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y),
                       random.between(box.min.z, box.max.z));
    int holders = 0;
    for (FacetColumns& body : columns) holders += body.holds(p) ? 1 : 0;
    misplaced += holders == 1 ? 0 : 1;
  }
  return misplaced;
}

std::size_t open_outlines(const TriangleMesh& body, double z) {
  // Each facet that the plane crosses gives a directed line from one of its edges to another: as often as one
  // leaves an edge, another has to come to it.
  std::map<std::pair<VertexIndex, VertexIndex>, int> ends;
  for (const auto& facet : body.facets) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexIndex from = facet[k], to = facet[(k + 1) % 3];
      const bool rises = body.vertices[from].z <= z && body.vertices[to].z > z,
                 falls = body.vertices[from].z > z && body.vertices[to].z <= z;
      if (rises || falls) ends[std::minmax(from, to)] += rises ? 1 : -1;
    }
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(ends, [](const auto& end) { return end.second != 0; }));
}

}  // namespace moldlight::test
