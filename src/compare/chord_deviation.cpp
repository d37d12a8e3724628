// How far a mesh may lie off the surface that it stands for.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "compare/overlay.hpp"
#include "mesh/union_find.hpp"

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

/// An edge between two plates, which are what lies in one plane.
struct PlateEdge {
  FacetIndex left = 0, right = 0;
  std::array<std::uint32_t, 2> plates{};
  glm::dvec3 along{0.0};  // unit
  double length = 0.0, bend = 0.0;
  bool convex = true;
};

/// Edges that bend by less than the greatest step, none within a plate.
std::vector<PlateEdge> plate_edges(const PartModel& model) {
  const TriangleMesh& mesh = model.part.mesh;
  const FacetGeometry& geometry = model.geometry;
  UnionFind plates(mesh.facets.size());
  std::vector<PlateEdge> edges;
  const double least_cos = std::cos(glm::radians(k_greatest_step_deg));
  for (FacetIndex left = 0; left < mesh.facets.size(); ++left) {
    for (int corner = 0; corner < 3; ++corner) {
      const FacetIndex right = model.adjacency.across[left][static_cast<std::size_t>(corner)];
      if (right == k_no_facet || right < left) continue;
      if (geometry.areas[left] <= 0.0 || geometry.areas[right] <= 0.0) continue;
      const glm::dvec3 turn = glm::cross(geometry.normals[left], geometry.normals[right]);
      const double cosine = glm::dot(geometry.normals[left], geometry.normals[right]);
      const double bend = std::atan2(glm::length(turn), cosine);
      if (bend < k_flat_bend_rad) plates.join(left, right);
      if (bend < k_flat_bend_rad || cosine < least_cos) continue;
      const glm::dvec3 along = mesh.corner(left, (corner + 1) % 3) - mesh.corner(left, corner);
      const double length = glm::length(along);
      edges.push_back({left, right, {}, along / length, length, bend, glm::dot(turn, along) > 0.0});
    }
  }
  for (PlateEdge& edge : edges) edge.plates = {plates.find(edge.left), plates.find(edge.right)};
  return edges;
}

/// Whether edges are steps of one bend: about parallel, and bending about as much in the same sense.
bool alike(const PlateEdge& a, const PlateEdge& b) {
  constexpr double k_parallel = 0.97, k_ratio = 0.7;
  return a.convex == b.convex && std::abs(glm::dot(a.along, b.along)) > k_parallel &&
         std::min(a.bend, b.bend) > k_ratio * std::max(a.bend, b.bend);
}

/// Of edges that are in no one face: those where one of the plates bends on alike at its other side, as the
/// sides of a coarse round wall do.
std::vector<bool> coarse_steps(const std::vector<PlateEdge>& edges) {
  // A plate with more of them is no step of a round wall.
  constexpr std::size_t k_most_edges = 32;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> of_plate;
  for (std::uint32_t k = 0; k < edges.size(); ++k)
    for (const std::uint32_t plate : edges[k].plates) of_plate[plate].push_back(k);
  std::vector<bool> steps(edges.size(), false);
  for (std::uint32_t k = 0; k < edges.size(); ++k) {
    for (const std::uint32_t plate : edges[k].plates) {
      const std::vector<std::uint32_t>& around = of_plate[plate];
      if (around.size() > k_most_edges) continue;
      for (const std::uint32_t other : around)
        if (edges[other].plates != edges[k].plates && alike(edges[k], edges[other])) steps[k] = true;
    }
  }
  return steps;
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
  const std::vector<PlateEdge> edges = plate_edges(model);
  const std::vector<bool> steps =
      model.part.has_cad_faces ? std::vector<bool>(edges.size(), false) : coarse_steps(edges);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const PlateEdge& edge = edges[k];
    if (!steps[k] && faces.of_facet[edge.left] != faces.of_facet[edge.right]) continue;
    // Of a narrow step beside a wide one the narrow one shows how much the surface bends.
    const double width = 2.0 * std::min(geometry.areas[edge.left], geometry.areas[edge.right]) / edge.length;
    for (const FacetIndex facet : {edge.left, edge.right}) {
      chords.normal[facet] = std::max(chords.normal[facet], 0.125 * width * edge.bend);
      widths[facet] = std::max(widths[facet], width);
      chords.spread[facet] = std::max(chords.spread[facet], std::tan(0.5 * edge.bend));
    }
  }
  for (const double deviation : chords.normal) chords.greatest = std::max(chords.greatest, deviation);
  chords.lateral = greatest_around(mesh, chords.normal);
  chords.step = greatest_around(mesh, widths);
  return chords;
}

}  // namespace moldlight
