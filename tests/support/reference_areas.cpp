#include "support/reference_areas.hpp"

#include <fstream>
#include <sstream>

namespace moldlight::test {

std::vector<ReferenceRow> read_reference_areas(const std::filesystem::path& csv) {
  std::vector<ReferenceRow> rows;
  std::ifstream in(csv);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    ReferenceRow row;
    std::getline(fields, row.part, ',');
    const auto number = [&] {
      std::string text;
      std::getline(fields, text, ',');
      return std::stod(text);
    };
    for (int axis = 0; axis < 3; ++axis) row.direction[axis] = number();
    row.tau_deg = number();
    row.lateral_tolerance = number();
    row.total = number();
    row.near_vertical = number();
    for (const Region region : {Region::core, Region::cavity, Region::both, Region::undercut}) {
      row.areas[region] = number();
    }
    row.undercut_error = number();
    rows.push_back(row);
  }
  return rows;
}

}  // namespace moldlight::test
