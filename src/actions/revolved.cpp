#include "actions/revolved.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

#include "actions/release.hpp"
#include "mesh/symmetric_eigen.hpp"
#include "mold/map_frame.hpp"

namespace moldlight {

namespace {

constexpr double k_most_ratio = 0.03;      // measured: threads are below, other undercuts above
constexpr double k_least_rotation = 1e-3;  // of a unit eigenvector: less is a translation
constexpr double k_most_square =
    0.03;  // mean, of the sine between surface and motion: a dozen sides have that
constexpr std::size_t k_least_turned_samples = 12;
constexpr int k_rounds = 12;
constexpr double k_least_residual = 1e-4;  // of a row; less is no reason to trust it more
constexpr double k_step_deg = 4.0;         // of the motion that is played
constexpr double k_play = 0.04;            // of the pitch: threads of facets leave their helix by so much
constexpr double k_flattest = 0.01, k_steepest = 20.0;  // pitches, in radii
constexpr double k_most_turns = 20.0;                   // that are played
constexpr double k_may_meet = 0.1;          // share of the area that meets the part where the thread runs out
constexpr std::size_t k_first_turned = 60;  // which show soon that most of it meets the part
constexpr double k_hopeless = 0.6;
constexpr double k_nearly_meets = 0.5;  // share: it is no thread, and the rest is not asked
constexpr int k_sectors = 24;           // that a ring must fill

/// About an axis along z of the frame.
struct Cylindrical {
  MapFrame frame;
  glm::dvec3 point;

  [[nodiscard]] double angle(const glm::dvec3& p) const {
    return std::atan2(glm::dot(p - point, frame.y), glm::dot(p - point, frame.x));
  }
  [[nodiscard]] double radius(const glm::dvec3& p) const {
    const glm::dvec3 from = p - point;
    return glm::length(from - glm::dot(from, frame.z) * frame.z);
  }
  [[nodiscard]] glm::dvec3 at(double angle, double radius, double height) const {
    return point + radius * (std::cos(angle) * frame.x + std::sin(angle) * frame.y) +
           (height - glm::dot(point, frame.z)) * frame.z;
  }
};

struct Reach {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  void take(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
};

Reach reach_along(std::span<const UndercutSample> samples, const glm::dvec3& direction) {
  Reach reach;
  for (const UndercutSample& sample : samples) reach.take(glm::dot(glm::dvec3(sample.position), direction));
  return reach;
}

/// Whether all sectors about the axis have samples.
bool goes_round(const Cylindrical& about, std::span<const UndercutSample> samples) {
  std::array<bool, k_sectors> filled{};
  for (const UndercutSample& sample : samples) {
    const double turn = about.angle(glm::dvec3(sample.position)) / (2.0 * std::numbers::pi) + 0.5;
    filled[static_cast<std::size_t>(turn * k_sectors) % k_sectors] = true;
  }
  return std::ranges::all_of(filled, [](bool each) { return each; });
}

/// The advance of the edges that wind about the axis, by their turn: corners lie on the helix, which normals
/// of facets, those of its chords, do not show. 0 where there are none.
double edge_advance(const PartModel& model, std::span<const FacetIndex> facets, const Cylindrical& about) {
  constexpr double k_same_radius = 2e-3, k_least_turn = 1e-3, k_most_turn = 0.5;
  std::vector<std::pair<double, double>> advances;  // with the turn that has it
  double total = 0.0;
  for (const FacetIndex facet : facets) {
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 a(model.frame.to_unit(model.part.mesh.corner(facet, k)));
      const glm::dvec3 b(model.frame.to_unit(model.part.mesh.corner(facet, (k + 1) % 3)));
      const double radius = about.radius(a);
      if (std::abs(about.radius(b) - radius) > k_same_radius * radius) continue;
      const double turn = std::remainder(about.angle(b) - about.angle(a), 2.0 * std::numbers::pi);
      if (std::abs(turn) < k_least_turn || std::abs(turn) > k_most_turn) continue;
      advances.emplace_back(glm::dot(b - a, about.frame.z) / turn, std::abs(turn));
      total += std::abs(turn);
    }
  }
  std::ranges::stable_sort(advances);
  double sum = 0.0;
  for (const auto& [advance, turn] : advances) {
    sum += turn;
    if (sum >= 0.5 * total) return advance;
  }
  return 0.0;
}

/// Out along a helix; unit frame.
struct ScrewMotion {
  glm::dvec3 point, axis;  // axis: unit
  double advance;          // along it for a turn by one radian
  double sense;            // of the turn, 1 or -1
  double turn;             // radians
  double off;              // that the samples begin off the surface
};

/// Whether the sample meets the part when it is screwed out.
bool meets(const PartModel& model, const UndercutSample& sample, const ScrewMotion& motion) {
  const double step = glm::radians(k_step_deg);
  const glm::dvec3 start = glm::dvec3(sample.position) + motion.off * sample.normal - motion.point;
  const auto placed = [&](double turned) {
    return motion.point + glm::angleAxis(motion.sense * turned, motion.axis) * start +
           motion.sense * turned * motion.advance * motion.axis;
  };
  glm::dvec3 at = placed(0.0);
  for (double turned = step; turned <= motion.turn; turned += step) {
    const glm::dvec3 next = placed(turned);
    const double length = glm::distance(at, next);
    const auto hit = model.rays().first_hit(glm::vec3(at), glm::vec3((next - at) / length), true);
    if (hit && static_cast<double>(hit->distance) < length) return true;
    at = next;
  }
  return false;
}

/// Share of the samples' area that meets the part when they are screwed out; of few of them, where these say
/// that most does, or where they are more than k_nearly_meets of it.
double met_share(const PartModel& model, std::span<const UndercutSample> samples, const ScrewMotion& motion) {
  const double enough = k_nearly_meets * area_of(samples);
  double met = 0.0, total = 0.0;
  for (std::size_t first = 0; first < samples.size(); first += k_first_turned) {
    // The first of them are spread over all of it.
    if (met > enough || (first == k_first_turned && met > k_hopeless * total)) break;
    const auto some = samples.subspan(first, std::min(k_first_turned, samples.size() - first));
    std::array<bool, k_first_turned> met_by{};
    tbb::parallel_for(std::size_t{0}, some.size(),
                      [&](std::size_t k) { met_by[k] = meets(model, some[k], motion); });
    for (std::size_t k = 0; k < some.size(); ++k) {
      total += some[k].area;
      if (met_by[k]) met += some[k].area;
    }
  }
  return met / total;
}

/// So far that the samples have gone as far as they reach along the axis.
ScrewMotion screw_out(const Reach& heights, const HelixFit& helix, bool core_side, const ExactQuery& query) {
  return {.point = helix.point,
          .axis = query.direction,
          .advance = helix.advance,
          .sense = core_side == (helix.advance > 0.0) ? 1.0 : -1.0,
          .turn = std::min((heights.greatest - heights.least) / std::abs(helix.advance),
                           k_most_turns * 2.0 * std::numbers::pi),
          .off = std::max(query.lateral, k_play * 2.0 * std::numbers::pi * std::abs(helix.advance))};
}

std::vector<UndercutSample> middles_of(const PartModel& model, std::span<const FacetIndex> facets) {
  std::vector<UndercutSample> middles;
  for (const FacetIndex facet : facets) {
    middles.push_back({model.frame.to_unit(model.part.mesh.middle(facet)), model.geometry.normals[facet],
                       model.geometry.areas[facet]});
  }
  return middles;
}

/// Of whole facets, where most of their area is of the surface: few samples of coarse ones leave the axis too
/// far off to screw along it.
std::optional<HelixFit> fit_surface(const PartModel& model, const RevolvedSurface& surface,
                                    const glm::dvec3& direction) {
  constexpr double k_most_of_facets = 1.2;
  const std::vector<UndercutSample> middles = middles_of(model, surface.facets);
  const bool whole = area_of(middles) <= k_most_of_facets * area_of(surface.samples);
  return fit_helix(whole ? middles : surface.samples, direction);
}

std::optional<Thread> thread_about(const HelixFit& fit, const PartModel& model,
                                   const RevolvedSurface& surface, const ExactQuery& query) {
  const auto& [samples, facets] = surface;
  const Cylindrical about{map_frame(query.direction), fit.point};
  Reach radii;
  for (const UndercutSample& sample : samples) radii.take(about.radius(glm::dvec3(sample.position)));
  const Reach heights = reach_along(samples, query.direction);
  for (const double advance : {edge_advance(model, facets, about), fit.advance}) {
    const double pitch = 2.0 * std::numbers::pi * std::abs(advance);
    // A ring of facets fits a helix of next to no pitch; one that is all but a straight pull would be
    // steeper.
    if (pitch < k_flattest * radii.greatest || pitch > k_steepest * radii.greatest) continue;
    for (const bool core_side : {true, false}) {
      const ScrewMotion motion = screw_out(heights, {fit.point, advance}, core_side, query);
      const double met = met_share(model, samples, motion);
      if (met > k_may_meet) continue;
      return Thread{.helix = {fit.point, advance},
                    .pitch = pitch,
                    .right_handed = advance > 0.0,
                    .core_side = core_side};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<HelixFit> fit_helix(std::span<const UndercutSample> samples, const glm::dvec3& direction) {
  if (samples.size() < k_least_turned_samples) return std::nullopt;
  const MapFrame frame = map_frame(direction);
  glm::dvec3 middle(0.0);
  for (const UndercutSample& sample : samples) middle += glm::dvec3(sample.position);
  middle /= static_cast<double>(samples.size());
  double size = 0.0;
  for (const UndercutSample& sample : samples)
    size = std::max(size, glm::distance(glm::dvec3(sample.position), middle));
  if (size <= 0.0) return std::nullopt;
  std::vector<glm::dvec4> rows;
  for (const UndercutSample& sample : samples) {
    const glm::dvec3 p = (glm::dvec3(sample.position) - middle) / size;
    const double u = glm::dot(p, frame.x), v = glm::dot(p, frame.y);
    const double nu = glm::dot(sample.normal, frame.x), nv = glm::dot(sample.normal, frame.y);
    rows.emplace_back(nv * u - nu * v, nu, -nv, glm::dot(sample.normal, frame.z));
  }
  // Where a thread runs out its surface leaves the helix: sums of absolute residuals, by weighted squares,
  // mind that less.
  SymmetricEigen<4> eigen;
  std::vector<double> weights(rows.size(), 1.0);
  for (int round = 0; round < k_rounds; ++round) {
    glm::dmat4 moments(0.0);
    for (std::size_t k = 0; k < rows.size(); ++k)
      moments += samples[k].area * weights[k] * glm::outerProduct(rows[k], rows[k]);
    eigen = symmetric_eigen<4>(moments);
    for (std::size_t k = 0; k < rows.size(); ++k)
      weights[k] = 1.0 / std::max(std::abs(glm::dot(rows[k], eigen.vectors[0])), k_least_residual);
  }
  // (w, w c_v, w c_u, k)
  const glm::dvec4 motion = eigen.vectors[0];
  const double ratio = eigen.values[1] > 0.0 ? std::max(0.0, eigen.values[0]) / eigen.values[1] : 1.0;
  if (ratio > k_most_ratio || std::abs(motion[0]) < k_least_rotation) return std::nullopt;
  const double cu = motion[2] / motion[0], cv = motion[1] / motion[0];
  const HelixFit fit{.point = middle + size * (cu * frame.x + cv * frame.y),
                     .advance = size * motion[3] / motion[0]};
  // A body of few sides is turned by no motion either, but is found from others as well.
  double squares = 0.0, total = 0.0;
  for (const UndercutSample& sample : samples) {
    const glm::dvec3 moves =
        glm::cross(direction, glm::dvec3(sample.position) - fit.point) + fit.advance * direction;
    const double off = glm::length(moves) > 0.0 ? glm::dot(sample.normal, glm::normalize(moves)) : 0.0;
    squares += sample.area * off * off;
    total += sample.area;
  }
  if (squares > k_most_square * total) return std::nullopt;
  return fit;
}

std::optional<Thread> find_thread(const PartModel& model, const RevolvedSurface& surface,
                                  const ExactQuery& query) {
  const auto fit = fit_surface(model, surface, query.direction);
  if (!fit) return std::nullopt;
  return thread_about(*fit, model, surface, query);
}

bool goes_with(const PartModel& model, const Thread& thread, const ThreadAndOther& samples,
               const ExactQuery& query) {
  constexpr double k_nearer = 0.1;  // to the axis, of the least radius, or farther
  const Cylindrical about{map_frame(query.direction), thread.helix.point};
  Reach radii;
  const auto inward = [&](std::span<const UndercutSample> surface) {
    double sum = 0.0;
    for (const UndercutSample& sample : surface) {
      const glm::dvec3 from = glm::dvec3(sample.position) - thread.helix.point;
      sum -= sample.area * glm::dot(sample.normal, from - glm::dot(from, query.direction) * query.direction);
    }
    return sum;
  };
  for (const UndercutSample& sample : samples.thread) radii.take(about.radius(glm::dvec3(sample.position)));
  const bool near = std::ranges::all_of(samples.other, [&](const UndercutSample& sample) {
    const double radius = about.radius(glm::dvec3(sample.position));
    return radius > (1.0 - k_nearer) * radii.least && radius < radii.greatest + k_nearer * radii.least;
  });
  if (!near || (inward(samples.thread) > 0.0) != (inward(samples.other) > 0.0)) return false;
  Reach heights = reach_along(samples.thread, query.direction);
  const Reach other = reach_along(samples.other, query.direction);
  heights.take(other.least);
  heights.take(other.greatest);
  return met_share(model, samples.other, screw_out(heights, thread.helix, thread.core_side, query)) <=
         k_may_meet;
}

std::optional<Ring> find_ring(const PartModel& model, const RevolvedSurface& surface,
                              const ExactQuery& query) {
  const std::span<const UndercutSample> samples = surface.samples;
  const auto fit = fit_surface(model, surface, query.direction);
  if (!fit) return std::nullopt;
  const Cylindrical about{map_frame(query.direction), fit->point};
  Reach radii;
  double inward = 0.0;
  for (const UndercutSample& sample : samples) {
    const glm::dvec3 from = glm::dvec3(sample.position) - fit->point;
    radii.take(about.radius(glm::dvec3(sample.position)));
    inward -= sample.area * glm::dot(sample.normal, from - glm::dot(from, query.direction) * query.direction);
  }
  if (std::abs(fit->advance) * 2.0 * std::numbers::pi > 0.01 * radii.greatest || !goes_round(about, samples))
    return std::nullopt;
  const bool inside = inward > 0.0;
  const Reach heights = reach_along(samples, query.direction);
  std::optional<Ring> best;
  for (const bool core_side : {true, false}) {
    if (inside &&
        model.rays().first_hit(glm::vec3(about.at(0.0, 0.0, 0.5 * (heights.least + heights.greatest))),
                               glm::vec3(core_side ? query.direction : -query.direction), false))
      continue;  // closed on this side
    // By perimeters, as far as rays to as many places of each show them: of the ring, and of what it must
    // pass, or what passes it, on the way out; inside the narrowest, outside the widest.
    constexpr int k_heights = 400, k_angles = 24;
    const double from = core_side ? heights.least : heights.greatest, end = core_side ? 0.5 : -0.5;
    double ring = 0.0, way = 0.0;
    for (int a = 0; a < k_angles; ++a) {
      const double angle = (a + 0.37) * 2.0 * std::numbers::pi / k_angles;
      const glm::dvec3 out = about.at(angle, 1.0, 0.0) - about.at(angle, 0.0, 0.0);
      Reach deep, passed;
      for (int h = 0; h <= k_heights; ++h) {
        const double height = from + (end - from) * h / k_heights;
        const glm::dvec3 start = about.at(angle, inside ? 0.0 : 1.0, height);
        const auto hit = model.rays().first_hit(glm::vec3(start), glm::vec3(inside ? out : -out), true);
        if (!hit) continue;
        const double distance = static_cast<double>(hit->distance);
        passed.take(inside ? distance : 1.0 - distance);
        if (height >= heights.least && height <= heights.greatest)
          deep.take(inside ? distance : 1.0 - distance);
      }
      ring += inside ? deep.greatest : deep.least;
      way += inside ? passed.least : passed.greatest;
    }
    const double strain = inside ? (ring - way) / way : (way - ring) / way;
    if (!std::isfinite(strain) || way <= 0.0) continue;
    if (!best || strain < best->strain)
      best = Ring{*fit, std::max(0.0, strain), std::abs(ring - way) / k_angles, core_side};
  }
  return best;
}

}  // namespace moldlight
