#include "session/option.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"

namespace moldlight {

namespace {

template <typename T>
T parse_number(std::string_view text, std::string_view what, std::string_view kind) {
  const auto value = number_from<T>(text.substr(text.starts_with('+') ? 1 : 0));
  if (!value) throw UsageError(fmt::format("{}: '{}' is not {}", what, text, kind));
  return *value;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

double parse_real(std::string_view text, std::string_view what) {
  const double value = parse_number<double>(trimmed(text), what, "a number");
  if (!std::isfinite(value)) throw UsageError(fmt::format("{}: '{}' is not a finite number", what, text));
  return value;
}

int parse_integer(std::string_view text, std::string_view what) {
  return parse_number<int>(trimmed(text), what, "a whole number");
}

glm::dvec3 parse_direction(std::string_view text, std::string_view what) {
  glm::dvec3 direction(0.0);
  std::string_view rest = text;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (axis == 2)) {
      throw UsageError(fmt::format("{}: '{}' is not a direction; write three numbers as X,Y,Z", what, text));
    }
    direction[axis] = parse_real(rest.substr(0, comma), what);
    rest = axis == 2 ? std::string_view() : rest.substr(comma + 1);
  }
  if (direction == glm::dvec3(0.0))
    throw UsageError(fmt::format("{}: the zero vector is no direction", what));
  return direction;
}

std::string real_text(double value) { return fmt::format("{}", value); }

}  // namespace moldlight
