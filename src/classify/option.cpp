#include "classify/option.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/shown_text.hpp"
#include "base/similar_word.hpp"

namespace moldlight {

namespace {

template <typename T>
T parse_number(const GivenText& given, std::string_view kind) {
  std::string_view text = given.text;
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  const auto number = [](std::string_view digits) {
    return number_from<T>(digits.substr(digits.starts_with('+') ? 1 : 0));
  };
  if (const auto value = number(text)) return *value;
  std::string plain(text.substr(0, text.find_last_of("0123456789") + 1));  // without a unit
  if (const std::size_t comma = plain.find(','); comma != std::string::npos) plain[comma] = '.';
  throw UsageError(fmt::format("{}: '{}' is not {}{}", given.what, shown_text(text), kind,
                               number(plain) ? "; write " + plain : ""));
}

template <typename T>
[[noreturn]] void out_of_range(const GivenText& given, T min, T max, std::string_view more = "") {
  throw UsageError(
      fmt::format("{}: {} is out of range, {} to {}{}", given.what, shown_text(given.text), min, max, more));
}

}  // namespace

double parse_real(const GivenText& given) {
  const double value = parse_number<double>(given, "a number");
  if (!std::isfinite(value))
    throw UsageError(fmt::format("{}: '{}' is not a finite number", given.what, shown_text(given.text)));
  return value;
}

double parse_real(const GivenText& given, double min, double max) {
  const double value = parse_real(given);
  if (value < min || value > max) out_of_range(given, min, max);
  return value;
}

double parse_positive(const GivenText& given, double max) {
  const double value = parse_real(given);
  if (value <= 0.0)
    throw UsageError(fmt::format("{}: {} must be greater than 0", given.what, shown_text(given.text)));
  if (value > max)
    throw UsageError(
        fmt::format("{}: {} is out of range, up to {}", given.what, shown_text(given.text), max));
  return value;
}

int parse_integer(const GivenText& given, int min, int max, bool odd) {
  const int value = parse_number<int>(given, "a whole number");
  if (value < min || value > max || (odd && value % 2 == 0))
    out_of_range(given, min, max, odd ? ", odd" : "");
  return value;
}

bool parse_switch(const GivenText& given) {
  if (given.text == "on" || given.text == "off") return given.text == "on";
  throw UsageError(fmt::format("{}: '{}' is neither on nor off", given.what, shown_text(given.text)));
}

glm::dvec3 parse_direction(const GivenText& given) {
  glm::dvec3 direction(0.0);
  std::string_view rest = given.text;
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  while (rest.ends_with(' ')) rest.remove_suffix(1);
  const bool signed_axis = rest.size() == 2 && (rest[0] == '+' || rest[0] == '-');
  constexpr std::string_view k_axes = "xyzXYZ";
  const std::size_t named =
      signed_axis || rest.size() == 1 ? k_axes.find(rest.back()) : std::string_view::npos;
  if (named != std::string_view::npos) {
    direction[static_cast<int>(named % 3)] = rest[0] == '-' ? -1.0 : 1.0;
    return direction;
  }
  // Blanks separate, too: "0 0 1".
  std::string with_commas;
  if (rest.find(',') == std::string_view::npos) {
    for (const char c : rest) {
      const bool blank = c == ' ', fresh = with_commas.empty() || with_commas.back() == ',';
      if (!blank || !fresh) with_commas += blank ? ',' : c;
    }
    rest = with_commas;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (axis == 2)) {
      throw UsageError(
          fmt::format("{}: '{}' is not a direction; write three numbers as X,Y,Z, or an axis such as -y",
                      given.what, shown_text(given.text)));
    }
    direction[axis] = parse_real({rest.substr(0, comma), given.what});
    rest = axis == 2 ? std::string_view() : rest.substr(comma + 1);
  }
  if (direction == glm::dvec3(0.0))
    throw UsageError(fmt::format("{}: the zero vector is not a direction", given.what));
  return direction;
}

std::vector<glm::dvec3> parse_directions(const GivenText& given) {
  std::vector<glm::dvec3> directions;
  for (std::size_t begin = 0, end = 0; end < given.text.size(); begin = end + 1) {
    end = std::min(given.text.find('\n', begin), given.text.size());
    directions.push_back(parse_direction({given.text.substr(begin, end - begin), given.what}));
  }
  return directions;
}

int parse_word(const GivenText& given, const Words& words) {
  const auto word = std::find(words.begin(), words.end(), given.text);
  if (word != words.end()) return static_cast<int>(word - words.begin());
  throw UsageError(fmt::format("{}: '{}' is not one of {}{}", given.what, shown_text(given.text),
                               fmt::join(words, ", "), did_you_mean(given.text, words)));
}

Words parse_words(const GivenText& given, const Words& words) {
  if (given.text == "all") return words;
  Words chosen;
  for (std::size_t begin = 0, end = 0; given.text != "none" && end < given.text.size(); begin = end + 1) {
    end = std::min(given.text.find(',', begin), given.text.size());
    const std::string_view name = given.text.substr(begin, end - begin);
    const auto word = std::find(words.begin(), words.end(), name);
    if (word == words.end()) {
      throw UsageError(fmt::format("{}: '{}' is unknown; give all, none, or some of {}{}", given.what,
                                   shown_text(name), fmt::join(words, ", "), did_you_mean(name, words)));
    }
    if (std::find(chosen.begin(), chosen.end(), *word) == chosen.end()) chosen.push_back(*word);
  }
  return chosen;
}

std::string real_text(double value) { return fmt::format("{}", value); }

}  // namespace moldlight
