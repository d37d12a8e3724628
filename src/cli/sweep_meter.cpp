#include "cli/sweep_meter.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "session/sweep/sweep_stages.hpp"

namespace moldlight::cli {

namespace {

constexpr int k_least_columns_for_bar = 70;
constexpr std::size_t k_bar_cells = 24;

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

std::string SweepMeter::text(std::string_view stage, double fraction, int columns) {
  const double share = done_ = std::max(done_, sweep_share_done(stage, fraction));
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
