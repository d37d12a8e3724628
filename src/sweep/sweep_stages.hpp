// The stages of a sweep, as its progress names them, in their order.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace moldlight {

namespace sweep_stage {
inline constexpr std::string_view k_candidates = "finding candidates";
inline constexpr std::string_view k_scoring = "scoring";
inline constexpr std::string_view k_refining = "refining";
inline constexpr std::string_view k_measuring = "measuring the best";
inline constexpr std::string_view k_polishing = "polishing";
inline constexpr std::string_view k_final = "tilting the best";
}  // namespace sweep_stage

/// Share of a whole sweep's time that is over, [0, 1], by what the stages usually take.
[[nodiscard]] inline double sweep_share_done(std::string_view stage, double fraction) {
  struct Stage {
    std::string_view name;
    double share;
  };
  constexpr std::array<Stage, 6> k_stages = {{{sweep_stage::k_candidates, 0.02},
                                              {sweep_stage::k_scoring, 0.25},
                                              {sweep_stage::k_refining, 0.15},
                                              {sweep_stage::k_measuring, 0.18},
                                              {sweep_stage::k_polishing, 0.2},
                                              {sweep_stage::k_final, 0.2}}};
  double before = 0.0;
  for (const Stage& s : k_stages) {
    if (s.name == stage) return before + s.share * std::clamp(fraction, 0.0, 1.0);
    before += s.share;
  }
  return 0.0;
}

}  // namespace moldlight
