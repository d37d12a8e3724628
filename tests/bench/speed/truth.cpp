#include "bench/speed/truth.hpp"

#include <cmath>

#include "base/check.hpp"
#include "sweep/candidates/candidate_sources.hpp"

namespace moldlight::bench {

double Truth::error(std::span<const double> undercuts_found) const {
  CHECK(undercuts_found.size() == undercuts.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < undercuts.size(); ++i) {
    const double off = (undercuts_found[i] - undercuts[i]) / total_area;
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(undercuts.size()));
}

std::vector<double> score_all(ScoringPool& pool, std::span<const glm::dvec3> directions) {
  std::vector<ScoringTask> tasks;
  for (const glm::dvec3& direction : directions) tasks.push_back({.direction = direction});
  std::vector<double> undercuts;
  for (const auto& score : pool.score(tasks, [] { return false; }, {})) {
    undercuts.push_back(score->undercut());
  }
  return undercuts;
}

std::vector<glm::dvec3> bench_directions(std::size_t uniform) {
  std::vector<glm::dvec3> directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<glm::dvec3> spread = fibonacci_half_sphere(uniform);
  directions.insert(directions.end(), spread.begin(), spread.end());
  return directions;
}

}  // namespace moldlight::bench
