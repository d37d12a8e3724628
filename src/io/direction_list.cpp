#include "io/direction_list.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/error.hpp"
#include "io/file_contents.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {
namespace {

/// First word of `line`, taken off it with the separators around it.
std::string_view take_word(std::string_view& line) {
  constexpr std::string_view k_separators = " \t,;";
  line.remove_prefix(std::min(line.find_first_not_of(k_separators), line.size()));
  const std::string_view word = line.substr(0, std::min(line.find_first_of(k_separators), line.size()));
  line.remove_prefix(word.size());
  return word;
}

std::optional<glm::dvec3> parse_direction(std::string_view line) {
  glm::dvec3 direction(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto number = parse_number(take_word(line));
    if (!number || !std::isfinite(*number)) return std::nullopt;
    direction[axis] = *number;
  }
  const double length = glm::length(direction);
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  return direction;
}

}  // namespace

std::vector<glm::dvec3> directions_in(std::string_view text, const std::string& path) {
  TextScanner scanner(text);
  std::vector<glm::dvec3> directions;
  bool may_be_names = true;
  while (!scanner.at_end()) {
    const std::string_view line = scanner.rest_of_line();
    if (line.empty() || line.starts_with('#')) continue;
    const auto direction = parse_direction(line);
    std::string_view rest = line;
    const bool is_names = may_be_names && !direction && !parse_number(take_word(rest));
    may_be_names = false;
    if (is_names) continue;
    if (!direction) {
      throw FileError(
          path, fmt::format("line {}", scanner.line()),
          fmt::format("{} is no direction; write three numbers x, y, z, not all zero", in_quotes(line)));
    }
    directions.push_back(*direction);
  }
  if (directions.empty()) throw FileError(path, "", "holds no direction; write one a line: x, y, z");
  return directions;
}

std::vector<glm::dvec3> read_directions(const std::string& path, const Progress& progress) {
  const FileContents contents(path, progress);
  return directions_in(contents.bytes(), path);
}

}  // namespace moldlight
