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
inline constexpr std::string_view k_proving = "proving";  // its fraction is what is decided
inline constexpr std::string_view k_actions = "finding side actions";
inline constexpr std::string_view k_final = "tilting the best";
}  // namespace sweep_stage

/// Share of a whole sweep's time that is over, [0, 1], by what the stages usually take. Side actions, where
/// they are sought, take more than all the rest.
[[nodiscard]] inline double sweep_share_done(std::string_view stage, double fraction, bool with_actions) {
  struct Stage {
    std::string_view name;
    double share;
  };
  constexpr double k_of_actions = 0.6;
  constexpr std::array<Stage, 8> k_stages = {{{sweep_stage::k_candidates, 0.02},
                                              {sweep_stage::k_scoring, 0.25},
                                              {sweep_stage::k_refining, 0.15},
                                              {sweep_stage::k_measuring, 0.18},
                                              {sweep_stage::k_polishing, 0.15},
                                              {sweep_stage::k_proving, 0.05},
                                              {sweep_stage::k_actions, 0.0},
                                              {sweep_stage::k_final, 0.2}}};
  double before = 0.0;
  for (const Stage& s : k_stages) {
    double share = with_actions ? (1.0 - k_of_actions) * s.share : s.share;
    if (with_actions && s.name == sweep_stage::k_actions) share = k_of_actions;
    if (s.name == stage) return before + share * std::clamp(fraction, 0.0, 1.0);
    before += share;
  }
  return 0.0;
}

}  // namespace moldlight
