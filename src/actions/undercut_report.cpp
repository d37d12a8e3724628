#include "actions/undercut_report.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include <glm/common.hpp>

#include "classify/map_comparison.hpp"

namespace moldlight {

namespace {

/// Of a face: where less of it is undercut, its rest stays with the half that forms it, and no slide covers
/// the side of a part for the sake of a corner.
constexpr double k_least_hidden = 0.1;
/// A lifter's head is no wider than what it frees, unless that is most of a face.
constexpr double k_least_hidden_of_lifter = 0.5;

struct StraightWay {
  glm::dvec3 direction;
  double length;  // unit frame
};

/// At its middle and near its corners.
bool is_free(const PartModel& model, FacetIndex facet, const Release& release, const StraightWay& way) {
  constexpr double k_inward = 0.02;
  const TriangleMesh& mesh = model.part.mesh;
  const glm::dvec3 middle = mesh.middle(facet);
  const auto leaves = [&](const glm::dvec3& point) {
    const UndercutSample sample{model.frame.to_unit(point), model.geometry.normals[facet], 0.0};
    return release.free_length(sample, way.direction) >= way.length;
  };
  bool free = leaves(middle);
  for (int corner = 0; free && corner < 3; ++corner)
    free = leaves(glm::mix(mesh.corner(facet, corner), middle, k_inward));
  return free;
}

}  // namespace

std::vector<FacetIndex> blockers(const PartModel& model, const SplitMesh& split, const Undercut& undercut,
                                 const glm::dvec3& direction) {
  constexpr std::size_t k_most = 4, k_asked = 48;
  std::map<FacetIndex, int> counts;
  for (const UndercutSample& sample : sample_undercut(model, split, undercut, k_asked)) {
    for (const glm::dvec3& side : {direction, -direction}) {
      const auto hit = model.rays().first_hit(sample.position, glm::vec3(side), true);
      if (hit) ++counts[hit->facet];
    }
  }
  std::vector<std::pair<FacetIndex, int>> order(counts.begin(), counts.end());
  std::ranges::stable_sort(order, std::greater(), [](const auto& entry) { return entry.second; });
  std::vector<FacetIndex> facets;
  for (std::size_t i = 0; i < std::min(order.size(), k_most); ++i) facets.push_back(order[i].first);
  return facets;
}

void add_formed_surface(const FormedContext& context, const SideAction* action, UndercutReport& noted) {
  const auto& [model, split, faces, release] = context;
  noted.formed_area = noted.undercut.area;
  if (action == nullptr || action->about) return;
  std::map<FacetIndex, double> undercut_of;
  for (const std::uint32_t piece : noted.undercut.pieces)
    undercut_of[split.pieces[piece].facet] += piece_area(split, split.pieces[piece]);
  std::set<std::uint32_t> touched;
  for (const auto& [facet, area] : undercut_of) touched.insert(faces.of_facet[facet]);
  const bool lifter = action->kind == ActionKind::lifter;
  const double far = lifter ? action->travel / model.frame.diagonal : std::numeric_limits<double>::infinity();
  const double least_hidden = lifter ? k_least_hidden_of_lifter : k_least_hidden;
  noted.formed_area = 0.0;
  for (const std::uint32_t face : touched) {
    double area = 0.0, hidden_area = 0.0;
    for (const FacetIndex facet : faces.facets(face)) {
      area += model.geometry.areas[facet];
      if (const auto hidden = undercut_of.find(facet); hidden != undercut_of.end())
        hidden_area += hidden->second;
    }
    if (hidden_area < least_hidden * area) {
      noted.formed_area += hidden_area;
      continue;
    }
    for (const FacetIndex facet : faces.facets(face)) {
      const auto hidden = undercut_of.find(facet);
      if (model.geometry.areas[facet] > 0.0 && is_free(model, facet, release, {action->direction, far})) {
        noted.formed_area += model.geometry.areas[facet];
        noted.formed.push_back(facet);
      } else if (hidden != undercut_of.end()) {
        noted.formed_area += hidden->second;
      }
    }
  }
  std::ranges::sort(noted.formed);
}

}  // namespace moldlight
