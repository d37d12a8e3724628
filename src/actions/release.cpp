#include "actions/release.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "mold/exact_rays.hpp"
#include "mold/map_frame.hpp"

namespace moldlight {

namespace {

constexpr double k_resolved = 1e-7;      // of a length
constexpr double k_turn_step_deg = 2.5;  // beyond it a turn goes on in equal steps
constexpr double k_past = 1e-6;          // behind a facet that is not in the way
constexpr double k_beside = 2e-6;  // of a point's way, likewise: some roundings of a file in single precision
constexpr double k_touching = 1e-6;    // no farther apart than the rounding of coordinates
constexpr int k_most_passed = 1024;    // such facets along one ray
constexpr int k_most_glides = 512;     // of them, along a way across the part at a draft of tau
constexpr double k_least_sine = 1e-7;  // of tau: walls of a file in single precision lean by so much
/// A part lies in a ball of diameter 1 in the unit frame.
constexpr double k_glide_across = 1.0;

/// To both sides of 0, as long as `free` holds at an angle in degrees.
template <typename Free>
TurnInterval turn_while(const Free& free, double resolved_deg = k_exact_turn_deg) {
  const auto reach = [&](double sense) {
    double good = 0.0, bad = 0.25;
    while (free(sense * bad)) {
      good = bad;
      if (good >= 180.0) return 180.0;
      bad = std::min(180.0, bad < k_turn_step_deg ? 2.0 * bad : bad + k_turn_step_deg);
    }
    while (bad - good > resolved_deg) {
      const double middle = 0.5 * (good + bad);
      (free(sense * middle) ? good : bad) = middle;
    }
    return good;
  };
  return {-reach(-1.0), reach(1.0)};
}

}  // namespace

double area_of(std::span<const UndercutSample> samples) {
  double area = 0.0;
  for (const UndercutSample& sample : samples) area += sample.area;
  return area;
}

struct Release::Reaches {
  std::mutex mutex;
  std::map<std::array<double, 3>, double> along;
};

Release::Release(const PartModel& model, const ExactQuery& query, const Progress* progress)
    : model_(model),
      query_(query),
      reaches_(std::make_shared<Reaches>()),
      sine_(std::max(std::sin(glm::radians(query.tau_deg)), k_least_sine)),
      progress_(progress) {}

glm::vec3 Release::start(const UndercutSample& sample, const glm::dvec3& pull) const {
  end_if_cancelled();
  if (std::abs(glm::dot(sample.normal, pull)) >= sine_) return sample.position;
  return lateral_point(sample.position, sample.normal, {.direction = pull, .lateral = query_.lateral});
}

double Release::free_length(const UndercutSample& sample, const glm::dvec3& pull) const {
  if (glm::dot(sample.normal, pull) <= -sine_) return 0.0;
  const double aside = std::max(query_.lateral, sine_ * k_glide_across / k_most_glides);
  glm::dvec3 from(start(sample, pull));
  double gone = 0.0;
  for (int passed = 0; passed < k_most_passed; ++passed) {
    const auto hit = model_.rays().first_hit(glm::vec3(from + gone * pull), glm::vec3(pull), true);
    if (!hit) return k_never;
    gone += static_cast<double>(hit->distance);
    const glm::dvec3& normal = model_.geometry.normals[hit->facet];
    const double facing = glm::dot(normal, pull);
    if (facing <= -sine_) return gone;
    // The point glides along it: below it, it would meet nothing of what stands on it.
    if (facing < 0.0) from += aside * glm::normalize(normal - facing * pull);
    gone += k_past;
  }
  return gone;
}

int Release::depth(const glm::dvec3& from, const glm::dvec3& along) const {
  end_if_cancelled();
  int depth = 0;
  double gone = 0.0;
  for (int crossings = 0; crossings < k_most_passed; ++crossings) {
    const auto hit = model_.rays().first_hit(glm::vec3(from + gone * along), glm::vec3(along), false);
    if (!hit) break;
    gone += static_cast<double>(hit->distance) + k_past;
    depth += glm::dot(model_.geometry.normals[hit->facet], along) > 0.0 ? 1 : -1;
  }
  return depth;
}

bool Release::is_covered(const UndercutSample& sample) const {
  constexpr double k_off = 1e-5;
  const glm::dvec3 from = glm::dvec3(sample.position) + k_off * sample.normal;
  return depth(from, glm::normalize(glm::dvec3(0.31, 0.57, 0.76))) > 0 &&
         depth(from, glm::normalize(glm::dvec3(-0.62, 0.41, -0.67))) > 0;
}

bool Release::covered(const UndercutSample& sample, const glm::dvec3& pull) const {
  return depth(glm::dvec3(sample.position) + query_.lateral * sample.normal, pull) > 0;
}

bool Release::is_in_slit(const UndercutSample& sample, double width) const {
  // From a little behind, so that surface which touches it is met.
  const glm::vec3 behind(glm::dvec3(sample.position) - k_touching * sample.normal);
  const auto hit = model_.rays().first_hit(behind, glm::vec3(sample.normal), true);
  constexpr double k_facing = -0.5;  // cosine at most of the other wall of a slit to this one
  return hit && static_cast<double>(hit->distance) < width &&
         glm::dot(model_.geometry.normals[hit->facet], sample.normal) < k_facing;
}

bool Release::is_shallow(const UndercutSample& sample, double depth) const {
  constexpr int k_turns = 24;
  if (is_in_slit(sample, depth)) return true;
  if (model_.health.components > 1 && is_covered(sample)) return false;
  const MapFrame frame = map_frame(query_.direction);
  const glm::dvec3 from(start(sample, query_.direction));
  for (int k = 0; k < k_turns; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / k_turns;
    const glm::dvec3 aside = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
    if (glm::dot(sample.normal, aside) <= -sine_) continue;  // it does not move at all
    for (const glm::dvec3& side : {query_.direction, -query_.direction}) {
      // From a little before it, too, so that surface which touches it hides it.
      const glm::vec3 before(from + depth * aside - k_touching * side);
      if (!model_.rays().surface_point_blocked(before, glm::vec3(0.0F), glm::vec3(side)) &&
          clear(sample, aside, depth, side) && free_length(sample, aside) >= depth)
        return true;
    }
  }
  return false;
}

bool Release::is_nearly_free(const UndercutSample& sample, const glm::dvec3& pull, double depth) const {
  constexpr int k_turns = 16;
  // At the tip of what forms it the steel is thinner than that.
  const auto steel = gap(glm::dvec3(sample.position) + k_touching * sample.normal, sample.normal);
  if (steel && *steel < depth) return true;
  const MapFrame frame = map_frame(pull);
  UndercutSample moved = sample;
  for (int k = 0; k < k_turns; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / k_turns;
    const glm::dvec3 aside = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
    if (glm::dot(sample.normal, aside) < -k_least_sine || free_length(sample, aside) < depth) continue;
    // From a little before it, so that surface which touches it is met: its own, if it slid along that.
    moved.position = glm::vec3(glm::dvec3(sample.position) + depth * aside - k_touching * pull);
    moved.normal = pull;
    if (free_length(moved, pull) == k_never) return true;
  }
  return false;
}

double FreeLengths::of(const UndercutSample& sample) {
  const std::size_t place = place_of(sample);
  if (place == known_.size()) return release_.free_length(sample, pull_);
  if (known_[place] < 0.0) known_[place] = release_.free_length(sample, pull_);
  return known_[place];
}

double Release::free_area(std::span<const UndercutSample> samples, const glm::dvec3& pull, double length,
                          double most) const {
  double area = 0.0, left = area_of(samples);
  for (const UndercutSample& sample : samples) {
    if (area + left <= most) break;
    area += free_length(sample, pull) >= length ? sample.area : 0.0;
    left -= sample.area;
  }
  return area;
}

template <typename Free>
bool Release::is_speck(const UndercutSample& sample, const Free& free) const {
  constexpr int k_turns = 8;
  const MapFrame frame = map_frame(sample.normal);
  for (int k = 0; k < k_turns; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / k_turns;
    UndercutSample beside = sample;
    beside.position +=
        glm::vec3(2.0 * query_.lateral * (std::cos(angle) * frame.x + std::sin(angle) * frame.y));
    if (free(beside)) return true;
  }
  return false;
}

template <typename Free>
bool Release::all_but_specks(std::span<const UndercutSample> samples, const Free& free,
                             std::size_t& first) const {
  const auto most = [&] { return k_blocked_share * area_of(samples); };
  const auto is_none = [&](const UndercutSample& sample) {
    return sample.area <= 0.0 || sample.area > most() || !is_speck(sample, free);
  };
  if (first < samples.size() && !free(samples[first]) && is_none(samples[first])) return false;
  double blocked = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (free(samples[k])) continue;
    blocked += samples[k].area;
    if (blocked <= most() && !is_none(samples[k])) continue;
    first = k;
    return false;
  }
  return true;
}

bool Release::releases(std::span<const UndercutSample> samples, const glm::dvec3& pull, double length) const {
  std::size_t first = samples.size();
  return all_but_specks(
      samples, [&](const UndercutSample& sample) { return free_length(sample, pull) >= length; }, first);
}

TurnInterval Release::free_turn(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                                const glm::dvec3& axis, double resolved_deg) const {
  std::size_t first = samples.size();
  return turn_while(
      [&](double angle_deg) {
        const glm::dvec3 turned = turned_about(pull, axis, angle_deg);
        return all_but_specks(
            samples, [&](const UndercutSample& sample) { return free_length(sample, turned) == k_never; },
            first);
      },
      resolved_deg);
}

TurnInterval Release::lifter_turn(std::span<const UndercutSample> samples, const LifterWay& way,
                                  const glm::dvec3& axis) const {
  constexpr double k_longer = 1.1, k_rounding = 1e-6;
  return turn_while([&](double angle_deg) {
    const double cosine = std::cos(glm::radians(angle_deg));
    LifterWay turned = way;
    turned.pull = turned_about(way.pull, axis, angle_deg);
    FreeLengths lengths(*this, samples, turned.pull);
    if (cosine * k_longer >= 1.0) {
      turned.length = way.length / cosine + k_rounding;
      if (clears(lengths, turned)) return true;
    }
    for (const double longer : {0.5 * (1.0 + k_longer), k_longer}) {
      turned.length = longer * way.length;
      if (clears(lengths, turned)) return true;
    }
    return false;
  });
}

double Release::reach(const glm::dvec3& direction) const {
  const std::array<double, 3> key = {direction.x, direction.y, direction.z};
  {
    const std::scoped_lock lock(reaches_->mutex);
    if (const auto known = reaches_->along.find(key); known != reaches_->along.end()) return known->second;
  }
  double greatest = -k_never;
  for (const glm::dvec3& vertex : model_.part.mesh.vertices)
    greatest = std::max(greatest, glm::dot(vertex - model_.frame.center, direction));
  const std::scoped_lock lock(reaches_->mutex);
  return reaches_->along[key] = greatest / model_.frame.diagonal;
}

std::optional<double> Release::gap(const glm::dvec3& from, const glm::dvec3& along) const {
  end_if_cancelled();
  const auto hit = model_.rays().first_hit(glm::vec3(from), glm::vec3(along), true);
  return hit ? std::optional(static_cast<double>(hit->distance)) : std::nullopt;
}

bool Release::leaves(const glm::dvec3& from, const glm::dvec3& along) const {
  end_if_cancelled();
  return !model_.rays().first_hit(glm::vec3(from), glm::vec3(along), false);
}

bool Release::clear(const UndercutSample& sample, const glm::dvec3& pull, double length,
                    const glm::dvec3& side) const {
  // Surface that only touches its way is beside it, whatever rounding says: at its own height, but for what
  // it would lie under, and in the plane of the way.
  const double above = glm::dot(sample.normal, side) > -sine_ ? k_beside : -k_beside;
  const glm::dvec3 at = glm::dvec3(start(sample, pull)) + length * pull + above * side;
  const auto leaves_from = [&](const glm::dvec3& from) {
    return !model_.rays().surface_point_blocked(glm::vec3(from), glm::vec3(0.0F), glm::vec3(side));
  };
  const auto here = model_.rays().blockage(glm::vec3(at), glm::vec3(side), static_cast<float>(k_beside));
  if (here == ExactRays::Blockage::none) return true;
  if (here == ExactRays::Blockage::around) return false;
  const glm::dvec3 across = glm::cross(side, pull);
  const double sine = glm::length(across);
  if (sine < k_least_sine) return false;
  const glm::dvec3 aside = k_beside / sine * across;
  return leaves_from(at + aside) || leaves_from(at - aside);
}

bool Release::clears(const UndercutSample& sample, const LifterWay& way, double room) const {
  FreeLengths none(*this, {}, way.pull);
  return clears(sample, way, room, none);
}

bool Release::clears(const UndercutSample& sample, const LifterWay& way, double room,
                     FreeLengths& lengths) const {
  const double known = lengths.known(sample);
  if (known >= 0.0 && known < way.length + room) return false;
  if (!clear(sample, way.pull, way.length, way.side)) return false;
  for (const double share : {0.5, 1.0}) {
    if (room > 0.0 && !clear(sample, way.pull, way.length + share * room, way.side)) return false;
  }
  return lengths.of(sample) >= way.length + room;
}

double Release::clear_beyond(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                             const glm::dvec3& side, double step) const {
  const double outside = reach(pull) + query_.lateral;
  double beyond = 0.0;
  for (const UndercutSample& sample : samples) {
    const double end = std::max(0.0, outside - glm::dot(glm::dvec3(sample.position), pull));
    double good = end, bad = end - step;
    // What has been found already need not be found again.
    while (bad > beyond && clear(sample, pull, bad, side)) {
      good = bad;
      bad -= step;
    }
    if (bad <= beyond) {
      bad = beyond;
      if (clear(sample, pull, bad, side)) continue;
    }
    while (good - bad > k_resolved) {
      const double middle = 0.5 * (good + bad);
      (clear(sample, pull, middle, side) ? good : bad) = middle;
    }
    beyond = good;
  }
  return beyond;
}

bool Release::clears(FreeLengths& lengths, const LifterWay& way, double room) const {
  return all_but_specks(
      lengths.samples(), [&](const UndercutSample& sample) { return clears(sample, way, room, lengths); },
      lengths.first_blocked());
}

double Release::free_of_all(FreeLengths& lengths, double least) const {
  const double most_blocked = k_blocked_share * area_of(lengths.samples());
  double free = k_never;
  for (const UndercutSample& sample : lengths.samples()) {
    if (sample.area > most_blocked) free = std::min(free, lengths.of(sample));
    if (free < least) break;
  }
  return free;
}

std::optional<double> Release::first_clear(FreeLengths& lengths, LifterWay way) const {
  constexpr double k_first_step = 1.0 / 1024.0, k_growth = 1.12;
  const auto all_clear = [&](double length) {
    way.length = length;
    return clears(lengths, way);
  };
  const double least = way.length;
  // Beyond that it is blocked, however clear its way out.
  const double most = std::min(k_glide_across, free_of_all(lengths, least));
  if (most < least) return std::nullopt;
  if (all_clear(least)) return least;
  double bad = least;
  for (double good = std::max(k_first_step, k_growth * least); good <= most; good *= k_growth) {
    if (!all_clear(good)) {
      bad = good;
      continue;
    }
    while (good - bad > k_resolved) {
      const double middle = 0.5 * (good + bad);
      (all_clear(middle) ? good : bad) = middle;
    }
    return good;
  }
  return std::nullopt;
}

glm::dvec3 turned_about(const glm::dvec3& direction, const glm::dvec3& axis, double angle_deg) {
  return glm::normalize(glm::angleAxis(glm::radians(angle_deg), axis) * direction);
}

}  // namespace moldlight
