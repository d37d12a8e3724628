#include "session/sweep/tilt_margin.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "mold/map_frame.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_sides = 8;
constexpr double k_first_lean_deg = 0.05, k_lean_ratio = 4.0;
constexpr double k_relative_precision = 0.1;

/// Leans of one direction.
class Leans {
 public:
  Leans(ScoringPool& pool, const glm::dvec3& direction, const std::function<bool()>& stop)
      : pool_(pool), direction_(direction), stop_(stop) {}

  /// Sets the limit; false if stopped.
  bool measure_own(double growth) {
    const auto own = pool_.score(std::array{ScoringTask{.direction = direction_}}, stop_, {});
    if (!own.front()) return false;
    own_ = *own.front();
    limit_ = own_.undercut() + growth;
    return true;
  }

  struct Lean {
    std::size_t side;
    double deg;
  };
  [[nodiscard]] glm::dvec3 direction(const Lean& lean) const {
    return ring_around(direction_, lean.deg, k_sides, 0.0)[lean.side];
  }
  /// By how much the undercut is above the limit, a figure a lean; empty if stopped.
  [[nodiscard]] std::vector<double> excess(const std::vector<Lean>& leans) const {
    std::vector<ScoringTask> tasks;
    for (const Lean& lean : leans) tasks.push_back({direction(lean), limit_, &own_, true});
    std::vector<double> excess;
    for (const auto& score : pool_.score(tasks, stop_, {})) {
      if (!score) return {};
      excess.push_back(score->undercut() - limit_);
    }
    return excess;
  }

 private:
  ScoringPool& pool_;
  glm::dvec3 direction_;
  const std::function<bool()>& stop_;
  DirectionScore own_;
  double limit_ = 0.0;
};

}  // namespace

std::optional<TiltMargin> tilt_margin(ScoringPool& pool, const glm::dvec3& direction, double growth,
                                      const std::function<bool()>& stop) {
  Leans leans(pool, direction, stop);
  if (!leans.measure_own(growth)) return std::nullopt;

  // Wider and wider, until some side has grown too much.
  double within_deg = 0.0, deg = k_first_lean_deg;
  std::vector<std::size_t> grown;  // sides, the worst first
  while (true) {
    std::vector<Leans::Lean> ring;
    for (std::size_t side = 0; side < k_sides; ++side) ring.push_back({side, deg});
    const std::vector<double> excess = leans.excess(ring);
    if (excess.empty()) return std::nullopt;
    for (std::size_t side = 0; side < k_sides; ++side) {
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
      const std::vector<double> excess = leans.excess({{side, good_deg}});
      if (excess.empty()) return std::nullopt;
      if (excess.front() <= 0.0) continue;
      bad_deg = std::exchange(good_deg, within_deg);
    }
    while (bad_deg - good_deg > k_relative_precision * bad_deg && bad_deg > 0.1 * k_first_lean_deg) {
      const double quarter_deg = 0.25 * (bad_deg - good_deg);
      std::vector<Leans::Lean> between;
      for (const double k : {1.0, 2.0, 3.0}) between.push_back({side, good_deg + k * quarter_deg});
      const std::vector<double> excess = leans.excess(between);
      if (excess.empty()) return std::nullopt;
      const auto first = std::ranges::find_if(excess, [](double value) { return value > 0.0; });
      if (first != excess.end()) bad_deg = between[static_cast<std::size_t>(first - excess.begin())].deg;
      if (first != excess.begin()) good_deg = bad_deg - quarter_deg;
    }
    toward = leans.direction({side, bad_deg});
  }
  return TiltMargin{good_deg, toward};
}

}  // namespace moldlight
