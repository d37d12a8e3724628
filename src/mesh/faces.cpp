#include "mesh/faces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

/// Bends below this are those of rounded coordinates, on facets that are not too thin.
constexpr double k_plane_deg = 0.05;
constexpr double k_step_deg = 20.0;
constexpr double k_width_ratio = 3.0;  // of plates that may be steps of one bend

/// Calls visit(facet, across) once for each edge between facets with area that bends less than this.
template <typename Visit>
void for_bends(const FacetGeometry& geometry, const Adjacency& adjacency, double below_deg, Visit&& visit) {
  const double least_cosine = std::cos(glm::radians(below_deg));
  for (FacetIndex facet = 0; facet < adjacency.across.size(); ++facet) {
    if (geometry.areas[facet] <= 0.0) continue;
    for (int corner = 0; corner < 3; ++corner) {
      const FacetIndex across = adjacency.across[facet][static_cast<std::size_t>(corner)];
      if (across == k_no_facet || across < facet || geometry.areas[across] <= 0.0) continue;
      if (glm::dot(geometry.normals[facet], geometry.normals[across]) >= least_cosine) visit(facet, across);
    }
  }
}

std::vector<std::uint32_t> roots(UnionFind& sets, std::size_t count) {
  std::vector<std::uint32_t> found(count);
  for (std::uint32_t item = 0; item < count; ++item) found[item] = sets.find(item);
  return found;
}

/// Width of each plate, at the place of its first facet: that of a long strip whose area and outline it has.
std::vector<double> plate_widths(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                 const Adjacency& adjacency, std::span<const std::uint32_t> plates) {
  std::vector<double> areas(plates.size(), 0.0), outlines(plates.size(), 0.0);
  for (FacetIndex facet = 0; facet < plates.size(); ++facet) {
    const std::uint32_t plate = plates[facet];
    areas[plate] += geometry.areas[facet];
    for (int corner = 0; corner < 3; ++corner) {
      const FacetIndex across = adjacency.across[facet][static_cast<std::size_t>(corner)];
      if (across != k_no_facet && plates[across] == plate) continue;
      outlines[plate] += glm::distance(mesh.corner(facet, corner), mesh.corner(facet, (corner + 1) % 3));
    }
  }
  for (std::size_t plate = 0; plate < areas.size(); ++plate) {
    if (outlines[plate] > 0.0) areas[plate] *= 2.0 / outlines[plate];
  }
  return areas;
}

/// Facets by the number of their face, which is below `count`.
Faces grouped(std::vector<std::uint32_t> of_facet, std::size_t count) {
  Faces faces{.of_facet = std::move(of_facet), .starts = {}, .members = {}};
  faces.starts.resize(count + 1, 0);
  for (const std::uint32_t face : faces.of_facet) ++faces.starts[face + 1];
  for (std::size_t face = 0; face < count; ++face) faces.starts[face + 1] += faces.starts[face];
  faces.members.resize(faces.of_facet.size());
  std::vector<std::uint32_t> next(faces.starts.begin(), faces.starts.end() - 1);
  for (FacetIndex facet = 0; facet < faces.of_facet.size(); ++facet)
    faces.members[next[faces.of_facet[facet]]++] = facet;
  return faces;
}

/// The same faces, numbered by which of their facets the file lists first.
Faces numbered_as_listed(const Faces& faces, const std::vector<std::uint32_t>& file_facets) {
  std::vector<std::uint32_t> first(faces.count(), k_no_facet), order(faces.count()), number(faces.count());
  for (FacetIndex facet = 0; facet < file_facets.size(); ++facet)
    first[faces.of_facet[facet]] = std::min(first[faces.of_facet[facet]], file_facets[facet]);
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t face) { return first[face]; });
  for (std::uint32_t k = 0; k < order.size(); ++k) number[order[k]] = k;
  std::vector<std::uint32_t> of_facet = faces.of_facet;
  for (std::uint32_t& face : of_facet) face = number[face];
  return grouped(std::move(of_facet), faces.count());
}

}  // namespace

Faces smooth_faces(const TriangleMesh& mesh, const FacetGeometry& geometry, const Adjacency& adjacency) {
  const std::size_t count = mesh.facets.size();
  UnionFind sets(count);
  for_bends(geometry, adjacency, k_plane_deg, [&](FacetIndex a, FacetIndex b) { sets.join(a, b); });
  const std::vector<std::uint32_t> plates = roots(sets, count);
  const std::vector<double> widths = plate_widths(mesh, geometry, adjacency, plates);

  struct Step {
    std::uint32_t a, b;
  };
  std::vector<Step> steps;
  std::vector<std::uint32_t> neighbour(count, k_no_facet);  // the first that was met
  std::vector<bool> bends_on(count, false);                 // there is another one
  for_bends(geometry, adjacency, k_step_deg, [&](FacetIndex facet, FacetIndex across) {
    const Step step{plates[facet], plates[across]};
    const auto [narrow, wide] = std::minmax(widths[step.a], widths[step.b]);
    if (step.a == step.b || wide > k_width_ratio * narrow) return;
    steps.push_back(step);
    for (const auto& [plate, other] : {step, Step{step.b, step.a}}) {
      if (neighbour[plate] == k_no_facet) neighbour[plate] = other;
      if (neighbour[plate] != other) bends_on[plate] = true;
    }
  });
  for (const Step& step : steps) {
    if (bends_on[step.a] || bends_on[step.b]) sets.join(step.a, step.b);
  }

  // The first facet stands for its face, so it is met first.
  std::vector<std::uint32_t> faces = roots(sets, count);
  std::uint32_t found = 0;
  for (FacetIndex facet = 0; facet < count; ++facet)
    faces[facet] = faces[facet] == facet ? found++ : faces[faces[facet]];
  return grouped(std::move(faces), found);
}

Faces part_faces(const Part& part, const FacetGeometry& geometry, const Adjacency& adjacency) {
  if (!part.has_cad_faces) {
    Faces faces = smooth_faces(part.mesh, geometry, adjacency);
    return part.file_facets.empty() ? faces : numbered_as_listed(faces, part.file_facets);
  }
  std::vector<std::uint32_t> numbers = part.facet_source;
  std::uint32_t count = 0;
  for (const std::uint32_t number : numbers) {
    if (number != k_no_facet) count = std::max(count, number + 1);
  }
  // What a repair has added is one more.
  std::ranges::replace(numbers, k_no_facet, count);
  return grouped(std::move(numbers), count + std::size_t{1});
}

}  // namespace moldlight
