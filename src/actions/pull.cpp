#include "actions/pull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr std::size_t k_quick_samples = 24;   // which show soon that a lifter is hopeless
constexpr double k_coarse_step = 1.0 / 64.0;  // of estimated travels, share of the diagonal
constexpr std::size_t k_lifters = 3;          // of an undercut, that can be built and that cannot
constexpr std::size_t k_most_tries = 24;      // at each
constexpr double k_narrow_cost = 5e-4;        // of a pull that may not turn at all, beside the weights
constexpr double k_travel_cost = 1e-3;        // of the diagonal, beside the weights
constexpr double k_way_cost = 0.01;     // likewise: steel of core and cavity that a slide passes through
constexpr double k_strain_cost = 10.0;  // of a ring that is stretched to twice its size
constexpr double k_even_cost = 1e-3;  // of a direction that the part does not suggest, or but beside its axis
constexpr double k_cost_step = 1e-6;  // less is rounding
constexpr double k_across_cost = 0.25;  // of a slide across the part: it takes the room of the core
constexpr double k_wish_gain = 0.05;    // of a direction of the user's own, off the weights

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

double pull_cost(const Pull& pull, const ActionPrices& prices) {
  const double width_deg = pull.interval.to_deg - pull.interval.from_deg;
  const double gain = pull.source == PullSource::wish ? k_wish_gain : 0.0;
  const double strain = pull.kind == ActionKind::strip ? pull.about->strain : 0.0;
  const double far = pull.across ? k_across_cost : 0.0;
  const double meant = pull.source == PullSource::even || pull.beside_axis ? k_even_cost : 0.0;
  const double cost = prices[static_cast<std::size_t>(pull.kind)] - gain + meant + far +
                      k_strain_cost * strain + k_way_cost * pull.way + k_travel_cost * pull.travel +
                      k_narrow_cost / (1.0 + width_deg);
  return k_cost_step * std::round(cost / k_cost_step);
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
      Pull middle = in_the_middle(samples, candidate, kind, k_compared_turn_deg, tried);
      if (std::optional<Pull> laid = on_part_axis(samples, middle)) {
        estimate_travel(samples, *laid);
        pulls.push_back(*laid);
        middle.kept = middle.beside_axis = true;
      }
      pulls.push_back(middle);
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
    if (pulls.empty()) continue;
    if (!only) add_lifters_inside(samples, tried, pulls);
    return pulls;
  }
  return !only || only == ActionKind::lifter ? find_lifters(samples, tried) : std::vector<Pull>();
}

bool PullFinder::is_axis(const glm::dvec3& pull) const {
  return std::max(std::abs(glm::dot(pull, axes_.x)), std::abs(glm::dot(pull, axes_.y))) > k_same_pull;
}

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
  Pull pull{.kind = kind, .direction = candidate.direction, .source = candidate.source};
  pull.interval = release_.free_turn(samples, pull.direction, direction_, resolved_deg);
  if (pull.source == PullSource::wish) return pull;
  const double from_deg = pull.interval.from_deg, to_deg = pull.interval.to_deg;
  const double middle_deg = pull.interval.middle_deg(), half_deg = 0.5 * (to_deg - from_deg);
  if (const auto better = meant_within(pull, others)) {
    const double turn_deg = turn_between(pull.direction, better->direction, direction_);
    pull.direction = better->direction;
    pull.source = better->source;
    pull.interval = {from_deg - turn_deg, to_deg - turn_deg};
    return pull;
  }
  const glm::dvec3 centred = turned_about(pull.direction, direction_, middle_deg);
  if (!release_.releases(samples, centred, k_never)) return pull;
  pull.direction = centred;
  pull.source = PullSource::even;
  pull.interval = {-half_deg, half_deg};
  return pull;
}

std::optional<Pull> PullFinder::laid_on(std::span<const UndercutSample> samples, const Pull& pull,
                                        const glm::dvec3& axis, double near_deg) const {
  const double sine = glm::length(glm::cross(pull.direction, axis));
  if (sine == 0.0 || sine > std::sin(glm::radians(near_deg)) || glm::dot(pull.direction, axis) < 0.0 ||
      pull.source == PullSource::wish || !release_.releases(samples, axis, k_never))
    return std::nullopt;
  Pull laid = pull;
  const double turn_deg = turn_between(pull.direction, axis, direction_);
  laid.direction = axis;
  laid.interval = {pull.interval.from_deg - turn_deg, pull.interval.to_deg - turn_deg};
  return laid;
}

std::optional<Pull> PullFinder::on_part_axis(std::span<const UndercutSample> samples,
                                             const Pull& pull) const {
  constexpr double k_near_deg = 2.0;
  if (!axes_.by_walls) return std::nullopt;
  for (const glm::dvec3& axis : {axes_.x, -axes_.x, axes_.y, -axes_.y})
    if (std::optional<Pull> laid = laid_on(samples, pull, axis, k_near_deg)) return laid;
  return std::nullopt;
}

Pull PullFinder::on_file_axis(std::span<const UndercutSample> samples, const Pull& pull) const {
  constexpr double k_near_deg = 0.1;
  const glm::dvec3 axis = glm::round(pull.direction);
  if (glm::dot(axis, axis) != 1.0) return pull;
  return laid_on(samples, pull, axis, k_near_deg).value_or(pull);
}

std::optional<PullCandidate> PullFinder::meant_within(const Pull& pull,
                                                      std::span<const PullCandidate> others) const {
  constexpr double k_wide_deg = 10.0;
  constexpr double k_margin = 0.15, k_narrow_margin = 0.25;  // to the ends, of the width
  constexpr double k_nearly_upright = 0.9;                   // of tau
  const double from_deg = pull.interval.from_deg, to_deg = pull.interval.to_deg;
  const double width_deg = to_deg - from_deg, lean_deg = elevation_deg(pull.direction, direction_);
  const bool wide = width_deg > k_wide_deg;
  const double least_deg = (wide ? k_margin : k_narrow_margin) * width_deg;
  // Along walls that say where the part points a slide leaves at the end of what is free but for the draft.
  const double least_part_deg = wide ? std::min(least_deg, k_nearly_upright * tau_deg_) : least_deg;
  // What is free to turn is held by no round wall: its axis is no better than one of the part.
  const auto rank = [&](PullSource source) {
    return wide && source == PullSource::exact ? PullSource::part : source;
  };
  std::optional<PullCandidate> best;
  double margin_deg = 0.0;
  const auto look_at = [&](const PullCandidate& other) {
    // Planes of a narrow undercut may lean by its draft: the middle of what is free is the truth.
    if (other.source > (wide ? PullSource::shape : PullSource::part) ||
        std::abs(elevation_deg(other.direction, direction_) - lean_deg) > k_same_elevation_deg)
      return;
    const double turn_deg = turn_between(pull.direction, other.direction, direction_);
    const double its_deg = std::min(to_deg - turn_deg, turn_deg - from_deg);
    if (its_deg < (other.source == PullSource::part ? least_part_deg : least_deg) ||
        (best && rank(other.source) > rank(best->source)))
      return;
    if (best && rank(other.source) == rank(best->source)) {
      const bool axis = is_axis(other.direction), best_axis = is_axis(best->direction);
      if (axis == best_axis ? its_deg <= margin_deg + k_same_elevation_deg : best_axis) return;
    }
    best = other;
    margin_deg = its_deg;
  };
  look_at({pull.direction, pull.source});
  for (const PullCandidate& other : others) look_at(other);
  for (const glm::dvec3& across : axes_.across) look_at({across, PullSource::part});
  return best;
}

void PullFinder::set_travel(std::span<const UndercutSample> samples, double step, Pull& pull) const {
  const double core = release_.clear_beyond(samples, pull.direction, direction_, step);
  const double cavity = release_.clear_beyond(samples, pull.direction, -direction_, step);
  pull.core_side = core <= cavity;
  pull.travel = std::min(core, cavity);
}

double PullFinder::way_out(const glm::dvec3& from, const glm::dvec3& pull) const {
  double least = k_never;
  for (const Side& side : sides_) {
    const double toward = glm::dot(pull, side.normal);
    if (toward > 1e-6) least = std::min(least, (side.reach - glm::dot(from, side.normal)) / toward);
  }
  return std::max(0.0, least);
}

bool PullFinder::goes_across(std::span<const UndercutSample> samples, const glm::dvec3& pull) const {
  constexpr double k_far_side = 0.6;  // of the part's extent
  const glm::dvec3 aside = glm::normalize(glm::cross(direction_, pull));
  double out = 0.0, back = 0.0;
  std::size_t inside = 0;
  const auto few = few_of(samples);
  for (const UndercutSample& sample : few) {
    const glm::dvec3 from(release_.start(sample, pull));
    const double way = way_out(from, pull);
    const glm::dvec3 halfway = from + 0.5 * way * pull;
    if ((release_.gap(halfway, direction_) || release_.gap(halfway, -direction_)) &&
        release_.gap(halfway, aside) && release_.gap(halfway, -aside))
      ++inside;
    out += way;
    back += way_out(from, -pull);
  }
  return out > k_far_side * (out + back) && 2 * inside > few.size();
}

void PullFinder::add_lifters_inside(std::span<const UndercutSample> samples,
                                    std::span<const PullCandidate> tried, std::vector<Pull>& slides) const {
  constexpr double k_short = 0.25;  // of a slide's way
  double way = k_never;
  for (const Pull& slide : slides) {
    if (!goes_across(samples, slide.direction)) return;
    way = std::min(way, slide.way);
  }
  std::vector<Pull> lifters = find_lifters(samples, tried);
  std::erase_if(lifters, [&](const Pull& pull) { return pull.lack || pull.travel > k_short * way; });
  if (lifters.empty()) return;
  for (Pull& slide : slides) slide.across = true;
  slides.insert(slides.end(), lifters.begin(), lifters.end());
}

void PullFinder::estimate_travel(std::span<const UndercutSample> samples, Pull& pull) const {
  set_travel(few_of(samples), k_coarse_step, pull);
  // In the mean: how far the farthest of few samples lies says less.
  pull.way = 0.0;
  for (const UndercutSample& sample : samples)
    pull.way += sample.area * way_out(glm::dvec3(sample.position), pull.direction);
  if (const double area = area_of(samples); area > 0.0) pull.way /= area;
}

std::vector<Pull> PullFinder::find_lifters(std::span<const UndercutSample> samples,
                                           std::span<const PullCandidate> tried) const {
  const auto side = [&](bool core_side) { return core_side ? direction_ : -direction_; };
  std::vector<Pull> found;
  for (const PullCandidate& candidate : tried) {
    if (std::abs(elevation_deg(candidate.direction, direction_)) > k_same_elevation_deg) continue;
    FreeLengths lengths(release_, few_of(samples), candidate.direction);
    for (const bool core_side : {true, false}) {
      const auto travel =
          release_.first_clear(lengths, {candidate.direction, side(core_side), least_travel_});
      if (!travel) continue;
      found.push_back({.kind = ActionKind::lifter,
                       .direction = candidate.direction,
                       .source = candidate.source,
                       .travel = *travel,
                       .core_side = core_side});
      set_lack(lengths, found.back(), false);
    }
  }
  // One that nothing of the part suggests is worth its while if it is shorter by more than what samples show.
  // Likewise one off the axes of the part.
  constexpr double k_even_longer = 1.05, k_off_axis_longer = 1.05;
  std::ranges::stable_sort(found, {}, [&](const Pull& pull) {
    const double even = pull.source == PullSource::even ? k_even_longer : 1.0;
    const double off_axis = is_axis(pull.direction) ? 1.0 : k_off_axis_longer;
    return std::pair(pull.source != PullSource::wish, even * off_axis * pull.travel);
  });
  std::vector<Pull> pulls;
  for (const bool good : {true, false}) {
    std::size_t number = 0, tries = 0;
    for (Pull pull : found) {
      // Few samples may say that it can be built where all of them do not.
      if (pull.lack.has_value() == good || number == k_lifters || tries == k_most_tries) continue;
      ++tries;
      FreeLengths lengths(release_, samples, pull.direction);
      const auto travel =
          release_.first_clear(lengths, {pull.direction, side(pull.core_side), least_travel_});
      if (!travel) continue;
      pull.travel = *travel;
      set_lack(lengths, pull);
      number += pull.lack.has_value() == good ? 0 : 1;
      pulls.push_back(pull);
    }
  }
  return pulls;
}

std::optional<Pull> PullFinder::shared_lifter(std::span<const UndercutSample> samples, Pull pull) const {
  constexpr double k_most_longer = 1.2;
  FreeLengths lengths(release_, samples, pull.direction);
  const double own = pull.travel;
  const auto travel =
      release_.first_clear(lengths, {pull.direction, pull.core_side ? direction_ : -direction_, own});
  if (!travel || *travel > k_most_longer * own) return std::nullopt;
  pull.travel = *travel;
  set_lack(lengths, pull);
  return pull.lack ? std::nullopt : std::optional(pull);
}

void PullFinder::set_lack(FreeLengths& lengths, Pull& lifter, bool with_stem) const {
  const LifterWay way{lifter.direction, lifter.core_side ? direction_ : -direction_, lifter.travel};
  lifter.lack.reset();
  if (lifter.travel > longest_lifter_) {
    lifter.lack =
        Pull::Lack{.reason = RejectReason::too_far, .at = lengths.samples().front(), .room = k_never};
    return;
  }
  if (release_.clears(lengths, way, lifter_room_)) {
    if (with_stem && asks_for_stems() && !find_stem(release_, lengths, way, stem_))
      lifter.lack =
          Pull::Lack{.reason = RejectReason::no_stem, .at = lengths.samples().front(), .room = k_never};
    return;
  }
  // What may move on for ever and yet is not clear has no way out.
  lifter.lack =
      Pull::Lack{.reason = RejectReason::no_way_out, .at = lengths.samples().front(), .room = k_never};
  for (const UndercutSample& sample : lengths.samples()) {
    const double room = lengths.of(sample) - lifter.travel;
    if (room < 0.0 || release_.clears(sample, way, lifter_room_, lengths) || room >= lifter.lack->room)
      continue;
    lifter.lack = Pull::Lack{.reason = room < lifter_room_ ? RejectReason::no_room : RejectReason::no_way_out,
                             .at = sample,
                             .room = room};
  }
}

std::optional<Pull> PullFinder::most_clearing(std::span<const UndercutSample> samples,
                                              std::span<const PullCandidate> tried, double least) const {
  constexpr double k_first = 1.0 / 512.0, k_growth = 1.2;
  constexpr std::size_t k_every = 3;  // of the fan
  std::optional<Pull> best;
  const auto few = few_of(samples);
  double most = least * area_of(few) / area_of(samples);
  for (std::size_t k = 0; k < tried.size(); ++k) {
    const PullCandidate& candidate = tried[k];
    if (std::abs(elevation_deg(candidate.direction, direction_)) > k_same_elevation_deg) continue;
    if (candidate.source == PullSource::even && k % k_every != 0) continue;
    FreeLengths lengths(release_, few, candidate.direction);
    const auto area_that = [&](const auto& gets_away) {
      double area = 0.0;
      for (const UndercutSample& sample : few) area += gets_away(sample) ? sample.area : 0.0;
      return area;
    };
    for (const bool core_side : {true, false}) {
      LifterWay way{candidate.direction, core_side ? direction_ : -direction_, k_first};
      for (double& length = way.length; length < longest_lifter_; length *= k_growth) {
        const auto reaches = [&](const UndercutSample& s) { return lengths.of(s) >= length + lifter_room_; };
        const double needed = most * (1.0 + 1e-9);
        double cleared = 0.0, left = area_that(reaches);
        if (left <= needed) break;
        for (const UndercutSample& sample : few) {
          if ((cleared + left) * (1.0 + 1e-12) <= needed) break;  // it cannot become the best
          if (!reaches(sample)) continue;
          left -= sample.area;
          if (release_.clears(sample, way, lifter_room_, lengths)) cleared += sample.area;
        }
        if (cleared <= needed) continue;
        most = cleared;
        best = Pull{.kind = ActionKind::lifter,
                    .direction = candidate.direction,
                    .source = candidate.source,
                    .travel = length,
                    .core_side = core_side};
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
    const double from_deg = pull.interval.from_deg, to_deg = pull.interval.to_deg;
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

}  // namespace moldlight
