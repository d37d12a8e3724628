#include "session/sweep/tilt_margin.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <vector>

#include "mold/sweep/sphere_search.hpp"

namespace moldlight {

namespace {

constexpr int k_sides = 8;
/// Sides asked first, those that grew most before: mostly they settle it.
constexpr std::size_t k_asked_first = 2;
constexpr double k_first_lean_deg = 0.05;
constexpr double k_relative_precision = 0.1;

/// Asks for leans of one direction, whether the undercut has grown too much towards any side.
class LeanProbe {
 public:
  LeanProbe(ScoringPool& pool, const glm::dvec3& direction, const std::function<bool()>& stop)
      : pool_(pool), direction_(direction), stop_(stop) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
  }

  /// Sets the limit; false if stopped.
  bool measure_own(double growth) {
    const auto own = scores({{direction_}});
    if (!own) return false;
    limit_ = own->front() + growth;
    return true;
  }

  enum class Answer : std::uint8_t { within, grown, stopped };
  Answer ask(double lean_deg) {
    const std::vector<glm::dvec3> ring = ring_around(direction_, lean_deg, k_sides, 0.0);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return undercuts_[a] > undercuts_[b]; });
    for (std::size_t first = 0; first < order_.size(); first = first == 0 ? k_asked_first : order_.size()) {
      const std::size_t end = first == 0 ? k_asked_first : order_.size();
      std::vector<ScoringTask> tasks;
      for (std::size_t k = first; k < end; ++k) tasks.push_back({ring[order_[k]], limit_});
      const auto found = scores(tasks);
      if (!found) return Answer::stopped;
      for (std::size_t k = first; k < end; ++k) undercuts_[order_[k]] = (*found)[k - first];
      const auto worst = std::max_element(found->begin(), found->end());
      if (*worst <= limit_) continue;
      toward_ = ring[order_[first + static_cast<std::size_t>(worst - found->begin())]];
      return Answer::grown;
    }
    return Answer::within;
  }

  /// The lean that was last seen to have grown too much.
  [[nodiscard]] const glm::dvec3& toward() const { return toward_; }

 private:
  [[nodiscard]] std::optional<std::vector<double>> scores(const std::vector<ScoringTask>& tasks) {
    std::vector<double> undercuts;
    for (const auto& score : pool_.score(tasks, stop_, {})) {
      if (!score) return std::nullopt;
      undercuts.push_back(score->undercut());
    }
    return undercuts;
  }

  ScoringPool& pool_;
  glm::dvec3 direction_, toward_{0.0};
  const std::function<bool()>& stop_;
  double limit_ = std::numeric_limits<double>::infinity();
  std::array<std::size_t, k_sides> order_{};
  std::array<double, k_sides> undercuts_{};  // as last asked
};

}  // namespace

std::optional<TiltMargin> tilt_margin(ScoringPool& pool, const glm::dvec3& direction, double growth,
                                      const std::function<bool()>& stop) {
  LeanProbe probe(pool, direction, stop);
  if (!probe.measure_own(growth)) return std::nullopt;

  // Wider and wider, until some side has grown too much.
  double good_deg = 0.0, bad_deg = k_first_lean_deg;
  while (true) {
    const LeanProbe::Answer answer = probe.ask(bad_deg);
    if (answer == LeanProbe::Answer::stopped) return std::nullopt;
    if (answer == LeanProbe::Answer::grown) break;
    good_deg = bad_deg;
    if (good_deg >= k_widest_tilt_deg) return TiltMargin{k_widest_tilt_deg, direction};
    bad_deg = std::min(2.0 * bad_deg, k_widest_tilt_deg);
  }
  while (bad_deg - good_deg > k_relative_precision * bad_deg && bad_deg > 0.1 * k_first_lean_deg) {
    const double middle_deg = 0.5 * (good_deg + bad_deg);
    const LeanProbe::Answer answer = probe.ask(middle_deg);
    if (answer == LeanProbe::Answer::stopped) return std::nullopt;
    (answer == LeanProbe::Answer::grown ? bad_deg : good_deg) = middle_deg;
  }
  return TiltMargin{good_deg, probe.toward()};
}

}  // namespace moldlight
