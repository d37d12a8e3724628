#include "compare/chord_deviation.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

/// Of CAD faces, which may have a cone's tip or a seam: sharper bends are no steps of a round wall.
constexpr double k_greatest_step_deg = 40.0;

/// Of each facet, the greatest value of facets that share a corner with it.
std::vector<double> greatest_around(const TriangleMesh& mesh, const std::vector<double>& of_facet) {
  std::vector<double> at_vertex(mesh.vertices.size(), 0.0), greatest(of_facet);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet)
    for (const VertexIndex vertex : mesh.facets[facet])
      at_vertex[vertex] = std::max(at_vertex[vertex], of_facet[facet]);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet)
    for (const VertexIndex vertex : mesh.facets[facet])
      greatest[facet] = std::max(greatest[facet], at_vertex[vertex]);
  return greatest;
}

}  // namespace

ChordDeviation chord_deviation(const PartModel& model, const Faces& faces) {
  const TriangleMesh& mesh = model.part.mesh;
  const FacetGeometry& geometry = model.geometry;
  const std::size_t facets = mesh.facets.size();
  ChordDeviation chords;
  chords.normal.assign(facets, 0.0);
  chords.spread.assign(facets, 0.0);
  std::vector<double> widths(facets, 0.0);
  const double least_cos = std::cos(glm::radians(k_greatest_step_deg));
  for (FacetIndex left = 0; left < facets; ++left) {
    for (int corner = 0; corner < 3; ++corner) {
      const FacetIndex right = model.adjacency.across[left][static_cast<std::size_t>(corner)];
      if (right == k_no_facet || right < left || faces.of_facet[left] != faces.of_facet[right]) continue;
      if (geometry.areas[left] <= 0.0 || geometry.areas[right] <= 0.0) continue;
      const double cosine = glm::dot(geometry.normals[left], geometry.normals[right]);
      const double bend =
          std::atan2(glm::length(glm::cross(geometry.normals[left], geometry.normals[right])), cosine);
      if (bend < k_flat_bend_rad || cosine < least_cos) continue;
      const double length = glm::distance(mesh.corner(left, corner), mesh.corner(left, (corner + 1) % 3));
      // Of a narrow step beside a wide one the narrow one tells how much the surface bends.
      const double width = 2.0 * std::min(geometry.areas[left], geometry.areas[right]) / length;
      for (const FacetIndex facet : {left, right}) {
        chords.normal[facet] = std::max(chords.normal[facet], 0.125 * width * bend);
        widths[facet] = std::max(widths[facet], width);
        chords.spread[facet] = std::max(chords.spread[facet], std::tan(0.5 * bend));
      }
    }
  }
  for (const double deviation : chords.normal) chords.greatest = std::max(chords.greatest, deviation);
  chords.lateral = greatest_around(mesh, chords.normal);
  chords.step = greatest_around(mesh, widths);
  return chords;
}

}  // namespace moldlight
