#include "session/option.hpp"

#include <algorithm>
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

double parse_real(std::string_view text, std::string_view what, double min, double max) {
  const double value = parse_real(text, what);
  if (value < min || value > max)
    throw UsageError(fmt::format("{}: {} is out of range, {} to {}", what, text, min, max));
  return value;
}

double parse_positive(std::string_view text, std::string_view what, double max) {
  const double value = parse_real(text, what);
  if (value <= 0.0) throw UsageError(fmt::format("{}: {} must be greater than 0", what, text));
  if (value > max) throw UsageError(fmt::format("{}: {} is out of range, up to {}", what, text, max));
  return value;
}

int parse_integer(std::string_view text, std::string_view what, int min, int max, bool odd) {
  const int value = parse_number<int>(trimmed(text), what, "a whole number");
  if (value < min || value > max || (odd && value % 2 == 0)) {
    throw UsageError(
        fmt::format("{}: {} is out of range, {} to {}{}", what, text, min, max, odd ? ", odd" : ""));
  }
  return value;
}

bool parse_switch(std::string_view text, std::string_view what) {
  if (text != "on" && text != "off")
    throw UsageError(fmt::format("{}: '{}' is neither on nor off", what, text));
  return text == "on";
}

std::vector<glm::dvec3> parse_directions(std::string_view text, std::string_view what) {
  std::vector<glm::dvec3> directions;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    directions.push_back(parse_direction(text.substr(0, end), what));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return directions;
}

int parse_word(std::string_view text, std::string_view what, const Words& words) {
  const auto word = std::find(words.begin(), words.end(), text);
  if (word == words.end())
    throw UsageError(fmt::format("{}: '{}' is none of {}", what, text, fmt::join(words, ", ")));
  return static_cast<int>(word - words.begin());
}

Words parse_words(std::string_view text, std::string_view what, const Words& words) {
  if (text == "all") return words;
  Words chosen;
  if (text == "none") return chosen;
  for (std::size_t begin = 0, end = 0; end < text.size(); begin = end + 1) {
    end = std::min(text.find(',', begin), text.size());
    const auto word = std::find(words.begin(), words.end(), text.substr(begin, end - begin));
    if (word == words.end()) {
      throw UsageError(fmt::format("{}: '{}' is none of all, none, {}", what, text.substr(begin, end - begin),
                                   fmt::join(words, ", ")));
    }
    if (std::find(chosen.begin(), chosen.end(), *word) == chosen.end()) chosen.push_back(*word);
  }
  return chosen;
}

std::string real_text(double value) { return fmt::format("{}", value); }

}  // namespace moldlight
