#include "sweep/direction_actions.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_pipeline.h>

#include "base/error.hpp"
#include "classify/classification.hpp"
#include "sweep/arena_threads.hpp"

namespace moldlight {

namespace {

/// Every direction at work holds a part of its own, split at the borders of its regions.
constexpr std::size_t k_most_facets_together = 2'000'000;
/// What is possible of a direction is kept for a plan of the whole.
constexpr std::size_t k_most_facets_kept = 1'000'000;
constexpr double k_weight_steps = 1e6;              // in 1, so that sums of decimals are decimals again
constexpr double k_trifle = 1e-3;                   // of the surface
constexpr std::size_t k_many = 5 * k_most_actions;  // undercuts, of which few samples say as much
constexpr double k_rough_margin = 1.0;              // a slide: by so much few samples may mistake a weight

}  // namespace

DirectionActions direction_actions(const ActionPlan& plan, const Classification& split) {
  DirectionActions found{.undercuts = undercut_totals(plan),
                         .totals = totals_of(plan, split.lateral_tolerance)};
  std::vector<double> released(plan.undercuts.size(), 1.0);  // shares of the undercuts
  for (std::size_t k = 0; k < plan.unreleased.size(); ++k) {
    const double area = plan.undercuts[plan.unreleased[k]].undercut.area;
    if (area > 0.0) released[plan.unreleased[k]] = 1.0 - std::min(1.0, plan.unreleased_areas[k] / area);
  }
  for (const SideAction& action : plan.actions) {
    found.travel = std::max(found.travel, action.travel);
    double counts =
        action.kind == ActionKind::insert ? std::min(1.0, action.area / (k_trifle * split.total_area)) : 1.0;
    if (!action.undercuts.empty())
      counts *= released[std::ranges::max(action.undercuts, {}, [&](std::size_t k) { return released[k]; })];
    if (&action - plan.actions.data() >= static_cast<std::ptrdiff_t>(k_most_actions)) {
      found.beyond += action.area;
      counts = 0.0;
    } else {
      found.formed_area += action.area;
    }
    found.in_vain += (1.0 - counts) * facts(action.kind).weight;
  }
  // By kinds, so that the same set has the same weight in whatever order it is found.
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind)
    found.weight +=
        static_cast<double>(found.totals.counts[kind]) * facts(static_cast<ActionKind>(kind)).weight;
  found.weight = std::round(found.weight * k_weight_steps) / k_weight_steps;
  return found;
}

bool ActionLimit::is_exceeded(const LeastActions& least, const UndercutTotals& undercuts) const {
  return (left <= left_band && least.weight + per_area * undercuts.area > most) ||
         least.beyond > left + left_band || (undercuts.count > 0 && undercuts.area > most_undercut) ||
         (undercuts.count > k_many && undercuts.area > most_of_many) ||
         (beside && undercuts.area >= beside->area && undercuts.count >= beside->count);
}

bool ActionLimit::is_far_exceeded(const DirectionActions& rough) const {
  // Few samples overrate what is left.
  const double more_left = rough.totals.unreleased_area + rough.beyond - left;
  return more_left > 2.0 * left_band ||
         (more_left > -left_band &&
          rough.weight - rough.in_vain + per_area * rough.formed_area > most + k_rough_margin);
}

struct DirectionActionFinder::Kept {
  Kept(const PartModel& model, const Query& query, const ActionSettings& settings, const SweepClock& clock)
      : direction(query.direction.unit()),
        progress(clock.until_cancelled()),
        split(classify_exact(model, query, Progress(&progress), true)),
        search(model, split, settings, progress) {}

  glm::dvec3 direction;
  Progress progress;
  Classification split;
  ActionSearch search;
};

DirectionActionFinder::DirectionActionFinder(const PartModel& model, const MethodSettings& method,
                                             const ActionSettings& settings, int jobs)
    : model_(model), method_(method), settings_(settings), jobs_(jobs), arena_(arena_threads(jobs)) {}

DirectionActionFinder::~DirectionActionFinder() = default;

void DirectionActionFinder::keep(std::unique_ptr<Kept> search) {
  const std::lock_guard lock(mutex_);
  if ((kept_.size() + 1) * model_.part.mesh.facets.size() <= k_most_facets_kept)
    kept_.push_back(std::move(search));
}

std::unique_ptr<DirectionActionFinder::Kept> DirectionActionFinder::take(const glm::dvec3& direction) {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::ranges::find(kept_, direction, [](const auto& search) { return search->direction; });
  if (found == kept_.end()) return nullptr;
  std::unique_ptr<Kept> search = std::move(*found);
  kept_.erase(found);
  return search;
}

std::optional<DirectionActions> DirectionActionFinder::find_one(const glm::dvec3& direction,
                                                                const ActionLimit& limit, PlanDetail detail,
                                                                const SweepClock& clock) {
  try {
    std::unique_ptr<Kept> search = take(direction);
    if (!search) search = std::make_unique<Kept>(model_, Query{direction, method_}, settings_, clock);
    const Classification& split = search->split;
    const bool limited = std::isfinite(limit.most) || std::isfinite(limit.most_undercut);
    if (limited || limit.roughly) {
      Undercuts undercuts = search->search.undercuts();
      const UndercutTotals totals = totals_of(undercuts);
      // Inserts for what is smaller may count for less than a slide.
      const double trifle = k_trifle * model_.geometry.total_area / facts(ActionKind::insert).weight;
      std::erase_if(undercuts.counted, [&](const Undercut& undercut) { return undercut.area < trifle; });
      const LeastActions least = least_actions(model_, *split.split, undercuts, direction, settings_);
      const DirectionActions given_up{
          .undercuts = totals, .weight = least.weight, .formed_area = totals.area, .given_up = true};
      if (limited && limit.is_exceeded(least, totals)) return given_up;
      const bool many = totals.count > k_many;
      if (limit.roughly && (limited || many)) {
        DirectionActions rough = direction_actions(
            find_actions(model_, split, settings_, search->progress, PlanDetail::rough, limit.most_left),
            split);
        if (limited && limit.is_far_exceeded(rough)) return given_up;
        if (many) return rough;
      }
    }
    DirectionActions actions = direction_actions(search->search.plan(detail, limit.most_left), split);
    actions.given_up = actions.totals.unreleased_area > limit.most_left;
    actions.whole = detail == PlanDetail::whole;
    if (detail == PlanDetail::rank && !actions.given_up) keep(std::move(search));
    return actions;
  } catch (const Cancelled&) {
    return std::nullopt;
  }
}

std::vector<std::optional<DirectionActions>> DirectionActionFinder::find(
    std::span<const glm::dvec3> directions, std::span<const ActionLimit> limits, const SweepClock& clock,
    PlanDetail detail, const std::function<void()>& done) {
  std::vector<std::optional<DirectionActions>> found(directions.size());
  const std::size_t facets = std::max<std::size_t>(1, model_.part.mesh.facets.size());
  const std::size_t together =
      std::clamp<std::size_t>(k_most_facets_together / facets, 1, static_cast<std::size_t>(jobs_));
  std::size_t next = 0;
  const auto begin = tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                                         [&](tbb::flow_control& control) -> std::size_t {
                                                           if (next == directions.size() || clock.stopped()) {
                                                             control.stop();
                                                             return 0;
                                                           }
                                                           return next++;
                                                         });
  const auto work =
      tbb::make_filter<std::size_t, void>(tbb::filter_mode::parallel, [&](const std::size_t& k) {
        // A thread that waits for parts of this direction begins no other one.
        tbb::this_task_arena::isolate([&] {
          found[k] = find_one(directions[k], limits.empty() ? ActionLimit{} : limits[k], detail, clock);
        });
        done();
      });
  arena_.execute([&] { tbb::parallel_pipeline(together, begin & work); });
  return found;
}

}  // namespace moldlight
