// Axes of the curved patches: patches with the same axis speak together.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/symmetric_eigen.hpp"
#include "mesh/union_find.hpp"
#include "sweep/candidates/candidate_sources.hpp"

namespace moldlight {

namespace {

const double k_flat_cosine = std::cos(glm::radians(0.1));     // facets of one strip
const double k_smooth_cosine = std::cos(glm::radians(40.0));  // neighbouring strips
const double k_grow_sine = std::sin(glm::radians(0.6));       // of a strip off the patch's cone
const double k_fit_sine = std::sin(glm::radians(0.3));        // root mean square of all strips
constexpr double k_most_area_ratio = 12.0;  // of a strip to the seed: keeps tangent planes out
constexpr double k_least_sagitta = 0.035;   // standard deviation of the normals across their arc: 60 degrees
constexpr double k_steepest_sine = 0.98;    // cones flatter than that are planes
constexpr std::size_t k_least_strips = 4;
constexpr std::size_t k_most_visits = 20'000'000;  // of strips, so that free-form surfaces end in time

using Strip = std::uint32_t;

struct Strips {
  std::vector<glm::dvec3> normals;
  std::vector<double> areas;
  std::vector<std::size_t> first_link;  // of each strip in `links`; one more at the end
  std::vector<Strip> links;             // smooth neighbours

  [[nodiscard]] std::span<const Strip> neighbours(Strip strip) const {
    return {links.data() + first_link[strip], first_link[strip + 1] - first_link[strip]};
  }
};

Strips make_strips(const FacetGeometry& geometry, const Adjacency& adjacency) {
  const std::size_t facets = geometry.areas.size();
  UnionFind flat(facets);
  const auto for_each_edge = [&](auto&& visit) {
    for (FacetIndex facet = 0; facet < facets; ++facet) {
      if (geometry.areas[facet] <= 0.0) continue;
      for (const FacetIndex other : adjacency.across[facet]) {
        if (other != k_no_facet && geometry.areas[other] > 0.0) visit(facet, other);
      }
    }
  };
  for_each_edge([&](FacetIndex a, FacetIndex b) {
    if (a < b && glm::dot(geometry.normals[a], geometry.normals[b]) > k_flat_cosine) flat.join(a, b);
  });

  Strips strips;
  std::vector<Strip> strip_of(facets, 0);
  for (FacetIndex facet = 0; facet < facets; ++facet) {
    const FacetIndex first = flat.find(facet);
    if (first == facet) {
      strip_of[facet] = static_cast<Strip>(strips.normals.size());
      strips.normals.emplace_back(0.0);
      strips.areas.push_back(0.0);
    }
    strip_of[facet] = strip_of[first];
    strips.normals[strip_of[facet]] += geometry.areas[facet] * geometry.normals[facet];
    strips.areas[strip_of[facet]] += geometry.areas[facet];
  }
  for (glm::dvec3& normal : strips.normals) {
    if (glm::length(normal) > 0.0) normal = glm::normalize(normal);
  }

  std::vector<std::pair<Strip, Strip>> links;
  for_each_edge([&](FacetIndex a, FacetIndex b) {
    const Strip from = strip_of[a], to = strip_of[b];
    if (from != to && glm::dot(strips.normals[from], strips.normals[to]) > k_smooth_cosine)
      links.emplace_back(from, to);
  });
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  strips.first_link.assign(strips.normals.size() + 1, 0);
  for (const auto& [from, to] : links) {
    ++strips.first_link[from + 1];
    strips.links.push_back(to);
  }
  for (std::size_t i = 1; i < strips.first_link.size(); ++i) strips.first_link[i] += strips.first_link[i - 1];
  return strips;
}

/// The normals n of a cylinder or cone: n . axis = sine.
struct NormalCone {
  glm::dvec3 axis{0, 0, 1};
  double sine = 0.0;
};

struct Fit {
  NormalCone cone;
  double area = 0.0;
  bool good = false, full_turn = false;
};

Fit fit_cone(const Strips& strips, std::span<const Strip> members) {
  Fit fit;
  glm::dvec3 mean(0.0);
  for (const Strip strip : members) {
    mean += strips.areas[strip] * strips.normals[strip];
    fit.area += strips.areas[strip];
  }
  mean /= fit.area;
  glm::dmat3 covariance(0.0);
  for (const Strip strip : members) {
    const glm::dvec3 offset = strips.normals[strip] - mean;
    covariance += strips.areas[strip] / fit.area * glm::outerProduct(offset, offset);
  }
  const SymmetricEigen<3> eigen = symmetric_eigen<3>(covariance);
  fit.cone = {eigen.vectors[0], glm::dot(mean, eigen.vectors[0])};
  fit.good = std::sqrt(std::max(0.0, eigen.values[0])) < k_fit_sine &&
             std::sqrt(std::max(0.0, eigen.values[1])) > k_least_sagitta &&
             std::abs(fit.cone.sine) < k_steepest_sine;
  fit.full_turn = eigen.values[1] > 0.4 * eigen.values[2];
  return fit;
}

class PatchGrower {
 public:
  explicit PatchGrower(const Strips& strips)
      : strips_(strips), taken_(strips.normals.size(), false), seen_in_(strips.normals.size(), 0) {}

  [[nodiscard]] bool is_taken(Strip strip) const { return taken_[strip]; }
  [[nodiscard]] bool is_exhausted() const { return visits_ > k_most_visits; }
  /// Of the patch that was grown last.
  [[nodiscard]] std::span<const Strip> last() const { return last_; }

  /// A patch through the seed and two of its neighbours, one on either side.
  std::optional<CurvedPatch> grow(Strip seed) {
    const std::span<const Strip> around = strips_.neighbours(seed);
    for (std::size_t i = 0; i < around.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (taken_[around[i]] || taken_[around[j]]) continue;
        if (!is_across(seed, around[i], around[j])) continue;
        if (auto patch = grow_along(seed, first_cone(seed, around[i], around[j]))) return patch;
      }
    }
    return std::nullopt;
  }

 private:
  /// The two neighbours lean away from the seed in opposite ways.
  [[nodiscard]] bool is_across(Strip seed, Strip a, Strip b) const {
    const glm::dvec3 &n = strips_.normals[seed], to_a = strips_.normals[a] - n, to_b = strips_.normals[b] - n;
    return glm::dot(to_a, to_b) < -0.7 * glm::length(to_a) * glm::length(to_b);
  }

  /// A cylinder where the three normals allow it: its axis is far less sensitive to rounding than a cone's.
  [[nodiscard]] NormalCone first_cone(Strip seed, Strip a, Strip b) const {
    const glm::dvec3 &n = strips_.normals[seed], &na = strips_.normals[a], &nb = strips_.normals[b];
    const glm::dvec3 axis = glm::normalize(glm::cross(na, nb));
    if (std::abs(glm::dot(axis, n)) < k_fit_sine) return {axis, 0.0};
    const glm::dvec3 cone_axis = glm::normalize(glm::cross(na - n, nb - n));
    return {cone_axis, glm::dot(cone_axis, n)};
  }

  std::optional<CurvedPatch> grow_along(Strip seed, NormalCone cone) {
    Fit fit;
    for (int round = 0; round < 2; ++round) {
      collect(seed, cone);
      if (members_.size() < k_least_strips) return std::nullopt;
      fit = fit_cone(strips_, members_);
      if (!fit.good) return std::nullopt;
      cone = fit.cone;
    }
    for (const Strip strip : members_) taken_[strip] = true;
    last_ = members_;
    return CurvedPatch{fit.cone.axis, fit.area, fit.full_turn};
  }

  /// members_ = free strips on the cone that smooth links connect to the seed.
  void collect(Strip seed, const NormalCone& cone) {
    ++current_;
    members_.assign(1, seed);
    seen_in_[seed] = current_;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      for (const Strip next : strips_.neighbours(members_[i])) {
        ++visits_;
        if (taken_[next] || seen_in_[next] == current_) continue;
        if (std::abs(glm::dot(strips_.normals[next], cone.axis) - cone.sine) > k_grow_sine) continue;
        if (strips_.areas[next] > k_most_area_ratio * strips_.areas[seed]) continue;
        seen_in_[next] = current_;
        members_.push_back(next);
      }
    }
  }

  const Strips& strips_;
  std::vector<bool> taken_;
  std::vector<std::uint32_t> seen_in_;  // number of the collection that last saw a strip
  std::uint32_t current_ = 0;
  std::vector<Strip> members_, last_;
  std::size_t visits_ = 0;
};

constexpr double k_same_axis_deg = 0.3;
constexpr double k_bend_deg = 25.0;  // between slices of a bend, at most
constexpr double k_least_neighbour =
    0.5;  // of a slice's area: a straight pipe is longer than those it leads to
constexpr double k_least_share_full = 0.0005, k_least_share_partial = 0.005;  // of the surface

struct Axis {
  CurvedPatch best;
  std::size_t patches = 0, full_turns = 0;
  double area = 0.0;
};

std::vector<Axis> common_axes(std::vector<CurvedPatch> patches) {
  std::ranges::stable_sort(patches, std::greater{},
                           [](const CurvedPatch& patch) { return std::pair(patch.full_turn, patch.area); });
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
  std::ranges::stable_sort(axes, std::greater{},
                           [](const Axis& axis) { return std::pair(axis.full_turns > 0, axis.area); });
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

/// Slices of a bent pipe have axes, but no designer would name one.
void drop_slices_of_bends(const Strips& strips, std::span<const std::size_t> patch_of,
                          std::vector<CurvedPatch>& patches) {
  std::vector<char> is_slice(patches.size(), 0);
  for (Strip strip = 0; strip < patch_of.size(); ++strip) {
    for (const Strip next : strips.neighbours(strip)) {
      const std::size_t one = patch_of[strip], other = patch_of[next];
      if (one == other || std::max(one, other) >= patches.size()) continue;
      const double angle_deg = line_angle_deg(patches[one].axis, patches[other].axis);
      if (angle_deg > k_same_axis_deg && angle_deg < k_bend_deg &&
          patches[other].area >= k_least_neighbour * patches[one].area)
        is_slice[one] = 1;
    }
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    if (is_slice[k] == 0) patches[kept++] = patches[k];
  }
  patches.resize(kept);
}

}  // namespace

std::vector<CurvedPatch> curved_patches(const FacetGeometry& geometry, const Adjacency& adjacency) {
  const Strips strips = make_strips(geometry, adjacency);
  std::vector<Strip> seeds(strips.normals.size());
  std::iota(seeds.begin(), seeds.end(), Strip{0});
  std::ranges::stable_sort(seeds, std::greater{}, [&](Strip strip) { return strips.areas[strip]; });

  std::vector<CurvedPatch> patches;
  std::vector<std::size_t> patch_of(seeds.size(), seeds.size());
  PatchGrower grower(strips);
  for (const Strip seed : seeds) {
    if (grower.is_exhausted()) break;
    if (grower.is_taken(seed)) continue;
    const auto patch = grower.grow(seed);
    if (!patch) continue;
    for (const Strip strip : grower.last()) patch_of[strip] = patches.size();
    patches.push_back(*patch);
  }
  drop_slices_of_bends(strips, patch_of, patches);
  return patches;
}

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
