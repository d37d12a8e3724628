// Pulls for undercuts that none frees whole.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "actions/pull.hpp"

namespace moldlight {

namespace {

constexpr int k_most_parts = 3;                // of an undercut that nothing releases whole
constexpr double k_least_part = 0.05;          // of its area: less is not worth an action
constexpr double k_least_split = 0.15;         // likewise, of one beside others
constexpr double k_worth_lifting = 1.1;        // what a lifter must free of it, of what a slide does
constexpr double k_worth_leaving_axis = 1.02;  // what another slide must, of what one along an axis does

}  // namespace

std::vector<FreedPart> PullFinder::split(std::span<const UndercutSample> samples,
                                         std::span<const PullCandidate> tried,
                                         std::optional<ActionKind> only) const {
  if (!only || only == ActionKind::slide) {
    std::vector<FreedPart> slides = opposite_slides(samples, tried);
    if (!slides.empty()) return slides;
  }
  const bool lifters = !only || only == ActionKind::lifter;
  std::vector<FreedPart> parts;
  std::vector<UndercutSample> rest(samples.begin(), samples.end());
  const double whole = area_of(samples);
  for (int round = 0; round < k_most_parts; ++round) {
    double most = 0.0;
    std::optional<Pull> found = most_freeing(rest, tried, only, most);
    if (const auto lifter = lifters ? most_clearing(rest, tried, k_worth_lifting * most) : std::nullopt)
      found = lifter;
    if (!found) break;
    Pull& best = *found;
    const bool lifts = best.kind == ActionKind::lifter;
    const LifterWay way{best.direction, best.core_side ? direction_ : -direction_, best.travel};
    FreedPart part;
    std::erase_if(rest, [&](const UndercutSample& sample) {
      const bool freed = lifts ? release_.clears(sample, way, lifter_room_)
                               : release_.free_length(sample, best.direction) == k_never;
      if (freed) part.samples.push_back(sample);
      return freed;
    });
    if (area_of(part.samples) < k_least_split * whole) {
      rest.insert(rest.end(), part.samples.begin(), part.samples.end());
      break;
    }
    if (lifts) {
      const double longest = best.travel;
      FreeLengths lengths(release_, part.samples, best.direction);
      const auto least = release_.first_clear(lengths, {best.direction, way.side, least_travel_});
      best.travel = std::min(least.value_or(longest), longest);
      set_lack(lengths, best);
    } else {
      best.interval = release_.free_turn(part.samples, best.direction, direction_, k_compared_turn_deg);
      estimate_travel(part.samples, best);
    }
    part.pulls = {best};
    if (!lifts) {
      // As it was tried, if the middle of what is free will not do.
      part.pulls.push_back(best);
      part.pulls.back().for_sharing = true;
    }
    parts.push_back(std::move(part));
  }
  if (!parts.empty() && area_of(rest) > k_blocked_share * whole)
    parts.push_back({.samples = rest, .pulls = lifters ? find_lifters(rest, tried) : std::vector<Pull>()});
  return parts;
}

std::vector<FreedPart> PullFinder::opposite_slides(std::span<const UndercutSample> samples,
                                                   std::span<const PullCandidate> tried) const {
  const double whole = area_of(samples);
  std::vector<PullCandidate> lines;
  if (axes_.by_walls) lines = {{axes_.x, PullSource::part}, {axes_.y, PullSource::part}};
  lines.insert(lines.end(), tried.begin(), tried.end());
  for (const PullCandidate& candidate : lines) {
    if (std::abs(elevation_deg(candidate.direction, direction_)) > k_same_elevation_deg) continue;
    std::array<FreedPart, 2> parts;
    double blocked = 0.0;
    std::optional<double> middle;  // of the part, once that is asked for
    const auto is_before_middle = [&](const UndercutSample& sample) {
      if (!middle) middle = release_.middle(candidate.direction);
      return glm::dot(glm::dvec3(sample.position), candidate.direction) > *middle;
    };
    for (const UndercutSample& sample : samples) {
      std::array<bool, 2> free{};
      for (const std::size_t k : {0, 1})
        free[k] =
            release_.free_length(sample, k == 0 ? candidate.direction : -candidate.direction) == k_never;
      if (!free[0] && !free[1] && (blocked += sample.area) > k_blocked_share * whole) break;
      // What both free goes with the one that it opens towards, upright walls with the shorter way.
      const double draft = glm::dot(sample.normal, candidate.direction);
      const bool ahead = std::abs(draft) > k_upright ? draft > 0.0 : is_before_middle(sample);
      parts[free[0] && (ahead || !free[1]) ? 0 : 1].samples.push_back(sample);
    }
    if (blocked > k_blocked_share * whole ||
        std::ranges::any_of(parts, [](const FreedPart& part) { return part.samples.empty(); }))
      continue;
    for (const std::size_t k : {0, 1}) {
      Pull pull{.kind = ActionKind::slide,
                .direction = k == 0 ? candidate.direction : -candidate.direction,
                .source = candidate.source,
                .kept = true};
      pull.interval = release_.free_turn(parts[k].samples, pull.direction, direction_, k_compared_turn_deg);
      estimate_travel(parts[k].samples, pull);
      parts[k].pulls = {pull};
    }
    return {std::move(parts[0]), std::move(parts[1])};
  }
  return {};
}

std::optional<Pull> PullFinder::most_freeing(std::span<const UndercutSample> samples,
                                             std::span<const PullCandidate> tried,
                                             std::optional<ActionKind> only, double& most) const {
  std::vector<PullCandidate> in_order(tried.begin(), tried.end());
  std::stable_partition(in_order.begin(), in_order.end(),
                        [&](const auto& one) { return is_axis(one.direction); });
  std::optional<Pull> best;
  for (const PullCandidate& candidate : in_order) {
    const double angle_deg = std::abs(elevation_deg(candidate.direction, direction_));
    const ActionKind kind = angle_deg <= settings_.slide_angle_deg ? ActionKind::slide : ActionKind::inclined;
    if (angle_deg > settings_.incline_deg || (only && only != kind)) continue;
    // Of equal ones that which comes first: it is better meant. An axis of the part gives way to what frees
    // more than a hair.
    const double least = (best && is_axis(best->direction) ? k_worth_leaving_axis : 1.0 + 1e-9) * most;
    const double freed = release_.free_area(samples, candidate.direction, k_never, least);
    if (freed <= least) continue;
    most = freed;
    best = {.kind = kind, .direction = candidate.direction, .source = PullSource::exact};
  }
  return best;
}

std::optional<glm::dvec3> PullFinder::nearly_freeing(std::span<const UndercutSample> samples,
                                                     std::span<const PullCandidate> tried) const {
  constexpr double k_nearly_all = 0.8;
  const double whole = area_of(samples), least = k_nearly_all * whole;
  const auto frees = [&](const glm::dvec3& pull) {
    if (release_.free_area(samples, pull, k_never, least) <= least) return false;
    double left = 0.0;
    return std::ranges::all_of(samples, [&](const UndercutSample& sample) {
      if (release_.free_length(sample, pull) != k_never &&
          !release_.is_nearly_free(sample, pull, least_travel_))
        left += sample.area;
      return left <= k_blocked_share * whole;
    });
  };
  std::vector<PullCandidate> sides;
  for (const glm::dvec3& axis : {axes_.x, -axes_.x, axes_.y, -axes_.y})
    sides.push_back({axis, PullSource::part});
  sides.insert(sides.end(), tried.begin(), tried.end());
  std::optional<Pull> best;
  for (const PullCandidate& candidate : sides) {
    if (std::abs(elevation_deg(candidate.direction, direction_)) > settings_.slide_angle_deg ||
        (best && is_axis(best->direction) && !is_axis(candidate.direction)) || !frees(candidate.direction))
      continue;
    Pull pull{.direction = candidate.direction, .source = candidate.source};
    estimate_travel(samples, pull);
    if (!best || pull_cost(pull, settings_.prices) < pull_cost(*best, settings_.prices)) best = pull;
  }
  return best ? std::optional(best->direction) : std::nullopt;
}

std::vector<FreedPart> PullFinder::find_inserts(std::span<const UndercutSample> samples,
                                                std::span<const PullCandidate> tried,
                                                double whole_area) const {
  std::vector<FreedPart> parts;
  std::vector<UndercutSample> rest(samples.begin(), samples.end());
  for (int round = 0; round < k_most_parts && !rest.empty(); ++round) {
    const PullCandidate* best = nullptr;
    double most = k_least_part * whole_area;
    for (const PullCandidate& candidate : tried) {
      const double freed = release_.free_area(rest, candidate.direction, k_never, most);
      if (freed <= most * (1.0 + 1e-9)) continue;
      most = freed;
      best = &candidate;
    }
    if (best == nullptr) break;
    Pull pull{.kind = ActionKind::insert, .direction = best->direction, .source = best->source};
    FreedPart part;
    double least = k_never;
    std::erase_if(rest, [&](const UndercutSample& sample) {
      const bool freed = release_.free_length(sample, pull.direction) == k_never &&
                         !release_.covered(sample, pull.direction);
      if (freed) {
        part.samples.push_back(sample);
        least = std::min(least, glm::dot(glm::dvec3(sample.position), pull.direction));
      }
      return freed;
    });
    if (area_of(part.samples) < k_least_part * whole_area) {
      rest.insert(rest.end(), part.samples.begin(), part.samples.end());
      break;
    }
    pull.travel = release_.reach(pull.direction) - least;
    part.pulls = {pull};
    parts.push_back(std::move(part));
    if (area_of(rest) <= k_blocked_share * whole_area) rest.clear();
  }
  if (!parts.empty() && !rest.empty()) parts.push_back({.samples = rest, .pulls = {}});
  return parts;
}

}  // namespace moldlight
