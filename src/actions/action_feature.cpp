#include "actions/action_feature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "classify/map_comparison.hpp"
#include "mold/round_wall.hpp"

namespace moldlight {

namespace {

enum class Shape : std::uint8_t { thread, ring, hole, slot, window, vent, hook, groove, recess };
constexpr std::array<std::string_view, 9> k_shape_names = {"thread", "ring", "hole",   "slot",  "window",
                                                           "vent",   "hook", "groove", "recess"};

constexpr std::size_t k_shape_samples = 32;  // of an undercut
constexpr double k_most_of = 0.8;            // of its area
constexpr double k_same_size = 0.05;         // between vents of a row
constexpr std::size_t k_least_vents = 3;
constexpr double k_one_middle = 0.25;  // of a hole's height, between the middles of its sides
constexpr double k_least_bend = 0.1;   // of the normals of two facets of a hole
constexpr double k_slot_ratio = 2.5;   // of length to width, at least

/// Shares of the diagonal.
struct Feature {
  Shape shape = Shape::recess;
  double wide = 0.0, high = 0.0;          // across the pull: level, and upright
  std::optional<glm::dvec3> middle = {};  // of a hole, across the pull
  double from = 0.0, to = 0.0;            // along it
};

class FeatureFinder {
 public:
  FeatureFinder(const FeatureContext& context, const SideAction& action)
      : context_(context), action_(action) {
    const glm::dvec3 level = glm::cross(context.release.direction(), action.direction);
    // An insert may leave along the parting direction.
    level_ = glm::length(level) > 1e-6 ? glm::normalize(level) : glm::normalize(any_across());
    upright_ = glm::cross(action.direction, level_);
  }

  [[nodiscard]] Feature feature_of(const Undercut& undercut) const {
    const auto samples = sample_undercut(context_.model, context_.split, undercut, k_shape_samples);
    Feature feature{.wide = extent(samples, level_), .high = extent(samples, upright_)};
    const auto [from, to] = std::ranges::minmax(samples, {}, [&](const UndercutSample& sample) {
      return glm::dot(glm::dvec3(sample.position), action_.direction);
    });
    feature.from = glm::dot(glm::dvec3(from.position), action_.direction);
    feature.to = glm::dot(glm::dvec3(to.position), action_.direction);
    const double longer = std::max(feature.wide, feature.high),
                 shorter = std::min(feature.wide, feature.high);
    const auto leaves = [&](const glm::dvec3& way, double length) {
      return context_.release.free_area(samples, way, length) >= k_most_of * undercut.area;
    };
    const std::vector<FacetIndex> round = round_facets(undercut);
    if (!round.empty()) {
      feature.shape = Shape::hole;
      feature.middle = middle_of(round);
    } else if (leaves(action_.direction, k_never) && leaves(-action_.direction, k_never)) {
      feature.shape = longer > k_slot_ratio * shorter ? Shape::slot : Shape::window;
    } else if (leaves(level_, feature.wide) && leaves(-level_, feature.wide)) {
      feature.shape = action_.kind == ActionKind::lifter ? Shape::hook : Shape::groove;
    }
    return feature;
  }

 private:
  [[nodiscard]] glm::dvec3 any_across() const {
    const glm::dvec3& pull = action_.direction;
    return glm::cross(pull, std::abs(pull.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
  }

  [[nodiscard]] static double extent(std::span<const UndercutSample> samples, const glm::dvec3& along) {
    double least = k_never, greatest = -k_never;
    for (const UndercutSample& sample : samples) {
      const double at = glm::dot(glm::dvec3(sample.position), along);
      least = std::min(least, at);
      greatest = std::max(greatest, at);
    }
    return std::max(0.0, greatest - least);
  }

  /// Its larger facets, the largest first, if most of them are of round walls along the pull.
  [[nodiscard]] std::vector<FacetIndex> round_facets(const Undercut& undercut) const {
    constexpr std::size_t k_asked = 12;
    constexpr double k_along = 0.996;  // cosine
    std::map<FacetIndex, double> areas;
    for (const std::uint32_t piece : undercut.pieces)
      areas[context_.split.pieces[piece].facet] += piece_area(context_.split, context_.split.pieces[piece]);
    std::vector<std::pair<double, FacetIndex>> order;
    for (const auto& [facet, area] : areas) order.emplace_back(area, facet);
    std::ranges::stable_sort(order, std::greater(), [](const auto& each) { return each.first; });
    order.resize(std::min(order.size(), k_asked));
    double all = 0.0, round = 0.0;
    std::vector<FacetIndex> found;
    for (const auto& [area, facet] : order) {
      all += area;
      const auto wall = round_wall(context_.model.geometry, context_.model.adjacency, facet);
      if (!wall || std::abs(glm::dot(wall->axis, action_.direction)) <= k_along) continue;
      round += area;
      found.push_back(facet);
    }
    return round > k_most_of * all ? found : std::vector<FacetIndex>{};
  }

  [[nodiscard]] glm::dvec3 across(const glm::dvec3& at) const {
    return at - glm::dot(at, action_.direction) * action_.direction;
  }
  /// Where the normals of two of its facets meet that face in different ways.
  [[nodiscard]] std::optional<glm::dvec3> middle_of(const std::vector<FacetIndex>& facets) const {
    const FacetGeometry& geometry = context_.model.geometry;
    const auto& its = geometry.normals[facets.front()];
    const FacetIndex other = *std::ranges::min_element(
        facets, {}, [&](FacetIndex facet) { return glm::dot(geometry.normals[facet], its); });
    const auto place = [&](FacetIndex facet) { return across(context_.model.part.mesh.middle(facet)); };
    const glm::dvec3 turned = across(its) - across(geometry.normals[other]);
    const double squared = glm::dot(turned, turned);
    if (squared < k_least_bend * k_least_bend) return std::nullopt;
    const double radius = glm::dot(place(other) - place(facets.front()), turned) / squared;
    return place(facets.front()) + radius * across(its);
  }

  const FeatureContext& context_;
  const SideAction& action_;
  glm::dvec3 level_{1, 0, 0}, upright_{0, 0, 1};  // unit, across the pull
};

bool are_alike(const Feature& one, const Feature& other) {
  const auto same = [](double a, double b) { return std::abs(a - b) <= k_same_size * std::max(a, b); };
  return one.shape == other.shape && same(one.wide, other.wide) && same(one.high, other.high);
}

/// Whether they are sides of one hole through whose middle one sees.
bool are_one_hole(const Feature& one, const Feature& other, double diagonal) {
  return one.middle && other.middle && one.from < other.to && other.from < one.to &&
         glm::distance(*one.middle, *other.middle) < k_one_middle * diagonal * one.high;
}
void leave_one_a_hole(double diagonal, std::vector<Feature>& found) {
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto first = found.begin() + static_cast<std::ptrdiff_t>(k) + 1;
    found.erase(std::remove_if(
                    first, found.end(),
                    [&, one = found[k]](const Feature& other) { return are_one_hole(one, other, diagonal); }),
                found.end());
  }
}

}  // namespace

std::string feature_text(const FeatureContext& context, const ActionPlan& plan, const SideAction& action) {
  std::map<Shape, std::size_t> counts;
  if (action.kind == ActionKind::unscrew || action.kind == ActionKind::strip) {
    counts[action.kind == ActionKind::strip ? Shape::ring : Shape::thread] = 1;
  } else {
    const FeatureFinder finder(context, action);
    std::vector<Feature> found;
    for (const std::size_t undercut : action.undercuts)
      found.push_back(finder.feature_of(plan.undercuts[undercut].undercut));
    leave_one_a_hole(context.model.frame.diagonal, found);
    for (const Feature& feature : found) {
      const bool opening = feature.shape == Shape::slot || feature.shape == Shape::window;
      const auto alike = static_cast<std::size_t>(
          std::ranges::count_if(found, [&](const Feature& other) { return are_alike(feature, other); }));
      ++counts[opening && alike >= k_least_vents ? Shape::vent : feature.shape];
    }
  }
  std::string text;
  for (const auto& [shape, count] : counts) {
    const std::string_view name = k_shape_names[static_cast<std::size_t>(shape)];
    if (counts.size() == 1 && count == 1) return std::string(name);
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, name,
                        count == 1               ? ""
                        : shape == Shape::recess ? "es"
                                                 : "s");
  }
  return text;
}

}  // namespace moldlight
