#include "sweep/polish.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "mold/map_frame.hpp"

namespace moldlight {

namespace {

// The wide rings mostly cost rays, the narrow ones exact figures.
struct Ring {
  double deg;
  int probes;
};
constexpr std::array k_rings = {Ring{2.4, 12}, Ring{1.2, 12}, Ring{0.6, 12},
                                Ring{0.3, 6},  Ring{0.15, 6}, Ring{0.07, 6}};
constexpr int k_most_polish_rounds = 20;
constexpr double k_first_polish_deg = 0.025, k_last_polish_deg = 5e-5, k_step_ratio = 0.25;
constexpr int k_step_probes = 6;
constexpr double k_least_across = 0.02;        // of the part's area: planes that fix the direction
constexpr double k_gain = 1e-9;                // of the objective; less is rounding
constexpr double k_across_cosine = 0.9999995;  // within 0.06 degrees
constexpr double k_same_feature_deg = 0.1;
/// Of the part's area: for less undercut than this a direction of a feature is not left.
constexpr double k_feature_share = 2e-5;

class Descent {
 public:
  Descent(const Polishing& polishing, const Contender& start) : polishing_(polishing), best_(start) {}

  Contender run() {
    // Scored once more, since scores of the engine are of no use here.
    const std::array own{ScoringTask{.direction = best_.candidate.direction}};
    best_.score = *polishing_.rays.score(own, {}, {}).front();
    const PlanesAcross planes = planes_across();
    try_directions({planes.mean});
    bool moved = true;
    for (int round = 0; moved && round < k_most_polish_rounds; ++round) {
      moved = false;
      for (const Ring& ring : k_rings) moved |= try_ring(ring.deg, ring.probes, round % 2 != 0);
    }
    // The surface of undercut areas is creased: a turned ring finds the way out of a crease that the first
    // one missed.
    const double last_step_deg =
        planes.share > k_least_across ? k_first_polish_deg * k_step_ratio : k_last_polish_deg;
    bool turned = false;
    for (double step_deg = k_first_polish_deg; step_deg > last_step_deg; turned = !turned) {
      if (!try_ring(step_deg, k_step_probes, turned)) step_deg *= k_step_ratio;
    }
    return best_;
  }

 private:
  [[nodiscard]] bool is_free() const {
    return polishing_.rating.by_undercut_alone() && best_.figures.undercut <= 0.0;
  }

  bool try_ring(double angle_deg, int probes, bool turned) {
    return try_directions(
        ring_around(best_.candidate.direction, angle_deg, probes, turned ? 180.0 / probes : 0.0));
  }

  /// Goes to the best of them if it is better than what there is.
  bool try_directions(const std::vector<glm::dvec3>& directions) {
    if (is_free() || polishing_.clock.stopped()) return false;
    std::vector<Probe> probes = not_surely_worse(directions);
    std::vector<ScoringTask> tasks;
    const double limit = polishing_.rating.by_undercut_alone() ? best_.figures.undercut : k_no_limit;
    for (const Probe& probe : probes) tasks.push_back({probe.direction, limit});
    const auto measured = measure(tasks);
    bool moved = false;
    for (std::size_t k = 0; k < measured.size(); ++k) {
      if (!measured[k]) continue;
      Contender found{.candidate = {probes[k].direction, best_.candidate.sources},
                      .score = probes[k].score,
                      .figures = polishing_.rating.measured(best_.candidate, *measured[k]),
                      .measured = {}};
      DirectionScore exact;
      exact.areas = measured[k]->classification.areas;
      exact.undercut_error = measured[k]->classification.uncertainty.rounding;
      note(found.candidate.direction, exact);
      if (found.figures.value >= best_.figures.value - k_gain) continue;
      found.measured = std::make_shared<const MeasuredDirection>(*measured[k]);
      best_ = std::move(found);
      moved = true;
    }
    return moved;
  }

  struct Probe {
    glm::dvec3 direction;
    DirectionScore score;
  };
  /// Directions with their scores by rays; all of them where the undercut is not what counts.
  [[nodiscard]] std::vector<Probe> not_surely_worse(const std::vector<glm::dvec3>& directions) const {
    const double limit = polishing_.rating.by_undercut_alone() ? best_.score.undercut() : k_no_limit;
    std::vector<ScoringTask> tasks;
    for (const glm::dvec3& direction : directions) tasks.push_back({direction, limit, &best_.score});
    const auto scores = polishing_.rays.score(tasks, [&] { return polishing_.clock.stopped(); }, {});
    std::vector<Probe> kept;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      if (!scores[k]) continue;
      if (scores[k]->given_up) {
        note(directions[k], *scores[k]);
      } else {
        kept.push_back({directions[k], *scores[k]});
      }
    }
    return kept;
  }

  void note(const glm::dvec3& direction, const DirectionScore& score) const {
    polishing_.evaluated(evaluated_direction(half_sphere(direction), CandidateKind::refined, score));
  }

  [[nodiscard]] std::vector<std::optional<MeasuredDirection>> measure(
      std::span<const ScoringTask> tasks) const {
    // What is undercut here is likely to be undercut beside it.
    return polishing_.measurer.measure(tasks, best_.measured->undercut_facets,
                                       polishing_.clock.until_cancelled(),
                                       [&] { return polishing_.clock.stopped(); });
  }

  /// The mean normal of the planes across the direction is known far better than any one axis or plane's
  /// normal.
  struct PlanesAcross {
    glm::dvec3 mean;  // the direction itself where there are no planes
    double share;     // of the part's area
  };
  [[nodiscard]] PlanesAcross planes_across() const {
    const FacetGeometry& geometry = polishing_.model.geometry;
    glm::dvec3 sum(0.0);
    for (std::size_t facet = 0; facet < geometry.areas.size(); ++facet) {
      const double sine = glm::dot(geometry.normals[facet], best_.candidate.direction);
      if (std::abs(sine) > k_across_cosine)
        sum += std::copysign(geometry.areas[facet], sine) * geometry.normals[facet];
    }
    const double area = glm::length(sum);
    if (area <= 0.0) return {best_.candidate.direction, 0.0};
    return {sum / area, area / geometry.total_area};
  }

  const Polishing& polishing_;
  Contender best_;
};

}  // namespace

std::optional<Contender> polish(const Polishing& polishing, const Contender& start) {
  Contender best = Descent(polishing, start).run();
  const double angle_deg = line_angle_deg(start.candidate.direction, best.candidate.direction);
  if (angle_deg == 0.0) return std::nullopt;
  CandidateSource& source = best.candidate.sources.front();
  const bool left_feature = angle_deg > k_same_feature_deg && source.kind != CandidateKind::refined;
  const double gain = start.figures.value - best.figures.value;
  if (left_feature &&
      gain < polishing.rating.value_of_undercut(k_feature_share * polishing.model.geometry.total_area)) {
    return std::nullopt;
  }
  if (start.candidate.from_user() || left_feature) {
    const std::string origin = start.candidate.from_user() ? "the direction given" : source.reason;
    best.candidate.sources = {
        {CandidateKind::refined, fmt::format("downhill from {}, {:.2f}° away", origin, angle_deg), 0.0}};
    best.figures.exact = false;
  }
  return best;
}

}  // namespace moldlight
