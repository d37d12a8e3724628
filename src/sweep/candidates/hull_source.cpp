// Normals of the convex hull's large facets (Qhull): a part can rest on them, and many are good pulls.
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <fmt/format.h>

#include "sweep/candidates/candidate_sources.hpp"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace moldlight {
namespace {

constexpr double k_least_hull_share = 0.01;  // of the hull's surface

std::vector<double> used_points(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  std::vector<double> points;
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex vertex : facet) {
      if (used[vertex]) continue;
      used[vertex] = true;
      for (int axis = 0; axis < 3; ++axis) points.push_back(mesh.vertices[vertex][axis]);
    }
  }
  return points;
}

/// Normals and areas of the hull's facets; empty where there is no hull with volume.
FacetGeometry hull_geometry(std::vector<double> points) {
  FacetGeometry geometry;
  if (points.size() < 3 * 4) return geometry;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> nowhere(std::fopen("/dev/null", "w"), std::fclose);
  if (!nowhere) return geometry;
  qhT qhull;
  qhT* const qh = &qhull;
  qh_zero(qh, nowhere.get());
  char options[] = "qhull Pp";
  const int failure = qh_new_qhull(qh, 3, static_cast<int>(points.size() / 3), points.data(), False, options,
                                   nowhere.get(), nowhere.get());
  if (failure == 0) {
    facetT* facet = nullptr;
    FORALLfacets {
      const double area = qh_facetarea(qh, facet);
      geometry.normals.emplace_back(facet->normal[0], facet->normal[1], facet->normal[2]);
      geometry.areas.push_back(area);
      geometry.total_area += area;
    }
  }
  qh_freeqhull(qh, !qh_ALL);
  int memory_in_use = 0, blocks = 0;
  qh_memfreeshort(qh, &memory_in_use, &blocks);
  return geometry;
}

}  // namespace

std::vector<Candidate> hull_candidates(const TriangleMesh& mesh, std::size_t most) {
  const FacetGeometry hull = hull_geometry(used_points(mesh));
  std::vector<Candidate> candidates;
  for (const NormalCell& cell : normal_histogram(hull)) {
    const double share = cell.area / hull.total_area;
    if (candidates.size() == most || share < k_least_hull_share) break;
    candidates.push_back({cell.normal,
                          {{CandidateKind::hull,
                            fmt::format("normal of {:.1f} % of the convex hull", 100.0 * share), share}}});
  }
  return candidates;
}

}  // namespace moldlight
