// Axes of the curved patches: patches with the same axis speak together.
#include <algorithm>

#include <fmt/format.h>

#include "mold/candidates/candidate_sources.hpp"
#include "mold/candidates/curved_patches.hpp"

namespace moldlight {
namespace {

constexpr double k_same_axis_deg = 0.3;
constexpr double k_least_share_full = 0.0005, k_least_share_partial = 0.005;  // of the surface

struct Axis {
  CurvedPatch best;
  std::size_t patches = 0, full_turns = 0;
  double area = 0.0;
};

std::vector<Axis> common_axes(std::vector<CurvedPatch> patches) {
  std::stable_sort(patches.begin(), patches.end(), [](const CurvedPatch& a, const CurvedPatch& b) {
    return a.full_turn != b.full_turn ? a.full_turn : a.area > b.area;
  });
  std::vector<Axis> axes;
  for (const CurvedPatch& patch : patches) {
    auto same = std::find_if(axes.begin(), axes.end(), [&](const Axis& axis) {
      return line_angle_deg(axis.best.axis, patch.axis) <= k_same_axis_deg;
    });
    if (same == axes.end()) same = axes.insert(axes.end(), Axis{patch, 0, 0, 0.0});
    ++same->patches;
    same->full_turns += patch.full_turn ? 1 : 0;
    same->area += patch.area;
  }
  std::stable_sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) {
    return (a.full_turns > 0) != (b.full_turns > 0) ? a.full_turns > 0 : a.area > b.area;
  });
  return axes;
}

/// "1 full cylinder or cone", "3 full and 1 partial cylinders or cones".
std::string patches_text(const Axis& axis) {
  const auto partial = axis.patches - axis.full_turns;
  std::string text;
  if (axis.full_turns > 0) text = fmt::format("{} full", axis.full_turns);
  if (partial > 0) text += fmt::format("{}{} partial", text.empty() ? "" : " and ", partial);
  return text + (axis.patches == 1 ? " cylinder or cone" : " cylinders or cones");
}

}  // namespace

std::vector<Candidate> revolution_candidates(const FacetGeometry& geometry, const Adjacency& adjacency,
                                             std::size_t most) {
  std::vector<Candidate> candidates;
  for (const Axis& axis : common_axes(curved_patches(geometry, adjacency))) {
    if (candidates.size() == most) break;
    const double share = axis.area / geometry.total_area;
    if (share < (axis.full_turns > 0 ? k_least_share_full : k_least_share_partial)) continue;
    candidates.push_back(
        {half_sphere(axis.best.axis),
         {{CandidateKind::revolution,
           fmt::format("axis of {}, {:.1f} % of the surface", patches_text(axis), 100.0 * share), share}}});
  }
  return candidates;
}

}  // namespace moldlight
