#include "sweep/tilt_margin.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "mold/map_frame.hpp"
#include "sweep/arena_threads.hpp"
#include "sweep/sweep_clock.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_sides = 8;
constexpr double k_first_lean_deg = 0.05, k_lean_ratio = 4.0;
constexpr double k_relative_precision = 0.1;

/// Leans of one direction.
class Leans {
 public:
  Leans(DirectionScorer& scorer, const glm::dvec3& direction, double growth)
      : scorer_(scorer),
        direction_(direction),
        own_(score({.direction = direction})),
        limit_(own_.undercut() + growth) {}

  [[nodiscard]] glm::dvec3 direction(std::size_t side, double deg) const {
    return ring_around(direction_, deg, k_sides, 0.0)[side];
  }
  /// By how much the undercut is above the limit.
  [[nodiscard]] double excess(std::size_t side, double deg) const {
    return score({direction(side, deg), limit_, &own_, true}).undercut() - limit_;
  }

 private:
  [[nodiscard]] DirectionScore score(const ScoringTask& task) const {
    return std::move(scorer_.score({&task, 1}).front());
  }

  DirectionScorer& scorer_;
  glm::dvec3 direction_;
  DirectionScore own_;
  double limit_;
};

}  // namespace

std::optional<TiltMargin> tilt_margin(DirectionScorer& scorer, const glm::dvec3& direction, double growth,
                                      const std::function<bool()>& stop) {
  if (stop()) return std::nullopt;
  const Leans leans(scorer, direction, growth);

  // Wider and wider, until some side has grown too much.
  double within_deg = 0.0, deg = k_first_lean_deg;
  std::vector<std::size_t> grown;  // sides, the worst first
  while (true) {
    std::array<double, k_sides> excess{};
    for (std::size_t side = 0; side < k_sides; ++side) {
      if (stop()) return std::nullopt;
      excess[side] = leans.excess(side, deg);
      if (excess[side] > 0.0) grown.push_back(side);
    }
    std::ranges::stable_sort(grown, std::greater{}, [&](std::size_t side) { return excess[side]; });
    if (!grown.empty()) break;
    if (deg >= k_widest_tilt_deg) return TiltMargin{k_widest_tilt_deg, direction};
    within_deg = deg;
    deg = std::min(k_lean_ratio * deg, k_widest_tilt_deg);
  }
  // The worst side is narrowed down; another one matters where it grows within that.
  double good_deg = within_deg, bad_deg = deg;
  glm::dvec3 toward(0.0);
  for (const std::size_t side : grown) {
    if (side != grown.front()) {
      if (leans.excess(side, good_deg) <= 0.0) continue;
      bad_deg = std::exchange(good_deg, within_deg);
    }
    while (bad_deg - good_deg > k_relative_precision * bad_deg && bad_deg > 0.1 * k_first_lean_deg) {
      if (stop()) return std::nullopt;
      const double middle_deg = 0.5 * (good_deg + bad_deg);
      (leans.excess(side, middle_deg) > 0.0 ? bad_deg : good_deg) = middle_deg;
    }
    toward = leans.direction(side, bad_deg);
  }
  return TiltMargin{good_deg, toward};
}

std::vector<std::optional<TiltMargin>> tilt_margins(SweepTools& tools,
                                                    std::span<const Contender> contenders) {
  std::vector<std::optional<TiltMargin>> margins(contenders.size());
  const double growth = tools.settings.tilt_growth_pct * 0.01 * tools.model.geometry.total_area;
  std::mutex mutex;
  std::size_t done = 0;
  tbb::task_arena arena(arena_threads(ScoringPool::threads(tools.settings.jobs)));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, contenders.size(), [&](std::size_t i) {
      const std::unique_ptr<DirectionScorer> scorer = tools.pools.make_ray_scorer();
      margins[i] = tilt_margin(*scorer, contenders[i].candidate.direction, growth,
                               [&] { return tools.clock.stopped(); });
      const std::lock_guard lock(mutex);
      tools.clock.report(sweep_stage::k_final,
                         static_cast<double>(++done) / static_cast<double>(contenders.size()));
    });
  });
  return margins;
}

}  // namespace moldlight
