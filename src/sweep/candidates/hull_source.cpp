// Normals of the convex hull's large facets (Qhull): a part can rest on them, and many are good pulls.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "sweep/candidates/candidate_sources.hpp"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace moldlight {
namespace {

constexpr double k_least_hull_share = 0.01;  // of the hull's surface
constexpr double k_flat = 1e-10;             // volume beside the surface

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
  // Joggled: merging what lies in one plane takes a minute for ten thousand points on a circle.
  char options[] = "qhull QJ Pp";
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
    // What is flat has got a little volume by being joggled.
    qh_getarea(qh, qh->facet_list);
    if (qh->totvol < k_flat * std::pow(geometry.total_area, 1.5)) geometry = {};
  }
  qh_freeqhull(qh, !qh_ALL);
  int memory_in_use = 0, blocks = 0;
  qh_memfreeshort(qh, &memory_in_use, &blocks);
  return geometry;
}

/// Qhull takes seconds for a million points and cannot be interrupted: it works on a thread of its own, which
/// is left to itself once nobody waits for it any more.
FacetGeometry interruptible_hull(std::vector<double> points, const Progress& progress) {
  constexpr std::chrono::milliseconds k_patience(20);
  std::packaged_task<FacetGeometry(std::vector<double>)> task(hull_geometry);
  std::future<FacetGeometry> hull = task.get_future();
  try {
    std::thread(std::move(task), points).detach();
  } catch (const std::system_error&) {  // no more threads
    return hull_geometry(std::move(points));
  }
  while (hull.wait_for(k_patience) != std::future_status::ready) {
    if (progress.cancelled()) throw Cancelled();
  }
  return hull.get();
}

}  // namespace

std::vector<Candidate> hull_candidates(const TriangleMesh& mesh, std::size_t most, const Progress& progress) {
  constexpr std::size_t k_quick = 3 * 5000;  // coordinates
  std::vector<double> points = used_points(mesh);
  const FacetGeometry hull = points.size() < k_quick ? hull_geometry(std::move(points))
                                                     : interruptible_hull(std::move(points), progress);
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
