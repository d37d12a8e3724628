#include "mesh/orient.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "mesh/adjacency.hpp"

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
    for (int corner = 0; corner < 3; ++corner) sorted.boxes[component].add(mesh.corner(facet, corner));
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
    auto query = std::ranges::lower_bound(queries, low, {}, [](const Query& q) { return q.point.x; });
    for (; query != queries.end() && query->point.x <= high; ++query) {
      if (ray_meets(corners, query->point))
        odd[query->inner][query->place] = !odd[query->inner][query->place];
    }
  }
}

/// For each component of `among`: those others of `among` that enclose it, in rising order, by ray parity,
/// all rays in one skew direction. A component encloses another when its box does and most of three points of
/// the other have an odd number of its facets on one side of them. Where surfaces cross or touch the answer
/// is one of the possible ones; it is the same in every run.
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
        const glm::dvec3 centroid = mesh.middle(facet);
        queries.push_back({ray_frame(centroid), i, place});
      }
    }
    if (queries.empty()) continue;
    std::ranges::sort(queries, {}, [](const Query& query) { return query.point.x; });
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

/// Volumes below this share of area^(3/2) are rounding.
constexpr double k_least_volume = 1e-7;

struct Shell {
  double six_volumes = 0.0;  // about the center of its box
  double twice_area = 0.0;
  double border = 0.0;  // length of its open edges
  Bounds box;
  bool consistent = true;
};

std::vector<Shell> measure_shells(const TriangleMesh& mesh, const EdgeTable& edges,
                                  const Components& components) {
  std::vector<Shell> shells(components.count);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (components.of_facet[facet] == k_no_facet) continue;
    Shell& shell = shells[components.of_facet[facet]];
    for (int corner = 0; corner < 3; ++corner) shell.box.add(mesh.corner(facet, corner));
  }
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (components.of_facet[facet] == k_no_facet) continue;
    Shell& shell = shells[components.of_facet[facet]];
    const glm::dvec3 center = shell.box.center();
    const glm::dvec3 a = mesh.corner(facet, 0) - center, b = mesh.corner(facet, 1) - center,
                     c = mesh.corner(facet, 2) - center;
    shell.six_volumes += glm::dot(a, glm::cross(b, c));
    shell.twice_area += glm::length(glm::cross(b - a, c - a));
  }
  edges.for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
    Shell& shell = shells[components.of_facet[facet_of(uses[0].half_edge)]];
    const auto upward = std::count_if(uses.begin(), uses.end(), [&](const EdgeUse& use) {
      return start_vertex(mesh, use.half_edge) == low;
    });
    if (uses.size() == 2 && upward != 1) shell.consistent = false;
    if (uses.size() % 2 == 1) shell.border += glm::distance(mesh.vertices[low], mesh.vertices[uses[0].high]);
  });
  return shells;
}

/// -1, 1, or 0 where the winding is inconsistent or gaps or rounding leave the sign open.
int sign_of(const Shell& shell) {
  if (!shell.consistent) return 0;
  // The least surface that closes a gap is no larger than a disk with the gap's border, and lies in the box.
  const double gap = shell.border * shell.border / (4.0 * std::numbers::pi) * shell.box.diagonal();
  const double least = k_least_volume * std::pow(0.5 * shell.twice_area, 1.5);
  if (std::abs(shell.six_volumes) <= gap + 6.0 * least) return 0;
  return shell.six_volumes < 0.0 ? -1 : 1;
}

/// `enclosing` has one entry for each of `solids`, the components whose sign is known.
std::vector<bool> choose_turned(std::vector<int> signs, const std::vector<FacetIndex>& solids,
                                const std::vector<std::vector<FacetIndex>>& enclosing) {
  std::vector<std::size_t> depth(signs.size(), 0), outermost_first(solids.size());
  for (std::size_t i = 0; i < solids.size(); ++i) {
    outermost_first[i] = i;
    depth[solids[i]] = enclosing[i].size();
  }
  std::ranges::stable_sort(outermost_first, {}, [&](std::size_t i) { return enclosing[i].size(); });

  std::vector<bool> turned(signs.size(), false);
  for (const std::size_t i : outermost_first) {
    const FacetIndex component = solids[i];
    int winding = 0;
    FacetIndex parent = k_no_facet;
    for (const FacetIndex outer : enclosing[i]) {
      winding += signs[outer];
      if (parent == k_no_facet || depth[outer] > depth[parent]) parent = outer;
    }
    const bool void_of_turned =
        signs[component] > 0 && parent != k_no_facet && turned[parent] && signs[parent] > 0;
    if (void_of_turned || (signs[component] < 0 && winding <= 0)) {
      turned[component] = true;
      signs[component] = -signs[component];
    }
  }
  return turned;
}

}  // namespace

TurnedFacets turn_if_inside_out(TriangleMesh& mesh, const EdgeTable& edges) {
  const Components components = connected_components(mesh, edges);
  std::vector<int> signs;
  for (const Shell& shell : measure_shells(mesh, edges, components)) signs.push_back(sign_of(shell));
  TurnedFacets result;
  result.components_left = components.count;
  if (std::find(signs.begin(), signs.end(), -1) == signs.end()) return result;

  std::vector<FacetIndex> solids;
  for (FacetIndex component = 0; component < components.count; ++component) {
    if (signs[component] != 0) solids.push_back(component);
  }
  const std::vector<bool> turned =
      choose_turned(signs, solids, enclosing_components(mesh, components, solids));
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const FacetIndex component = components.of_facet[facet];
    if (component == k_no_facet || !turned[component]) continue;
    std::swap(mesh.facets[facet][1], mesh.facets[facet][2]);
    ++result.facets;
  }
  result.components = static_cast<std::size_t>(std::count(turned.begin(), turned.end(), true));
  result.components_left = components.count - result.components;
  return result;
}

std::string turned_warning(const TurnedFacets& turned) {
  if (turned.facets == 0) return {};
  if (turned.components_left == 0) {
    return fmt::format("The part was inside out: all its {} facets were turned.", turned.facets);
  }
  return fmt::format("{} of {} bodies {} inside out: {} facets were turned.", turned.components,
                     turned.components + turned.components_left, turned.components == 1 ? "was" : "were",
                     turned.facets);
}

}  // namespace moldlight
