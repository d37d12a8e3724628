#include "support/mold_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

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

namespace {

/// A line of a section, between the edges of a facet.
struct SectionLine {
  glm::dvec2 from, to;
  std::array<std::uint64_t, 2> edges;
};

/// Where a plane meets an edge, the same from both of its facets.
glm::dvec2 edge_at(const TriangleMesh& body, VertexIndex a, VertexIndex b, double z) {
  const glm::dvec3 &low = body.vertices[std::min(a, b)], &high = body.vertices[std::max(a, b)];
  const double share = (z - low.z) / (high.z - low.z);
  return glm::dvec2(low) + share * (glm::dvec2(high) - glm::dvec2(low));
}

double distance_to_line(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  const glm::dvec2 along = b - a;
  const double length = glm::length(along);
  return length > 0.0 ? (along.x * (p.y - a.y) - along.y * (p.x - a.x)) / length : 0.0;
}

/// Pairs that cross, each end on its own side of the other by more than `slack`.
std::size_t crossing_lines(std::vector<SectionLine>& lines, double slack) {
  std::ranges::sort(lines, {}, [](const SectionLine& line) { return std::min(line.from.x, line.to.x); });
  std::size_t crossing = 0;
  std::vector<std::size_t> active;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const SectionLine& p = lines[k];
    const double left = std::min(p.from.x, p.to.x);
    std::erase_if(active,
                  [&](std::size_t other) { return std::max(lines[other].from.x, lines[other].to.x) < left; });
    for (const std::size_t other : active) {
      const SectionLine& q = lines[other];
      if (std::max(p.from.y, p.to.y) < std::min(q.from.y, q.to.y) ||
          std::max(q.from.y, q.to.y) < std::min(p.from.y, p.to.y))
        continue;
      const auto between = [&](const SectionLine& line, const SectionLine& ends) {
        const double one = distance_to_line(line.from, line.to, ends.from),
                     two = distance_to_line(line.from, line.to, ends.to);
        return one * two < 0.0 && std::min(std::abs(one), std::abs(two)) > slack;
      };
      crossing += between(p, q) && between(q, p) ? 1 : 0;
    }
    active.push_back(k);
  }
  return crossing;
}

}  // namespace

SectionCheck check_sections(const TriangleMesh& body, double spacing) {
  const Bounds box = bounds(body);
  const auto count = static_cast<std::size_t>((box.max.z - box.min.z) / spacing);
  const auto height = [&](std::size_t k) { return box.min.z + (static_cast<double>(k) + 0.5) * spacing; };
  SectionCheck check{.sections = count};
  std::vector<std::vector<SectionLine>> sections(count);
  for (const auto& facet : body.facets) {
    double low = INFINITY, high = -INFINITY;
    for (const VertexIndex v : facet) {
      low = std::min(low, body.vertices[v].z);
      high = std::max(high, body.vertices[v].z);
    }
    const double first = std::floor((low - box.min.z) / spacing - 0.5);
    for (std::size_t k = first > 0.0 ? static_cast<std::size_t>(first) : 0; k < count && height(k) < high;
         ++k) {
      const double z = height(k);
      SectionLine line{};
      int ends = 0;
      for (std::size_t side = 0; side < 3; ++side) {
        const VertexIndex from = facet[side], to = facet[(side + 1) % 3];
        const bool rises = body.vertices[from].z <= z && body.vertices[to].z > z,
                   falls = body.vertices[from].z > z && body.vertices[to].z <= z;
        if (!rises && !falls) continue;
        const std::uint64_t key = std::uint64_t{std::min(from, to)} << 32U | std::max(from, to);
        (rises ? line.from : line.to) = edge_at(body, from, to, z);
        line.edges[rises ? 0 : 1] = key;
        ++ends;
      }
      if (ends == 2) sections[k].push_back(line);
    }
  }
  const double slack = 1e-6 * glm::distance(box.min, box.max);
  for (std::vector<SectionLine>& lines : sections) {
    // Each edge is left as often as it is reached.
    std::map<std::uint64_t, int> ends;
    for (const SectionLine& line : lines) {
      ++ends[line.edges[0]];
      --ends[line.edges[1]];
    }
    for (const auto& [edge, sum] : ends) check.open += sum != 0 ? 1 : 0;
    check.crossing += crossing_lines(lines, slack);
  }
  return check;
}

}  // namespace moldlight::test
