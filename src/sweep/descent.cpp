#include "sweep/descent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "mold/map_frame.hpp"
#include "sweep/sweep_clock.hpp"

namespace moldlight {

namespace {

std::vector<CandidateSource> downhill_from(std::string_view origin, double angle_deg) {
  return {{CandidateKind::refined, fmt::format("downhill from {}, {:.2f}° away", origin, angle_deg), 0.0}};
}

constexpr double k_basin_separation_deg = 3.0;  // starts are at least so far apart
constexpr double k_same_basin_deg = 1.0;        // basins nearer than this have met
constexpr double k_first_step_deg = 2.0, k_last_step_deg = 0.5;
constexpr int k_probes = 6;  // directions around a basin's best in every round
constexpr int k_most_rounds = 60;
constexpr double k_usual_rounds = 10.0;  // of most searches, for the progress alone

struct Basin {
  glm::dvec3 best;
  DirectionScore score;
  double value = 0.0;  // of the objective
  double step_deg = k_first_step_deg;
  std::size_t origin = 0;  // contender
};

std::vector<Basin> basins_to_refine(std::span<const Contender> contenders, std::span<const std::size_t> order,
                                    std::size_t most) {
  std::vector<Basin> basins;
  for (const std::size_t i : order) {
    if (basins.size() >= most) break;
    const Contender& start = contenders[i];
    const bool apart = std::all_of(basins.begin(), basins.end(), [&](const Basin& basin) {
      return line_angle_deg(basin.best, start.candidate.direction) > k_basin_separation_deg;
    });
    if (!apart) continue;
    basins.push_back({.best = start.candidate.direction, .score = {}, .origin = i});
  }
  return basins;
}

/// True for a basin that has met one with a better start.
bool met_another(std::span<const Basin> basins, std::size_t b) {
  return std::any_of(basins.begin(), basins.begin() + static_cast<std::ptrdiff_t>(b),
                     [&](const Basin& other) {
                       return line_angle_deg(basins[b].best, other.best) < k_same_basin_deg &&
                              other.value <= basins[b].value;
                     });
}

struct Probes {
  std::vector<ScoringTask> tasks;
  std::vector<std::size_t> basin;  // of each task
};

Probes probes_of_round(const Descent& descent, std::span<const Basin> basins, int round) {
  Probes probes;
  // Alternate rings are turned by half a probe, so that a narrow valley is not missed twice.
  const double phase_deg = round % 2 == 0 ? 0.0 : 180.0 / k_probes;
  for (std::size_t b = 0; b < basins.size(); ++b) {
    if (basins[b].step_deg < k_last_step_deg || basins[b].value <= 0.0 || met_another(basins, b)) continue;
    const double limit = descent.rating.by_undercut_alone() ? basins[b].score.undercut() : k_no_limit;
    for (const glm::dvec3& probe : ring_around(basins[b].best, basins[b].step_deg, k_probes, phase_deg)) {
      probes.tasks.push_back({probe, limit, &basins[b].score});
      probes.basin.push_back(b);
    }
  }
  return probes;
}

/// A basin adds nothing that ends beside a direction that is as good, or beside a feature's that may be:
/// closer scoring decides between what was found by descent.
bool adds_nothing(const Descent& descent, const Basin& basin, std::span<const Contender> contenders) {
  return std::any_of(contenders.begin(), contenders.end(), [&](const Contender& other) {
    const double noise =
        other.figures.exact ? basin.score.undercut_error + other.figures.undercut_uncertainty : 0.0;
    return line_angle_deg(basin.best, other.candidate.direction) < k_same_basin_deg &&
           other.figures.value <= basin.value + descent.rating.value_of_undercut(noise);
  });
}

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

class Polish {
 public:
  Polish(const Descent& descent, const Contender& start) : descent_(descent), best_(start) {}

  Contender run() {
    // Scored once more, since scores of the engine are of no use here.
    const std::array own{ScoringTask{.direction = best_.candidate.direction}};
    best_.score = *descent_.rays.score(own, {}, {}).front();
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
    return descent_.rating.by_undercut_alone() && best_.figures.undercut <= 0.0;
  }

  bool try_ring(double angle_deg, int probes, bool turned) {
    return try_directions(
        ring_around(best_.candidate.direction, angle_deg, probes, turned ? 180.0 / probes : 0.0));
  }

  /// Goes to the best of them if it is better than what there is.
  bool try_directions(const std::vector<glm::dvec3>& directions) {
    if (is_free() || descent_.clock.stopped()) return false;
    std::vector<Probe> probes = not_surely_worse(directions);
    std::vector<ScoringTask> tasks;
    const double limit = descent_.rating.by_undercut_alone() ? best_.figures.undercut : k_no_limit;
    for (const Probe& probe : probes) tasks.push_back({probe.direction, limit});
    const auto measured = measure(tasks);
    bool moved = false;
    for (std::size_t k = 0; k < measured.size(); ++k) {
      if (!measured[k]) continue;
      Contender found{.candidate = {probes[k].direction, best_.candidate.sources},
                      .score = probes[k].score,
                      .figures = descent_.rating.measured(best_.candidate, *measured[k]),
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
    const double limit = descent_.rating.by_undercut_alone() ? best_.score.undercut() : k_no_limit;
    std::vector<ScoringTask> tasks;
    for (const glm::dvec3& direction : directions) tasks.push_back({direction, limit, &best_.score});
    const auto scores = descent_.rays.score(tasks, [&] { return descent_.clock.stopped(); }, {});
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
    descent_.evaluated(evaluated_direction(half_sphere(direction), CandidateKind::refined, score));
  }

  [[nodiscard]] std::vector<std::optional<MeasuredDirection>> measure(
      std::span<const ScoringTask> tasks) const {
    // What is undercut here is likely to be undercut beside it.
    return descent_.measurer.measure(tasks, best_.measured->undercut_facets, descent_.clock.until_cancelled(),
                                     [&] { return descent_.clock.stopped(); });
  }

  /// The mean normal of the planes across the direction is known far better than any one axis or plane's
  /// normal.
  struct PlanesAcross {
    glm::dvec3 mean;  // the direction itself where there are no planes
    double share;     // of the part's area
  };
  [[nodiscard]] PlanesAcross planes_across() const {
    const FacetGeometry& geometry = descent_.model.geometry;
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

  const Descent& descent_;
  Contender best_;
};

}  // namespace

std::vector<Contender> refine_basins(const Descent& descent, std::span<const Contender> contenders,
                                     std::span<const std::size_t> order, std::size_t most) {
  std::vector<Basin> basins = basins_to_refine(contenders, order, most);
  const auto stopped = [&] { return descent.clock.stopped(); };
  std::vector<ScoringTask> starts;
  for (const Basin& basin : basins) starts.push_back({.direction = basin.best});
  const auto own = descent.rays.score(starts, stopped, {});
  for (std::size_t b = 0; b < basins.size(); ++b) {
    if (!own[b]) return {};
    basins[b].score = *own[b];
    basins[b].value = descent.rating.scored(contenders[basins[b].origin].candidate, *own[b]).value;
  }
  for (int round = 0; round < k_most_rounds && !stopped(); ++round) {
    const Probes probes = probes_of_round(descent, basins, round);
    if (probes.tasks.empty()) break;
    descent.clock.report(sweep_stage::k_refining, std::min(1.0, round / k_usual_rounds));
    const auto scores = descent.rays.score(probes.tasks, stopped, {});
    std::vector<bool> improved(basins.size(), false);
    for (std::size_t i = 0; i < scores.size(); ++i) {
      if (!scores[i]) continue;
      const Candidate probe{.direction = half_sphere(probes.tasks[i].direction),
                            .sources = {{CandidateKind::refined, {}, 0.0}}};
      descent.evaluated(evaluated_direction(probe.direction, CandidateKind::refined, *scores[i]));
      Basin& basin = basins[probes.basin[i]];
      const double value = descent.rating.scored(probe, *scores[i]).value;
      if (value >= basin.value) continue;
      basin.value = value;
      basin.best = probe.direction;
      basin.score = *scores[i];
      improved[probes.basin[i]] = true;
    }
    for (std::size_t b = 0; b < basins.size(); ++b) {
      if (!improved[b]) basins[b].step_deg *= 0.5;
    }
  }

  std::vector<Contender> found;
  for (const Basin& basin : basins) {
    if (adds_nothing(descent, basin, contenders) || adds_nothing(descent, basin, found)) continue;
    const Candidate& origin = contenders[basin.origin].candidate;
    Candidate refined{basin.best, downhill_from(origin.sources.front().reason,
                                                line_angle_deg(basin.best, origin.direction))};
    const RankedFigures figures = descent.rating.scored(refined, basin.score);
    found.push_back({std::move(refined), basin.score, figures, {}});
  }
  return found;
}

std::optional<Contender> polish(const Descent& descent, const Contender& start) {
  Contender best = Polish(descent, start).run();
  const double angle_deg = line_angle_deg(start.candidate.direction, best.candidate.direction);
  if (angle_deg == 0.0) return std::nullopt;
  CandidateSource& source = best.candidate.sources.front();
  const bool left_feature = angle_deg > k_same_feature_deg && source.kind != CandidateKind::refined;
  const double gain = start.figures.value - best.figures.value;
  if (left_feature &&
      gain < descent.rating.value_of_undercut(k_feature_share * descent.model.geometry.total_area)) {
    return std::nullopt;
  }
  if (start.candidate.from_user() || left_feature) {
    const std::string origin = start.candidate.from_user() ? "the direction given" : source.reason;
    best.candidate.sources = downhill_from(origin, angle_deg);
    best.figures.exact = false;
  }
  return best;
}

}  // namespace moldlight
