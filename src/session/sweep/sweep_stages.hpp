// The stages of a sweep, as its progress names them, in their order.
#pragma once

#include <string_view>

namespace moldlight {

namespace sweep_stage {
inline constexpr std::string_view k_candidates = "finding candidates";
inline constexpr std::string_view k_scoring = "scoring";
inline constexpr std::string_view k_refining = "refining";
inline constexpr std::string_view k_closer = "scoring closer";
inline constexpr std::string_view k_final = "classifying the best";
}  // namespace sweep_stage

}  // namespace moldlight
