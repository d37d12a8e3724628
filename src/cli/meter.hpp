// Pieces of a line of progress.
#pragma once

#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace moldlight::cli {

/// A terminal with fewer columns has no room for a bar.
inline constexpr int k_least_columns_for_bar = 70;

/// "45 s", "12 min", "3.5 h"
[[nodiscard]] inline std::string time_text(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

/// A bar for a share in [0, 1].
[[nodiscard]] inline std::string bar(double share) {
  constexpr std::size_t k_cells = 24;
  const auto full = static_cast<std::size_t>(share * static_cast<double>(k_cells));
  std::string cells;
  for (std::size_t i = 0; i < k_cells; ++i) cells += i < full ? "█" : "░";
  return cells;
}

}  // namespace moldlight::cli
