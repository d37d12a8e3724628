#include "parting/halves/surface_figures.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

constexpr double k_rounding_deg = 0.01;
/// Heights nearer than this, in diagonals of the part, are one; facets that bend less hang together.
constexpr double k_level = 1e-6, k_kink_deg = 5.0;

/// A facet of the surface: its normal, up and as long as twice the area.
struct SurfaceFacet {
  std::array<SheetVertex, 3> corners{};
  glm::dvec3 normal{0.0};
  bool around = true;  // not of a shut-off

  [[nodiscard]] double area() const { return 0.5 * glm::length(normal); }
};

std::vector<SurfaceFacet> facets_of(const Sheets& sheets) {
  std::vector<SurfaceFacet> facets;
  UnionFind joined(sheets.vertices.size());
  glm::dvec2 low(INFINITY), high(-INFINITY);
  for (const SheetFacet& facet : sheets.facets) {
    if (facet.sheet != Sheet::parting) continue;
    const auto& [a, b, c] = facet.corners;
    joined.join(a, b);
    joined.join(b, c);
    facets.push_back({facet.corners, glm::cross(sheets.vertices[b] - sheets.vertices[a],
                                                sheets.vertices[c] - sheets.vertices[a])});
    for (const SheetVertex v : facet.corners) {
      low = glm::min(low, glm::dvec2(sheets.vertices[v]));
      high = glm::max(high, glm::dvec2(sheets.vertices[v]));
    }
  }
  // Pieces of the surface that reach the block's sides; slides may part it.
  std::vector<char> around(sheets.vertices.size(), 0);
  for (const SurfaceFacet& facet : facets) {
    for (const SheetVertex v : facet.corners) {
      const glm::dvec3& at = sheets.vertices[v];
      if (at.x == low.x || at.x == high.x || at.y == low.y || at.y == high.y) around[joined.find(v)] = 1;
    }
  }
  for (SurfaceFacet& facet : facets) facet.around = around[joined.find(facet.corners[0])] != 0;
  return facets;
}

void add_slopes(const Sheets& sheets, const std::vector<SurfaceFacet>& facets, const SlopeLimit& limit,
                SurfaceFigures& figures) {
  double steepest = 0.0;
  for (const SurfaceFacet& facet : facets) {
    (facet.around ? figures.parting_area : figures.shut_off_area) += facet.area();
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, glm::distance(glm::dvec2(sheets.vertices[facet.corners[k]]),
                                                glm::dvec2(sheets.vertices[facet.corners[(k + 1) % 3]])));
    if (facet.normal.z <= limit.narrow * longest) continue;
    const double tangent = glm::length(glm::dvec2(facet.normal)) / facet.normal.z;
    const double slope = std::atan(std::max(tangent - 2.0 * limit.tolerance * longest / facet.normal.z, 0.0));
    steepest = std::max(steepest, slope);
    if (glm::degrees(slope) > limit.slope_deg + k_rounding_deg) figures.too_steep_area += facet.area();
  }
  figures.steepest_deg = glm::degrees(steepest);
}

/// The heights of the surface around the part, and the plane across z with the most of it.
void add_heights(const Sheets& sheets, const std::vector<SurfaceFacet>& facets, SurfaceFigures& figures) {
  glm::dvec2 low(INFINITY), high(-INFINITY);
  figures.low = figures.rim_low = INFINITY;
  figures.high = figures.rim_high = -INFINITY;
  std::vector<std::pair<double, double>> level;  // height, area
  for (const SurfaceFacet& facet : facets) {
    if (!facet.around) continue;
    double least = INFINITY, most = -INFINITY;
    for (const SheetVertex v : facet.corners) {
      const glm::dvec3& at = sheets.vertices[v];
      least = std::min(least, at.z);
      most = std::max(most, at.z);
      low = glm::min(low, glm::dvec2(at));
      high = glm::max(high, glm::dvec2(at));
    }
    figures.low = std::min(figures.low, least);
    figures.high = std::max(figures.high, most);
    if (most - least <= k_level) {
      level.emplace_back(0.5 * (least + most), facet.area());
    } else {
      figures.ramp_area += facet.area();
    }
  }
  for (const SurfaceFacet& facet : facets) {
    if (!facet.around) continue;
    for (const SheetVertex v : facet.corners) {
      const glm::dvec3& at = sheets.vertices[v];
      if (at.x != low.x && at.x != high.x && at.y != low.y && at.y != high.y) continue;
      figures.rim_low = std::min(figures.rim_low, at.z);
      figures.rim_high = std::max(figures.rim_high, at.z);
    }
  }
  std::ranges::sort(level);
  for (std::size_t k = 0; k < level.size();) {
    const double height = level[k].first;
    double area = 0.0;
    for (; k < level.size() && level[k].first - height <= k_level; ++k) area += level[k].second;
    if (area <= figures.shelf_area) continue;
    figures.shelf_area = area;
    figures.shelf_height = height;
  }
}

std::size_t count_faces(const std::vector<SurfaceFacet>& facets) {
  const double least_cosine = std::cos(glm::radians(k_kink_deg));
  std::unordered_map<std::uint64_t, std::uint32_t> across;
  UnionFind joined(facets.size());
  for (std::uint32_t k = 0; k < facets.size(); ++k) {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint64_t key = Sheets::edge_key(facets[k].corners[side], facets[k].corners[(side + 1) % 3]);
      const auto [entry, fresh] = across.try_emplace(key, k);
      if (fresh) continue;
      const glm::dvec3 &p = facets[k].normal, &q = facets[entry->second].normal;
      if (glm::dot(p, q) >= least_cosine * glm::length(p) * glm::length(q)) joined.join(k, entry->second);
    }
  }
  std::size_t faces = 0;
  for (std::uint32_t k = 0; k < facets.size(); ++k) faces += joined.find(k) == k ? 1 : 0;
  return faces;
}

}  // namespace

SurfaceFigures surface_figures(const Sheets& sheets, const SlopeLimit& limit) {
  SurfaceFigures figures;
  const std::vector<SurfaceFacet> facets = facets_of(sheets);
  if (facets.empty()) return figures;
  add_slopes(sheets, facets, limit, figures);
  add_heights(sheets, facets, figures);
  figures.faces = count_faces(facets);
  return figures;
}

}  // namespace moldlight
