// What a mistyped word may have meant.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace moldlight {

/// "; did you mean sweep?", after an error: the known word that is at most two letters off; empty where none
/// is. The advice, if any, follows: "; did you mean sweep? advice", "; advice".
[[nodiscard]] std::string did_you_mean(std::string_view typed, std::span<const std::string_view> known,
                                       std::string_view advice = {});
[[nodiscard]] std::string did_you_mean(std::string_view typed, const std::vector<std::string>& known,
                                       std::string_view advice = {});

}  // namespace moldlight
