// A setting of a table of options read and written as text.
#pragma once

#include <fmt/format.h>

#include "base/error.hpp"
#include "classify/option.hpp"

namespace moldlight {

namespace detail {

template <typename... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

inline std::string value_text(double value) { return real_text(value); }
inline std::string value_text(int value) { return fmt::format("{}", value); }
inline std::string value_text(bool value) { return value ? "on" : "off"; }
inline std::string value_text(std::string_view text) { return std::string(text); }
inline std::string value_text(const glm::dvec3& d) { return fmt::format("{},{},{}", d.x, d.y, d.z); }
inline std::string value_text(const std::vector<glm::dvec3>& directions) {
  std::string text;
  for (const glm::dvec3& d : directions) text += (text.empty() ? "" : "\n") + value_text(d);
  return text;
}
inline std::string value_text(const Words& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ","));
}
template <typename T>
std::string value_text(const std::optional<T>& value) {
  return value ? value_text(*value) : std::string();
}

}  // namespace detail

/// The setting's value as the command line takes it; empty for an unset one.
template <typename S>
[[nodiscard]] std::string option_text(const Option<S>& option, const S& settings) {
  return std::visit([&](const auto& kind) { return detail::value_text(kind.value(settings)); }, option.kind);
}

/// Sets from text as the command line takes it, or unsets by an empty one; throws UsageError that names the
/// option, the value and the range.
template <typename S>
void set_option(const Option<S>& option, S& settings, std::string_view text) {
  std::visit([&](const auto& kind) { kind.parse(settings, {text, option.flag}); }, option.kind);
}

}  // namespace moldlight
