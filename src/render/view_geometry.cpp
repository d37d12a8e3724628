#include "render/view_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "mesh/edges.hpp"

namespace moldlight {

namespace {

constexpr int k_extreme_directions = 128;  // each with its opposite

/// The outermost vertices along directions spread evenly over a half-sphere, and their opposites; each once.
std::vector<glm::vec3> extreme_vertices(const std::vector<ViewVertex>& vertices) {
  std::vector<std::size_t> found;
  for (int k = 0; k < k_extreme_directions && !vertices.empty(); ++k) {
    const float z = (static_cast<float>(k) + 0.5F) / k_extreme_directions;
    const float angle = 2.3999632F * static_cast<float>(k);  // the golden angle
    const float radius = std::sqrt(1.0F - z * z);
    const glm::vec3 direction(radius * std::cos(angle), radius * std::sin(angle), z);
    std::size_t least = 0, most = 0;
    float low = std::numeric_limits<float>::infinity(), high = -low;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const float along = glm::dot(direction, vertices[i].position);
      if (along < low) {
        low = along;
        least = i;
      }
      if (along > high) {
        high = along;
        most = i;
      }
    }
    found.push_back(least);
    found.push_back(most);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<glm::vec3> points;
  for (const std::size_t vertex : found) points.push_back(vertices[vertex].position);
  return points;
}

/// The octahedron's lower half, folded out over the square's corners; its own inverse.
glm::vec2 folded(const glm::vec2& place) {
  return {std::copysign(1.0F - std::abs(place.y), place.x), std::copysign(1.0F - std::abs(place.x), place.y)};
}

}  // namespace

std::array<std::int16_t, 2> octahedral(const glm::vec3& vector) {
  const glm::vec2 flat = glm::vec2(vector) / (std::abs(vector.x) + std::abs(vector.y) + std::abs(vector.z));
  const glm::vec2 place = vector.z < 0.0F ? folded(flat) : flat;
  const auto step = [](float value) { return static_cast<std::int16_t>(std::lround(32767.0F * value)); };
  return {step(place.x), step(place.y)};
}

glm::vec3 from_octahedral(const std::array<std::int16_t, 2>& steps) {
  const glm::vec2 place = glm::vec2(steps[0], steps[1]) / 32767.0F;
  const float z = 1.0F - std::abs(place.x) - std::abs(place.y);
  return glm::normalize(glm::vec3(z < 0.0F ? folded(place) : place, z));
}

ViewGeometry view_geometry(const TriangleMesh& mesh, const FacetGeometry& geometry,
                           const Adjacency& adjacency, const UnitFrame& frame) {
  ViewGeometry view;
  SmoothCorners smooth = smooth_corners(mesh, geometry, adjacency);
  view.vertices.reserve(smooth.source.size());
  for (std::size_t i = 0; i < smooth.source.size(); ++i) {
    view.vertices.push_back({frame.to_unit(mesh.vertices[smooth.source[i]]), octahedral(smooth.normals[i])});
  }
  view.facets = std::move(smooth.of_facet);
  for (const EdgeEnds& edge : crease_edges(mesh, geometry, adjacency)) {
    view.feature_edges.push_back(
        {frame.to_unit(mesh.vertices[edge.a]), frame.to_unit(mesh.vertices[edge.b])});
  }
  view.extremes = extreme_vertices(view.vertices);
  view.closed = true;
  for (FacetIndex facet = 0; facet < mesh.facets.size() && view.closed; ++facet) {
    for (const FacetIndex across : adjacency.across[facet]) {
      if (across == k_no_facet && geometry.areas[facet] > 0.0) view.closed = false;
    }
  }
  return view;
}

std::vector<ViewSegment> contour_edges(const TriangleMesh& mesh, std::span<const FacetEdge> edges,
                                       std::span<const FacetClass> classes, const UnitFrame& frame) {
  std::vector<ViewSegment> segments;
  for (const FacetEdge& edge : edges) {
    if (classes[edge.left] == classes[edge.right]) continue;
    segments.push_back({frame.to_unit(mesh.vertices[edge.a]), frame.to_unit(mesh.vertices[edge.b])});
  }
  return segments;
}

}  // namespace moldlight
