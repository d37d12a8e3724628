#include "session/sweep/tilt_margin.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "mold/sweep/sphere_search.hpp"

namespace moldlight {

namespace {
constexpr int k_sides = 8;
constexpr double k_first_lean_deg = 0.05;
constexpr double k_relative_precision = 0.1;
}  // namespace

std::optional<TiltMargin> tilt_margin(ScoringPool& pool, const glm::dvec3& direction, double growth,
                                      const std::function<bool()>& stop) {
  double limit = std::numeric_limits<double>::infinity();
  const auto undercut_of = [&](const std::vector<glm::dvec3>& leaning) -> std::optional<std::vector<double>> {
    std::vector<ScoringTask> tasks;
    for (const glm::dvec3& lean : leaning) tasks.push_back({lean, limit});
    std::vector<double> undercuts;
    for (const auto& score : pool.score(tasks, stop, {})) {
      if (!score) return std::nullopt;
      undercuts.push_back(score->undercut());
    }
    return undercuts;
  };
  const auto own = undercut_of({direction});
  if (!own) return std::nullopt;
  limit = own->front() + growth;

  // All sides at once, wider and wider, until one of them has grown too much.
  double good_deg = 0.0, bad_deg = k_first_lean_deg;
  int side = -1;
  while (true) {
    const auto undercuts = undercut_of(ring_around(direction, bad_deg, k_sides, 0.0));
    if (!undercuts) return std::nullopt;
    const auto worst = std::max_element(undercuts->begin(), undercuts->end());
    if (*worst > limit) {
      side = static_cast<int>(worst - undercuts->begin());
      break;
    }
    good_deg = bad_deg;
    if (good_deg >= k_widest_tilt_deg) return TiltMargin{k_widest_tilt_deg, direction};
    bad_deg = std::min(2.0 * bad_deg, k_widest_tilt_deg);
  }
  while (bad_deg - good_deg > k_relative_precision * bad_deg && bad_deg > 0.1 * k_first_lean_deg) {
    const double middle_deg = 0.5 * (good_deg + bad_deg);
    const auto undercuts = undercut_of(ring_around(direction, middle_deg, k_sides, 0.0));
    if (!undercuts) return std::nullopt;
    const auto worst = std::max_element(undercuts->begin(), undercuts->end());
    if (*worst > limit) {
      bad_deg = middle_deg;
      side = static_cast<int>(worst - undercuts->begin());
    } else {
      good_deg = middle_deg;
    }
  }
  return TiltMargin{good_deg, ring_around(direction, bad_deg, k_sides, 0.0)[static_cast<std::size_t>(side)]};
}

}  // namespace moldlight
