#include "actions/body_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/adjacency.hpp"

namespace moldlight {

namespace {

/// Of a closed solid's section across a direction (unit) by the plane at a height along it.
double section_area(const TriangleMesh& mesh, std::span<const FacetIndex> facets, const glm::dvec3& normal,
                    double height) {
  double twice = 0.0;
  for (const FacetIndex facet : facets) {
    glm::dvec3 rising(0.0), falling(0.0);
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 &a = mesh.corner(facet, k), &b = mesh.corner(facet, (k + 1) % 3);
      const double from = glm::dot(a, normal) - height, to = glm::dot(b, normal) - height;
      if ((from < 0.0) != (to < 0.0))
        (from < 0.0 ? rising : falling) = a + from / (from - to) * (b - a) - mesh.vertices.front();
    }
    twice += glm::dot(normal, glm::cross(rising, falling));
  }
  return 0.5 * std::abs(twice);
}

}  // namespace

double least_section(const TriangleMesh& body, const glm::dvec3& way) {
  constexpr double k_splinter = 0.01;  // of the greatest of the pieces
  constexpr int k_places = 9;
  const Components components = connected_components(body);
  std::vector<std::vector<FacetIndex>> pieces(components.count);
  for (FacetIndex facet = 0; facet < body.facets.size(); ++facet) {
    if (components.of_facet[facet] != k_no_facet) pieces[components.of_facet[facet]].push_back(facet);
  }
  std::vector<double> sections;
  for (const std::vector<FacetIndex>& piece : pieces) {
    double low = std::numeric_limits<double>::infinity(), high = -low, section = 0.0;
    for (const FacetIndex facet : piece) {
      low = std::min(low, glm::dot(body.corner(facet, 0), way));
      high = std::max(high, glm::dot(body.corner(facet, 0), way));
    }
    for (int k = 0; k < k_places; ++k)
      section = std::max(section, section_area(body, piece, way, low + (k + 0.5) / k_places * (high - low)));
    sections.push_back(section);
  }
  std::ranges::sort(sections);
  const auto found =
      std::ranges::find_if(sections, [&](double section) { return section > k_splinter * sections.back(); });
  return found != sections.end() ? *found : 0.0;
}

}  // namespace moldlight
