#include "mesh/orient.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/enclosure.hpp"

namespace moldlight {
namespace {

/// Volumes below this share of area^(3/2) are rounding.
constexpr double k_least_volume = 1e-7;

struct Shell {
  double six_volumes = 0.0;  // about the center of its box
  double twice_area = 0.0;
  double border = 0.0;  // length of its open edges
  Bounds box;
  bool consistent = true;
};

std::vector<Shell> measure_shells(const TriangleMesh& mesh, const Components& components) {
  std::vector<Shell> shells(components.count);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (components.of_facet[facet] == k_no_facet) continue;
    Shell& shell = shells[components.of_facet[facet]];
    for (int corner = 0; corner < 3; ++corner) {
      shell.box.min = glm::min(shell.box.min, mesh.corner(facet, corner));
      shell.box.max = glm::max(shell.box.max, mesh.corner(facet, corner));
    }
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
  EdgeTable(mesh).for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
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
  std::stable_sort(outermost_first.begin(), outermost_first.end(),
                   [&](std::size_t a, std::size_t b) { return enclosing[a].size() < enclosing[b].size(); });

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

TurnedFacets turn_if_inside_out(TriangleMesh& mesh) {
  const Components components = connected_components(mesh);
  std::vector<int> signs;
  for (const Shell& shell : measure_shells(mesh, components)) signs.push_back(sign_of(shell));
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
