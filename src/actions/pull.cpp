#include "actions/pull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr std::size_t k_quick_samples = 24;   // which tell soon that a lifter is hopeless
constexpr double k_coarse_step = 1.0 / 64.0;  // of estimated travels, share of the diagonal
constexpr double k_compared_turn_deg = 0.01;  // of turns that are compared; what is chosen is found anew
constexpr double k_same_elevation_deg = 0.01;
constexpr std::size_t k_lifters = 3;     // of an undercut, with room and without
constexpr std::size_t k_most_tries = 8;  // at each
constexpr int k_most_parts = 3;          // of an undercut that nothing releases whole
constexpr double k_least_part = 0.05;    // of its area: less is not worth an action
constexpr double k_narrow_cost = 5e-4;   // of a pull that may not turn at all, beside the weights
constexpr double k_travel_cost = 1e-3;   // of the diagonal, beside the weights
constexpr double k_wish_gain = 0.05;     // of a direction of the user's own, off the weights
constexpr double k_no_room_cost = 1.5;   // of a lifter without room: dearer than any pull that has
constexpr double k_worth_lifting = 1.1;  // what a lifter must free of it, of what a slide does

double area_of(std::span<const UndercutSample> samples) {
  double area = 0.0;
  for (const UndercutSample& sample : samples) area += sample.area;
  return area;
}

/// What a split of an undercut comes to.
struct Worth {
  double left = 1.0;  // share that no pull frees: for an insert, which may leave some of it
  double cost = 0.0;  // of the cheapest pull for each part
};
Worth worth_of(std::span<const FreedPart> parts) {
  Worth worth;
  double whole = 0.0, left = 0.0;
  for (const FreedPart& part : parts) {
    double least = k_never;
    for (const Pull& pull : part.pulls) least = std::min(least, pull_cost(pull));
    const double area = area_of(part.samples);
    whole += area;
    left += part.pulls.empty() ? area : 0.0;
    worth.cost += part.pulls.empty() ? facts(ActionKind::insert).weight : least;
  }
  if (whole > 0.0) worth.left = left / whole;
  return worth;
}
/// Frees more by what is worth an action, or as much for less.
bool is_better(const Worth& one, const Worth& other) {
  if (std::abs(one.left - other.left) > k_least_part) return one.left < other.left;
  return one.cost < other.cost;
}

std::span<const UndercutSample> few_of(std::span<const UndercutSample> samples) {
  return samples.first(std::min(samples.size(), k_quick_samples));
}

/// From one to the other about the parting direction, (-180, 180].
double turn_between(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& direction) {
  const glm::dvec3 a = from - glm::dot(from, direction) * direction;
  const glm::dvec3 b = to - glm::dot(to, direction) * direction;
  return glm::degrees(std::atan2(glm::dot(glm::cross(a, b), direction), glm::dot(a, b)));
}

}  // namespace

double pull_cost(const Pull& pull) {
  const double width_deg = pull.interval.to_deg - pull.interval.from_deg;
  const double gain = pull.source == PullSource::wish ? k_wish_gain : 0.0;
  return facts(pull.kind).weight - gain + (pull.has_room ? 0.0 : k_no_room_cost) +
         k_travel_cost * pull.travel + k_narrow_cost / (1.0 + width_deg);
}

std::vector<Pull> PullFinder::find(std::span<const UndercutSample> samples,
                                   std::span<const PullCandidate> tried,
                                   std::optional<ActionKind> only) const {
  struct Band {
    ActionKind kind;
    double above_deg, up_to_deg;
  };
  std::vector<Pull> pulls;
  for (const auto& [kind, above_deg, up_to_deg] :
       {Band{ActionKind::slide, -1.0, std::min(k_same_elevation_deg, settings_.slide_angle_deg)},
        Band{ActionKind::slide, k_same_elevation_deg, settings_.slide_angle_deg},
        Band{ActionKind::inclined, settings_.slide_angle_deg, settings_.incline_deg}}) {
    if (only && only != kind) continue;
    for (const PullCandidate& candidate : tried) {
      const double angle_deg = std::abs(elevation_deg(candidate.direction, direction_));
      if (angle_deg <= above_deg || angle_deg > up_to_deg || is_known(pulls, candidate.direction)) continue;
      if (!release_.releases(samples, candidate.direction, k_never)) continue;
      pulls.push_back(in_the_middle(samples, candidate, kind, k_compared_turn_deg, tried));
      estimate_travel(samples, pulls.back());
      // What the part's shape says may suit a neighbour better than the middle.
      if (candidate.source == PullSource::even ||
          glm::dot(pulls.back().direction, candidate.direction) > 1.0 - 1e-12)
        continue;
      Pull own = pulls.back();
      const double turn_deg = turn_between(own.direction, candidate.direction, direction_);
      own.direction = candidate.direction;
      own.source = candidate.source;
      own.interval = {own.interval.from_deg - turn_deg, own.interval.to_deg - turn_deg};
      own.for_sharing = true;
      pulls.push_back(own);
    }
    if (!pulls.empty()) return pulls;
  }
  return !only || only == ActionKind::lifter ? find_lifters(samples, tried) : std::vector<Pull>();
}

/// Whether a pull that was found reaches it by turning about the parting direction.
bool PullFinder::is_known(const std::vector<Pull>& pulls, const glm::dvec3& pull) const {
  return std::ranges::any_of(pulls, [&](const Pull& known) {
    const double lean_deg = elevation_deg(known.direction, direction_) - elevation_deg(pull, direction_);
    if (std::abs(lean_deg) > k_same_elevation_deg) return false;
    const double angle_deg = turn_between(known.direction, pull, direction_);
    return angle_deg >= known.interval.from_deg - 1e-6 && angle_deg <= known.interval.to_deg + 1e-6;
  });
}

Pull PullFinder::in_the_middle(std::span<const UndercutSample> samples, const PullCandidate& candidate,
                               ActionKind kind, double resolved_deg,
                               std::span<const PullCandidate> others) const {
  constexpr double k_wide_deg = 10.0, k_least_margin = 0.15;  // of the width
  Pull pull{.kind = kind, .direction = candidate.direction, .source = candidate.source};
  pull.interval = release_.free_turn(samples, pull.direction, direction_, resolved_deg);
  const auto [from_deg, to_deg] = pull.interval;
  const double middle = pull.interval.middle_deg(), half = 0.5 * (to_deg - from_deg);
  if (pull.source == PullSource::wish) return pull;
  const bool central = std::abs(middle) < 0.5 * half;
  if (pull.source == PullSource::exact && central) return pull;
  if (2.0 * half > k_wide_deg) {
    const double lean_deg = elevation_deg(pull.direction, direction_), from = from_deg, to = to_deg;
    const PullCandidate* best = nullptr;
    double best_deg = 0.0, margin_deg = 2.0 * k_least_margin * half;
    const auto look_at = [&](const PullCandidate& other) {
      if (other.source == PullSource::even ||
          std::abs(elevation_deg(other.direction, direction_) - lean_deg) > k_same_elevation_deg)
        return;
      const double turn_deg = turn_between(pull.direction, other.direction, direction_);
      const double its_deg = std::min(to - turn_deg, turn_deg - from);
      if (its_deg <= margin_deg) return;
      best = &other;
      best_deg = turn_deg;
      margin_deg = its_deg * (1.0 + 1e-9);
    };
    look_at(candidate);
    for (const PullCandidate& other : others) look_at(other);
    if (best != nullptr) {
      pull.direction = best->direction;
      pull.source = best->source;
      pull.interval = {from - best_deg, to - best_deg};
      return pull;
    }
  }
  const glm::dvec3 centred = turned_about(pull.direction, direction_, middle);
  if (!release_.releases(samples, centred, k_never)) return pull;
  pull.direction = centred;
  pull.source = PullSource::even;
  pull.interval = {-half, half};
  return pull;
}

void PullFinder::set_travel(std::span<const UndercutSample> samples, double step, Pull& pull) const {
  const double core = release_.clear_beyond(samples, pull.direction, direction_, step);
  const double cavity = release_.clear_beyond(samples, pull.direction, -direction_, step);
  pull.core_side = core <= cavity;
  pull.travel = std::min(core, cavity);
}

void PullFinder::estimate_travel(std::span<const UndercutSample> samples, Pull& pull) const {
  set_travel(few_of(samples), k_coarse_step, pull);
}

std::vector<Pull> PullFinder::find_lifters(std::span<const UndercutSample> samples,
                                           std::span<const PullCandidate> tried) const {
  const auto side = [&](bool core_side) { return core_side ? direction_ : -direction_; };
  std::vector<Pull> found;
  for (const PullCandidate& candidate : tried) {
    if (std::abs(elevation_deg(candidate.direction, direction_)) > k_same_elevation_deg) continue;
    for (const bool core_side : {true, false}) {
      const auto travel = release_.first_clear(few_of(samples), candidate.direction, side(core_side), 1.0);
      if (!travel) continue;
      found.push_back({.kind = ActionKind::lifter,
                       .direction = candidate.direction,
                       .source = candidate.source,
                       .travel = *travel,
                       .core_side = core_side});
      set_room(few_of(samples), found.back());
    }
  }
  std::ranges::stable_sort(
      found, {}, [](const Pull& pull) { return std::pair(pull.source != PullSource::wish, pull.travel); });
  std::vector<Pull> pulls;
  for (const bool roomy : {true, false}) {
    std::size_t number = 0, tries = 0;
    for (Pull pull : found) {
      // Few samples may say that there is room where all of them do not.
      if (pull.has_room != roomy || number == k_lifters || tries == k_most_tries) continue;
      ++tries;
      const auto travel = release_.first_clear(samples, pull.direction, side(pull.core_side), 1.0);
      if (!travel) continue;
      pull.travel = *travel;
      set_room(samples, pull);
      number += pull.has_room == roomy ? 1 : 0;
      pulls.push_back(pull);
    }
  }
  return pulls;
}

void PullFinder::set_room(std::span<const UndercutSample> samples, Pull& lifter) const {
  lifter.has_room = release_.releases(samples, lifter.direction, lifter.travel + lifter_room_);
}

std::optional<Pull> PullFinder::most_clearing(std::span<const UndercutSample> samples,
                                              std::span<const PullCandidate> tried, double least,
                                              double room) const {
  constexpr double k_first = 1.0 / 512.0, k_growth = 1.2;
  constexpr std::size_t k_every = 3;  // of the fan
  std::optional<Pull> best;
  const auto few = few_of(samples);
  double most = least * area_of(few) / area_of(samples);
  for (std::size_t k = 0; k < tried.size(); ++k) {
    const PullCandidate& candidate = tried[k];
    if (std::abs(elevation_deg(candidate.direction, direction_)) > k_same_elevation_deg) continue;
    if (candidate.source == PullSource::even && k % k_every != 0) continue;
    for (const bool core_side : {true, false}) {
      const glm::dvec3 side = core_side ? direction_ : -direction_;
      for (double length = k_first; length < 1.0; length *= k_growth) {
        if (release_.free_area(few, candidate.direction, length + room) <= most * (1.0 + 1e-9)) break;
        const double cleared = release_.cleared_area(few, {candidate.direction, side, length}, room);
        if (cleared <= most * (1.0 + 1e-9)) continue;
        most = cleared;
        best = Pull{.kind = ActionKind::lifter,
                    .direction = candidate.direction,
                    .source = candidate.source,
                    .travel = length,
                    .core_side = core_side,
                    .has_room = room > 0.0 || lifter_room_ <= 0.0};
      }
    }
  }
  return best;
}

std::vector<Pull> PullFinder::turned(std::span<const UndercutSample> samples,
                                     std::span<const Pull> pulls) const {
  constexpr double k_wide_deg = 10.0;
  std::vector<Pull> found;
  for (const Pull& pull : pulls) {
    if (!is_slide(pull.kind)) continue;
    Pull other = pull;
    other.kept = true;
    other.for_sharing = false;
    if (pull.for_sharing) found.push_back(other);
    const auto [from_deg, to_deg] = pull.interval;
    if (pull.for_sharing || to_deg - from_deg < k_wide_deg) continue;
    other.source = PullSource::even;
    for (const double share : {0.4, 0.7, 0.95}) {
      for (const double turn_deg : {share * from_deg, share * to_deg}) {
        other.direction = turned_about(pull.direction, direction_, turn_deg);
        other.interval = {from_deg - turn_deg, to_deg - turn_deg};
        estimate_travel(samples, other);
        found.push_back(other);
      }
    }
  }
  return found;
}

std::vector<FreedPart> PullFinder::split(std::span<const UndercutSample> samples,
                                         std::span<const PullCandidate> tried,
                                         std::optional<ActionKind> only) const {
  const bool lifters = !only || only == ActionKind::lifter;
  std::vector<FreedPart> roomy = split_with(samples, tried, only, lifter_room_);
  const auto is_poor = [](const FreedPart& part) {
    return part.pulls.empty() || !part.pulls.front().has_room;
  };
  if (!lifters || lifter_room_ <= 0.0 || (!roomy.empty() && std::ranges::none_of(roomy, is_poor)))
    return roomy;
  // Lifters without room may free more, or ask for less beside them.
  std::vector<FreedPart> crowded = split_with(samples, tried, only, 0.0);
  return is_better(worth_of(crowded), worth_of(roomy)) ? crowded : roomy;
}

std::vector<FreedPart> PullFinder::split_with(std::span<const UndercutSample> samples,
                                              std::span<const PullCandidate> tried,
                                              std::optional<ActionKind> only, double room) const {
  const bool lifters = !only || only == ActionKind::lifter;
  std::vector<FreedPart> parts;
  std::vector<UndercutSample> rest(samples.begin(), samples.end());
  const double whole = area_of(samples);
  for (int round = 0; round < k_most_parts; ++round) {
    double most = 0.0;
    std::optional<Pull> found = most_freeing(rest, tried, only, most);
    if (const auto lifter = lifters ? most_clearing(rest, tried, k_worth_lifting * most, room) : std::nullopt)
      found = lifter;
    if (!found) break;
    Pull& best = *found;
    const bool lifts = best.kind == ActionKind::lifter;
    const LifterWay way{best.direction, best.core_side ? direction_ : -direction_, best.travel};
    FreedPart part;
    std::erase_if(rest, [&](const UndercutSample& sample) {
      const bool freed = lifts ? release_.clears(sample, way, room)
                               : release_.free_length(sample, best.direction) == k_never;
      if (freed) part.samples.push_back(sample);
      return freed;
    });
    if (area_of(part.samples) < k_least_part * whole) {
      rest.insert(rest.end(), part.samples.begin(), part.samples.end());
      break;
    }
    if (lifts) {
      best.travel =
          release_.first_clear(part.samples, best.direction, way.side, best.travel).value_or(best.travel);
      set_room(part.samples, best);
    } else {
      best.interval = release_.free_turn(part.samples, best.direction, direction_, k_compared_turn_deg);
      estimate_travel(part.samples, best);
    }
    part.pulls = {best};
    parts.push_back(std::move(part));
  }
  if (!parts.empty() && area_of(rest) > k_blocked_share * whole)
    parts.push_back({.samples = rest, .pulls = lifters ? find_lifters(rest, tried) : std::vector<Pull>()});
  return parts;
}

std::optional<Pull> PullFinder::most_freeing(std::span<const UndercutSample> samples,
                                             std::span<const PullCandidate> tried,
                                             std::optional<ActionKind> only, double& most) const {
  std::optional<Pull> best;
  for (const PullCandidate& candidate : tried) {
    const double angle_deg = std::abs(elevation_deg(candidate.direction, direction_));
    const ActionKind kind = angle_deg <= settings_.slide_angle_deg ? ActionKind::slide : ActionKind::inclined;
    if (angle_deg > settings_.incline_deg || (only && only != kind)) continue;
    // Of equal ones that which comes first: it is better meant.
    const double freed = release_.free_area(samples, candidate.direction, k_never);
    if (freed <= most * (1.0 + 1e-9)) continue;
    most = freed;
    best = {.kind = kind, .direction = candidate.direction, .source = PullSource::exact};
  }
  return best;
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
      const double freed = release_.free_area(rest, candidate.direction, k_never);
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
