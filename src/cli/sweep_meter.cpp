#include "cli/sweep_meter.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "session/sweep/sweep_stages.hpp"

namespace moldlight::cli {

namespace {

constexpr double k_feature_candidates = 200.0;  // as most parts have
constexpr double k_probes_per_basin = 30.0;
constexpr double k_contenders_per_listed = 6.0;
constexpr int k_least_columns_for_bar = 70;
constexpr std::size_t k_bar_cells = 24;

/// Milliseconds a direction, measured on two cores.
struct Costs {
  double score, probe, closer, final;
};
constexpr Costs k_ray_costs{0.3, 2.0, 10.0, 550.0};
constexpr Costs k_map_costs{12.0, 12.0, 40.0, 2500.0};

std::string time_text(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

std::string bar(double share) {
  const auto full = static_cast<std::size_t>(share * static_cast<double>(k_bar_cells));
  std::string cells;
  for (std::size_t i = 0; i < k_bar_cells; ++i) cells += i < full ? "█" : "░";
  return cells;
}

}  // namespace

SweepMeter::SweepMeter(const SweepSettings& settings) {
  const Costs& cost = settings.engine == SweepEngine::gl ? k_map_costs : k_ray_costs;
  const double top = settings.top;
  stages_ = {Stage{sweep_stage::k_candidates, 20.0},
             Stage{sweep_stage::k_scoring, cost.score * (settings.directions + k_feature_candidates)},
             Stage{sweep_stage::k_refining, cost.probe * k_probes_per_basin * settings.refine},
             Stage{sweep_stage::k_closer, cost.closer * k_contenders_per_listed * top},
             Stage{sweep_stage::k_final, cost.final * top}};
}

double SweepMeter::share_done(std::string_view stage, double fraction) {
  double before = 0.0, all = 0.0;
  bool passed = false;
  for (const Stage& s : stages_) {
    if (s.name == stage) {
      before += s.cost * std::clamp(fraction, 0.0, 1.0);
      passed = true;
    }
    if (!passed) before += s.cost;
    all += s.cost;
  }
  if (passed) done_ = std::max(done_, before / all);
  return done_;
}

std::string SweepMeter::text(std::string_view stage, double fraction, int columns) {
  const double share = share_done(stage, fraction);
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
  const std::size_t scored = scored_;
  std::string text = columns >= k_least_columns_for_bar ? bar(share) + " " : "";
  text += fmt::format("{:3.0f} %  {}", 100.0 * share, stage);
  if (scored > 0) text += fmt::format(", {} directions", scored);
  if (scored > 0 && (stage == sweep_stage::k_scoring || stage == sweep_stage::k_refining)) {
    text += fmt::format(", {:.0f}/s", static_cast<double>(scored) / elapsed_s);
  }
  // Before that it would be a guess about guesses.
  if (elapsed_s > 1.0 && share > 0.03) {
    text += fmt::format(", about {} left", time_text(elapsed_s * (1.0 - share) / share));
  }
  return text;
}

}  // namespace moldlight::cli
