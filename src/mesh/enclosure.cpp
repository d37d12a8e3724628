#include "mesh/enclosure.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace moldlight {
namespace {

constexpr int k_points = 3;

/// Skew to everything that is likely in a part, so that rays do not run through edges.
const glm::dvec3 k_ray = glm::normalize(glm::dvec3(0.5377, 0.3141, 0.7823));
const glm::dvec3 k_u = glm::normalize(glm::cross(k_ray, glm::dvec3(0.1733, 0.9511, -0.2557)));
const glm::dvec3 k_v = glm::cross(k_ray, k_u);

glm::dvec3 ray_frame(const glm::dvec3& point) {
  return {glm::dot(point, k_u), glm::dot(point, k_v), glm::dot(point, k_ray)};
}

struct Query {
  glm::dvec3 point;       // in the ray's frame
  std::size_t inner = 0;  // index in `among`
  int place = 0;
};

double turn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// The ray from `point` meets the triangle. Half-open, so that a ray through an edge meets one of its two
/// facets.
bool ray_meets(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& point) {
  bool inside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &a = corners[i], &b = corners[(i + 1) % 3];
    if ((a.y > point.y) != (b.y > point.y)) {
      const glm::dvec3 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
      if (turn(low, high, point) > 0.0) inside = !inside;
    }
  }
  if (!inside) return false;
  const double area = turn(corners[0], corners[1], corners[2]);
  if (area == 0.0) return false;
  const double depth = (turn(corners[1], corners[2], point) * corners[0].z +
                        turn(corners[2], corners[0], point) * corners[1].z +
                        turn(corners[0], corners[1], point) * corners[2].z) /
                       area;
  return depth > point.z;
}

bool box_inside(const Bounds& inner, const Bounds& outer) {
  return glm::all(glm::greaterThanEqual(inner.min, outer.min)) &&
         glm::all(glm::lessThanEqual(inner.max, outer.max));
}

struct ComponentFacets {
  std::vector<Bounds> boxes;
  std::vector<std::size_t> first;  // of each component in `facets`; one more at the end
  std::vector<FacetIndex> facets;  // by component
};

ComponentFacets sort_by_component(const TriangleMesh& mesh, const Components& components) {
  ComponentFacets sorted;
  sorted.boxes.resize(components.count);
  sorted.first.assign(components.count + 1, 0);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const FacetIndex component = components.of_facet[facet];
    if (component == k_no_facet) continue;
    ++sorted.first[component + 1];
    Bounds& box = sorted.boxes[component];
    for (int corner = 0; corner < 3; ++corner) {
      box.min = glm::min(box.min, mesh.corner(facet, corner));
      box.max = glm::max(box.max, mesh.corner(facet, corner));
    }
  }
  for (std::size_t component = 0; component < components.count; ++component) {
    sorted.first[component + 1] += sorted.first[component];
  }
  sorted.facets.resize(sorted.first.back());
  std::vector<std::size_t> next_free(sorted.first.begin(), sorted.first.end() - 1);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const FacetIndex component = components.of_facet[facet];
    if (component != k_no_facet) sorted.facets[next_free[component]++] = facet;
  }
  return sorted;
}

/// Flips `odd[inner][place]` for each facet of the component that the query's ray meets. `queries` are sorted
/// by x.
void sweep(const TriangleMesh& mesh, std::span<const FacetIndex> facets, const std::vector<Query>& queries,
           std::vector<std::array<bool, k_points>>& odd) {
  for (const FacetIndex facet : facets) {
    const std::array<glm::dvec3, 3> corners = {
        ray_frame(mesh.corner(facet, 0)), ray_frame(mesh.corner(facet, 1)), ray_frame(mesh.corner(facet, 2))};
    const auto [low, high] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    auto query = std::lower_bound(queries.begin(), queries.end(), low,
                                  [](const Query& q, double x) { return q.point.x < x; });
    for (; query != queries.end() && query->point.x <= high; ++query) {
      if (ray_meets(corners, query->point))
        odd[query->inner][query->place] = !odd[query->inner][query->place];
    }
  }
}

}  // namespace

std::vector<std::vector<FacetIndex>> enclosing_components(const TriangleMesh& mesh,
                                                          const Components& components,
                                                          const std::vector<FacetIndex>& among) {
  std::vector<std::vector<FacetIndex>> enclosing(among.size());
  if (among.empty()) return enclosing;
  const ComponentFacets sorted = sort_by_component(mesh, components);
  std::vector<Query> queries;
  std::vector<std::array<bool, k_points>> odd(among.size());
  for (const FacetIndex outer : among) {
    queries.clear();
    for (std::size_t i = 0; i < among.size(); ++i) {
      if (among[i] == outer || !box_inside(sorted.boxes[among[i]], sorted.boxes[outer])) continue;
      odd[i] = {};
      const std::size_t count = sorted.first[among[i] + 1] - sorted.first[among[i]];
      for (int place = 0; place < k_points; ++place) {
        const FacetIndex facet =
            sorted.facets[sorted.first[among[i]] + count * static_cast<std::size_t>(place) / k_points];
        const glm::dvec3 centroid =
            (mesh.corner(facet, 0) + mesh.corner(facet, 1) + mesh.corner(facet, 2)) / 3.0;
        queries.push_back({ray_frame(centroid), i, place});
      }
    }
    if (queries.empty()) continue;
    std::sort(queries.begin(), queries.end(),
              [](const Query& a, const Query& b) { return a.point.x < b.point.x; });
    sweep(
        mesh,
        std::span(sorted.facets).subspan(sorted.first[outer], sorted.first[outer + 1] - sorted.first[outer]),
        queries, odd);
    for (const Query& query : queries) {
      if (query.place == 0 &&
          std::count(odd[query.inner].begin(), odd[query.inner].end(), true) > k_points / 2) {
        enclosing[query.inner].push_back(outer);
      }
    }
  }
  return enclosing;
}

}  // namespace moldlight
