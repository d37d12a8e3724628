// How often figures that follow a moving direction are measured.
#pragma once

#include <algorithm>

namespace moldlight {

/// Pause after measuring for `took_s`, in seconds: frames keep four fifths of the time as long as figures
/// still come more than ten times a second, and half of it in any case.
[[nodiscard]] constexpr double figure_pause_s(double took_s) {
  constexpr double k_period_s = 0.085;
  return std::min(4.0 * took_s, std::max(k_period_s - took_s, took_s));
}

}  // namespace moldlight
