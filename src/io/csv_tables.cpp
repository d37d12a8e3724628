#include "io/csv_tables.hpp"

#include <cmath>
#include <iterator>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_contents.hpp"
#include "io/text_scanner.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

namespace {

std::string heading(std::string_view number, std::string_view suffix) {
  std::string line = fmt::format("{},area", number);
  for (const Region region : k_regions) line += fmt::format(",{}{}", region_name(region), suffix);
  return line += '\n';
}

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

void write_facet_csv(const std::string& path, const FacetTable& table) {
  CHECK(table.areas.size() == table.fractions.size());
  CHECK(table.numbers.empty() || table.numbers.size() == table.areas.size());
  CHECK(table.order.empty() || table.order.size() == table.areas.size());
  AtomicFile file(path);
  file.write(heading("facet", ""));
  std::string row;
  for (std::size_t k = 0; k < table.areas.size(); ++k) {
    const std::size_t facet = table.order.empty() ? k : table.order[k];
    const std::uint64_t number = table.numbers.empty() ? facet : table.numbers[facet];
    const bool in_file = table.numbers.empty() || number != k_no_facet;
    row.clear();
    fmt::format_to(std::back_inserter(row), "{},{}", in_file ? static_cast<std::int64_t>(number) : -1,
                   table.areas[facet]);
    for (const double fraction : table.fractions[facet])
      fmt::format_to(std::back_inserter(row), ",{}", fraction);
    file.write(row += '\n');
  }
  file.commit();
}

void write_face_csv(const std::string& path, std::span<const SourceAreas> faces) {
  AtomicFile file(path);
  file.write(heading("face", "_share"));
  std::string row;
  for (const SourceAreas& face : faces) {
    const double area = face.areas.total();
    row.clear();
    fmt::format_to(std::back_inserter(row), "{},{}", face.source, area);
    for (const Region region : k_regions)
      fmt::format_to(std::back_inserter(row), ",{}", area > 0.0 ? face.areas[region] / area : 0.0);
    file.write(row += '\n');
  }
  file.commit();
}

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
          fmt::format("{} is not a direction; write three numbers x, y, z, not all zero", in_quotes(line)));
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
