// Numbers in text.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace moldlight {

/// The number that the whole text spells, in C notation without a plus sign, whatever the locale; nothing for
/// other text and for a number that T does not hold.
template <typename T>
[[nodiscard]] std::optional<T> number_from(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "1 edge", "3 edges".
template <std::integral Count>
[[nodiscard]] std::string plural(Count count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

/// A figure for people: four digits without an exponent, but none below `least`, which says what rounding or
/// a tolerance leaves of it: "147.8", "12034", "< 0.002". Beyond 1e-9 and 1e12 there is no other way.
[[nodiscard]] inline std::string rounded(double value, double least = 0.0, int digits = 4) {
  const double size = std::abs(value);
  if (size == 0.0) return "0";
  if (size < least) {
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(least))));
    const double shown = std::ceil(least * std::pow(10.0, decimals)) / std::pow(10.0, decimals);
    return fmt::format("< {:.{}f}", shown, decimals);
  }
  if (!(size >= 1e-9 && size < 1e12)) return fmt::format("{:.{}g}", value, digits);
  const int decimals = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(size))));
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (decimals > 0) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

/// Median of values, the mean of the middle two of an even number; 0 of none.
[[nodiscard]] inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace moldlight
