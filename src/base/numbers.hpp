// Numbers in text.
#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>

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

}  // namespace moldlight
