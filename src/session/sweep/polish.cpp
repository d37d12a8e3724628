#include "session/sweep/polish.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "mold/sweep/sphere_search.hpp"
#include "session/sweep/basin_search.hpp"

namespace moldlight {

namespace {

// Of the part's area: what is worse than the best by more is not polished.
constexpr double k_polished_share = 0.003;
constexpr double k_ring_deg = 0.8, k_step_deg = 0.4;
constexpr int k_rings = 3;
constexpr std::size_t k_most_polished = 3, k_most_told_apart = 7;
// Samples of the coarse pool over the first scoring's, and of the fine one over those.
constexpr int k_fine_factor = 4;

/// What is said of a direction that a polished one started from.
CandidateSource polished_source(const Candidate& start, const glm::dvec3& direction) {
  const CandidateSource& source = start.sources.front();
  if (source.kind == CandidateKind::refined) return source;
  return {CandidateKind::refined,
          fmt::format("downhill from {}, {:.2f}° away", source.reason,
                      line_angle_deg(start.direction, direction)),
          0.0};
}

/// The direction itself, and others evenly around it.
std::vector<glm::dvec3> directions_around(const glm::dvec3& direction) {
  std::vector<glm::dvec3> around = {direction};
  for (int ring = 1; ring <= k_rings; ++ring) {
    for (const glm::dvec3& probe : ring_around(direction, ring * k_ring_deg, 6 * ring, 0.0)) {
      around.push_back(half_sphere(probe));
    }
  }
  return around;
}

/// Contenders with the sources of `like`; empty if stopped.
std::vector<Contender> scored_by(const Polishing& polishing, ScoringPool& pool, const Candidate& like,
                                 const std::vector<glm::dvec3>& directions) {
  std::vector<ScoringTask> tasks;
  for (const glm::dvec3& direction : directions) tasks.push_back({.direction = direction});
  const auto scores = pool.score(tasks, [&] { return polishing.watch.stopped(); }, {});
  std::vector<Contender> scored;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    if (!scores[k]) return {};
    const Candidate candidate{.direction = directions[k], .sources = like.sources};
    scored.push_back({candidate, *scores[k], polishing.judge.scored(candidate, *scores[k])});
  }
  return scored;
}

/// What was found by search and may be the best. Features of the part stay what they are.
std::vector<std::size_t> contenders_to_polish(const Polishing& polishing,
                                              std::span<const Contender> contenders,
                                              std::span<const std::size_t> order) {
  const DirectionJudge& judge = polishing.judge;
  const double limit = judge.value(contenders[order.front()].figures) +
                       judge.value_of_undercut(k_polished_share * polishing.total_area);
  std::vector<std::size_t> chosen;
  for (const std::size_t i : order) {
    const Contender& contender = contenders[i];
    if (contender.figures.exact || judge.value(contender.figures) > limit) continue;
    const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
      return line_angle_deg(contenders[other].candidate.direction, contender.candidate.direction) >
             polishing.settings.apart_deg;
    });
    if (apart && chosen.size() < k_most_polished) chosen.push_back(i);
  }
  return chosen;
}

/// Pools of the same samples for all directions, of few and of many.
struct PolishingPools {
  std::unique_ptr<ScoringPool> coarse, fine;
};

/// The best direction around the start and downhill of it, the start itself where none is better; empty if
/// stopped.
std::optional<glm::dvec3> best_around(const Polishing& polishing, const PolishingPools& pools,
                                      const Candidate& start) {
  const auto better = [&](const Contender& a, const Contender& b) {
    return polishing.judge.value(a.figures) < polishing.judge.value(b.figures);
  };
  std::vector<Contender> around =
      scored_by(polishing, *pools.coarse, start, directions_around(start.direction));
  if (around.empty()) return std::nullopt;
  for (std::size_t k = 1; k < around.size(); ++k) {
    polishing.evaluated(
        evaluated_direction(around[k].candidate.direction, CandidateKind::refined, around[k].score));
  }
  std::stable_sort(around.begin() + 1, around.end(), better);
  around.resize(std::min(around.size(), k_most_told_apart));
  std::vector<glm::dvec3> directions;
  for (const Contender& contender : around) directions.push_back(contender.candidate.direction);
  const BasinSearch search{.judge = polishing.judge,
                           .pool = *pools.coarse,
                           .watch = polishing.watch,
                           .evaluated = polishing.evaluated,
                           .first_step_deg = k_step_deg};
  const std::size_t lowest = better(around[1], around[0]) ? 1 : 0;
  const std::vector<std::size_t> order = {0};
  for (const Contender& found : refine_basins(search, {&around[lowest], 1}, order, 1)) {
    directions.push_back(found.candidate.direction);
  }
  const std::vector<Contender> last = scored_by(polishing, *pools.fine, start, directions);
  if (last.empty()) return std::nullopt;
  return std::min_element(last.begin(), last.end(), better)->candidate.direction;
}

}  // namespace

void polish(const Polishing& polishing, std::vector<Contender>& contenders,
            std::span<const std::size_t> order) {
  const std::vector<std::size_t> chosen = contenders_to_polish(polishing, contenders, order);
  if (chosen.empty()) return;
  const int samples = polishing.settings.scoring_samples * k_fine_factor;
  const PolishingPools pools{.coarse = polishing.engine.make_same_samples_pool(samples),
                             .fine = polishing.engine.make_same_samples_pool(samples * k_fine_factor)};
  for (const std::size_t i : chosen) {
    const Candidate start = contenders[i].candidate;
    const std::optional<glm::dvec3> best = best_around(polishing, pools, start);
    if (!best) return;
    if (*best == start.direction) continue;
    const Candidate polished{.direction = *best, .sources = {polished_source(start, *best)}};
    const std::vector<Contender> again = scored_by(polishing, polishing.closer, polished, {*best});
    if (again.empty()) return;
    contenders[i] = again.front();
  }
}

}  // namespace moldlight
