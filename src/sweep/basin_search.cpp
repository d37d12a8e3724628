#include "sweep/basin_search.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "mold/map_frame.hpp"
#include "sweep/sweep_stages.hpp"

namespace moldlight {

namespace {

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
  double step_deg = 0.0;
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
    basins.push_back({.best = start.candidate.direction,
                      .score = {},
                      .value = 0.0,
                      .step_deg = k_first_step_deg,
                      .origin = i});
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

Probes probes_of_round(const BasinSearch& search, std::span<const Basin> basins, int round) {
  Probes probes;
  // Alternate rings are turned by half a probe, so that a narrow valley is not missed twice.
  const double phase_deg = round % 2 == 0 ? 0.0 : 180.0 / k_probes;
  for (std::size_t b = 0; b < basins.size(); ++b) {
    if (basins[b].step_deg < k_last_step_deg || basins[b].value <= 0.0 || met_another(basins, b)) continue;
    const double limit = search.rating.by_undercut_alone() ? basins[b].score.undercut()
                                                           : std::numeric_limits<double>::infinity();
    for (const glm::dvec3& probe : ring_around(basins[b].best, basins[b].step_deg, k_probes, phase_deg)) {
      probes.tasks.push_back({probe, limit, &basins[b].score});
      probes.basin.push_back(b);
    }
  }
  return probes;
}

/// A basin adds nothing that ends beside a direction that is as good, or beside a feature's that may be:
/// closer scoring decides between what was found by search.
bool adds_nothing(const BasinSearch& search, const Basin& basin, std::span<const Contender> contenders) {
  return std::any_of(contenders.begin(), contenders.end(), [&](const Contender& other) {
    const double noise =
        other.figures.exact ? basin.score.undercut_error + other.figures.undercut_uncertainty : 0.0;
    return line_angle_deg(basin.best, other.candidate.direction) < k_same_basin_deg &&
           other.figures.value <= basin.value + search.rating.value_of_undercut(noise);
  });
}

}  // namespace

std::vector<Contender> refine_basins(const BasinSearch& search, std::span<const Contender> contenders,
                                     std::span<const std::size_t> order, std::size_t most) {
  std::vector<Basin> basins = basins_to_refine(contenders, order, most);
  const auto stopped = [&] { return search.clock.stopped(); };
  std::vector<ScoringTask> starts;
  for (const Basin& basin : basins) starts.push_back({.direction = basin.best});
  const auto own = search.rays.score(starts, stopped, {});
  for (std::size_t b = 0; b < basins.size(); ++b) {
    if (!own[b]) return {};
    basins[b].score = *own[b];
    basins[b].value = search.rating.scored(contenders[basins[b].origin].candidate, *own[b]).value;
  }
  for (int round = 0; round < k_most_rounds && !stopped(); ++round) {
    const Probes probes = probes_of_round(search, basins, round);
    if (probes.tasks.empty()) break;
    search.clock.report(sweep_stage::k_refining, std::min(1.0, round / k_usual_rounds));
    const auto scores = search.rays.score(probes.tasks, stopped, {});
    std::vector<bool> improved(basins.size(), false);
    for (std::size_t i = 0; i < scores.size(); ++i) {
      if (!scores[i]) continue;
      const Candidate probe{.direction = half_sphere(probes.tasks[i].direction),
                            .sources = {{CandidateKind::refined, {}, 0.0}}};
      search.evaluated(evaluated_direction(probe.direction, CandidateKind::refined, *scores[i]));
      Basin& basin = basins[probes.basin[i]];
      const double value = search.rating.scored(probe, *scores[i]).value;
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
    if (adds_nothing(search, basin, contenders) || adds_nothing(search, basin, found)) continue;
    const Candidate& origin = contenders[basin.origin].candidate;
    Candidate refined{.direction = basin.best, .sources = {}};
    refined.sources.push_back({CandidateKind::refined,
                               fmt::format("downhill from {}, {:.2f}° away", origin.sources.front().reason,
                                           line_angle_deg(basin.best, origin.direction)),
                               0.0});
    const RankedFigures figures = search.rating.scored(refined, basin.score);
    found.push_back({std::move(refined), basin.score, figures, {}});
  }
  return found;
}

}  // namespace moldlight
