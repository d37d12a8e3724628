#include "actions/design_change.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "actions/chosen_action.hpp"
#include "actions/pull.hpp"
#include "base/error.hpp"
#include "mesh/union_outline.hpp"
#include "mold/map_frame.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_depth_samples = 200;   // of an undercut, for its depth
constexpr std::size_t k_deepest_corners = 64;  // the deepest ones beside them
constexpr std::size_t k_revolved = 48;         // samples of a thread or ring, each moved on its own
constexpr std::size_t k_lines = 120;           // along which material in the way is measured
constexpr double k_past_surface = 1e-6;        // behind a surface, unit frame
constexpr int k_most_crossings = 1024;         // of a line
constexpr double k_same_thickness = 1e-3;      // share by which one side must be thinner

/// Material along a line from a point of an undercut, unit frame.
struct InTheWay {
  double thickness = 0.0, end = 0.0;  // in all; how far the line's last exit is
  std::vector<FacetIndex> facets;
};

class Changes {
 public:
  Changes(const PartModel& model, const Classification& result, const ActionSettings& settings,
          const Progress& progress)
      : model_(model),
        split_(*result.split),
        settings_(with_thin_lifters(settings)),
        query_(exact_query(model, result.query())),
        frame_(map_frame(query_.direction)),
        axes_(part_axes(model, query_.direction)),
        pulls_(model, query_, axes_, settings, progress) {}

  [[nodiscard]] DesignChange of(const UndercutReport& noted, const SideAction* action) const {
    DesignChange change;
    if (action != nullptr && action->about) {
      change.depth = revolved_depth(noted.undercut, *action->about);
    } else {
      find_depth(noted.undercut, change);
    }
    change.window = window(noted);
    return change;
  }

 private:
  /// How far a point must move says what to change, whether a lifter has room or not.
  [[nodiscard]] static ActionSettings with_thin_lifters(ActionSettings settings) {
    settings.lifter_room_mm = settings.lifter_section_mm = 0.0;
    return settings;
  }

  void find_depth(const Undercut& undercut, DesignChange& change) const {
    const auto samples = sample_undercut(model_, split_, undercut, k_depth_samples);
    auto tried = own_pulls({model_, split_, axes_}, undercut, settings_);
    const auto fan = pull_fan(axes_);
    tried.insert(tried.end(), fan.begin(), fan.end());
    const std::vector<Pull> found = pulls_.find(samples, tried, ActionKind::lifter);
    const auto least = std::ranges::min_element(found, {}, &Pull::travel);
    if (least == found.end()) return;
    auto checked = samples;
    const auto corners = deepest_corners(model_, split_, undercut, least->direction, k_deepest_corners);
    checked.insert(checked.end(), corners.begin(), corners.end());
    const LifterWay way{least->direction, least->core_side ? query_.direction : -query_.direction,
                        least->travel};
    change.depth = clear_length(pulls_.release(), checked, way) * model_.frame.diagonal;
    change.direction = least->direction;
  }

  /// Each point moves away from the axis or towards it until it is clear.
  [[nodiscard]] std::optional<double> revolved_depth(const Undercut& undercut,
                                                     const Revolution& about) const {
    const auto samples = sample_undercut(model_, split_, undercut, k_revolved);
    const glm::dvec3 axis_at(model_.frame.to_unit(about.point));
    std::optional<double> least;
    for (const double sense : {1.0, -1.0}) {
      for (const glm::dvec3& side : {query_.direction, -query_.direction}) {
        double greatest = 0.0;
        const bool all = std::ranges::all_of(samples, [&](const UndercutSample& sample) {
          const glm::dvec3 from = glm::dvec3(sample.position) - axis_at;
          const glm::dvec3 radial = from - glm::dot(from, about.direction) * about.direction;
          const LifterWay way{sense * glm::normalize(radial), side, 0.0};
          FreeLengths lengths(pulls_.release(), std::span(&sample, 1), way.pull);
          const auto travel = pulls_.release().first_clear(lengths, way);
          greatest = std::max(greatest, travel.value_or(0.0));
          return travel.has_value() && greatest <= least.value_or(1.0);
        });
        if (all) least = std::min(least.value_or(1.0), greatest);
      }
    }
    return least ? std::optional(*least * model_.frame.diagonal) : std::nullopt;
  }

  [[nodiscard]] std::optional<UndercutWindow> window(const UndercutReport& noted) const {
    const auto loops = shadow(noted.undercut);
    if (!loops || loops->empty()) return std::nullopt;
    const auto samples = sample_undercut(model_, split_, noted.undercut, k_lines);
    const double core_mean = mean_thickness(samples, true), cavity_mean = mean_thickness(samples, false);
    const bool alike = std::abs(core_mean - cavity_mean) <= k_same_thickness * (core_mean + cavity_mean);
    const bool to_core = alike ? noted.core_side : core_mean < cavity_mean;
    UndercutWindow window = through(samples, to_core);
    const double square = model_.frame.diagonal * model_.frame.diagonal;
    window.area = enclosed_area(*loops) * square;
    const double height = glm::dot(window.place - model_.frame.center, query_.direction);
    for (const std::vector<glm::dvec2>& loop : *loops) {
      window.loops.emplace_back();
      for (const glm::dvec2& at : loop)
        window.loops.back().push_back(model_.frame.center + height * query_.direction +
                                      model_.frame.diagonal * (at.x * frame_.x + at.y * frame_.y));
    }
    return window;
  }

  /// What it covers, projected along the parting direction, without specks; unit frame.
  [[nodiscard]] std::optional<std::vector<std::vector<glm::dvec2>>> shadow(const Undercut& undercut) const {
    std::vector<glm::dvec2> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::map<VertexIndex, std::uint32_t> number;
    for (const std::uint32_t piece : undercut.pieces) {
      auto& corners = triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexIndex vertex = split_.pieces[piece].corners[k];
        const auto [at, added] = number.try_emplace(vertex, static_cast<std::uint32_t>(points.size()));
        corners[k] = at->second;
        if (!added) continue;
        const glm::dvec3 from = (split_.vertices[vertex] - model_.frame.center) / model_.frame.diagonal;
        points.emplace_back(glm::dot(from, frame_.x), glm::dot(from, frame_.y));
      }
    }
    auto loops = union_outline(points, triangles);
    if (loops) {
      const double speck = std::numbers::pi * query_.lateral * query_.lateral;
      std::erase_if(*loops, [&](const std::vector<glm::dvec2>& loop) {
        return std::abs(enclosed_area(std::span(&loop, 1))) <= speck;
      });
    }
    return loops;
  }

  [[nodiscard]] InTheWay in_the_way(const UndercutSample& sample, const glm::dvec3& side) const {
    InTheWay found;
    const bool wall = std::abs(glm::dot(sample.normal, query_.direction)) < k_past_surface;
    const glm::dvec3 from =
        glm::dvec3(sample.position) + (wall ? query_.lateral * sample.normal : glm::dvec3(0));
    int depth = !wall && glm::dot(sample.normal, side) < 0.0 ? 1 : 0;
    double gone = k_past_surface, entered = 0.0;
    for (int crossings = 0; crossings < k_most_crossings; ++crossings) {
      const auto hit = model_.rays().first_hit(glm::vec3(from + gone * side), glm::vec3(side), false);
      if (!hit) break;
      gone += static_cast<double>(hit->distance);
      found.facets.push_back(hit->facet);
      if (glm::dot(model_.geometry.normals[hit->facet], side) < 0.0) {
        if (depth++ == 0) entered = gone;
      } else if (--depth == 0) {
        found.thickness += gone - entered;
        found.end = gone;
      }
      gone += k_past_surface;
    }
    return found;
  }

  [[nodiscard]] double mean_thickness(std::span<const UndercutSample> samples, bool core_side) const {
    const glm::dvec3 side = core_side ? query_.direction : -query_.direction;
    double sum = 0.0;
    for (const UndercutSample& sample : samples) sum += in_the_way(sample, side).thickness;
    return sum / static_cast<double>(std::max<std::size_t>(1, samples.size()));
  }

  /// What a window on this side goes through.
  [[nodiscard]] UndercutWindow through(std::span<const UndercutSample> samples, bool core_side) const {
    constexpr std::size_t k_most = 8;
    const glm::dvec3 side = core_side ? query_.direction : -query_.direction;
    UndercutWindow window;
    window.core_side = core_side;
    std::map<FacetIndex, int> counts;
    double least = std::numeric_limits<double>::infinity(), greatest = 0.0;
    glm::dvec3 sum(0.0);
    std::size_t lines = 0;
    for (const UndercutSample& sample : samples) {
      const InTheWay found = in_the_way(sample, side);
      if (found.thickness <= 0.0) continue;
      for (const FacetIndex facet : found.facets) ++counts[facet];
      least = std::min(least, found.thickness);
      greatest = std::max(greatest, found.thickness);
      sum += glm::dvec3(sample.position) + found.end * side;
      ++lines;
    }
    const double diagonal = model_.frame.diagonal;
    window.place =
        model_.frame.center + diagonal * sum / static_cast<double>(std::max<std::size_t>(1, lines));
    window.least_thickness = lines > 0 ? least * diagonal : 0.0;
    window.thickness = greatest * diagonal;
    std::vector<std::pair<FacetIndex, int>> order(counts.begin(), counts.end());
    std::ranges::stable_sort(order, std::greater(), [](const auto& entry) { return entry.second; });
    for (std::size_t i = 0; i < std::min(order.size(), k_most); ++i) window.through.push_back(order[i].first);
    return window;
  }

  const PartModel& model_;
  const SplitMesh& split_;
  ActionSettings settings_;
  ExactQuery query_;
  MapFrame frame_;
  PartAxes axes_;
  PullFinder pulls_;
};

}  // namespace

std::vector<DesignChange> find_changes(const PartModel& model, const Classification& result,
                                       const ActionSettings& settings, const ActionPlan& plan,
                                       const Progress& progress) {
  progress.report("looking for changes of the part", 0.9);
  const Changes changes(model, result, settings, progress);
  std::vector<DesignChange> found(plan.undercuts.size());
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t k) {
    if (!progress.cancelled()) found[k] = changes.of(plan.undercuts[k], action_of(plan, k));
  });
  if (progress.cancelled()) throw Cancelled();
  return found;
}

}  // namespace moldlight
