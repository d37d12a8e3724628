#include "io/facet_csv.hpp"

#include <iterator>

#include <fmt/format.h>

#include "base/check.hpp"
#include "io/atomic_file.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

namespace {

std::string heading(std::string_view number, std::string_view suffix) {
  std::string line = fmt::format("{},area", number);
  for (const Region region : k_regions) line += fmt::format(",{}{}", region_name(region), suffix);
  return line += '\n';
}

}  // namespace

void write_facet_csv(const std::string& path, const FacetTable& table) {
  CHECK(table.areas.size() == table.fractions.size());
  CHECK(table.numbers.empty() || table.numbers.size() == table.areas.size());
  AtomicFile file(path);
  file.write(heading("facet", ""));
  std::string row;
  for (std::size_t facet = 0; facet < table.areas.size(); ++facet) {
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
    for (const Region region : k_regions) {
      fmt::format_to(std::back_inserter(row), ",{}", area > 0.0 ? face.areas[region] / area : 0.0);
    }
    file.write(row += '\n');
  }
  file.commit();
}

}  // namespace moldlight
