#include "support/manifest.hpp"

#include <fstream>
#include <sstream>

#include "support/shared_parts.hpp"

namespace moldlight::test {

std::optional<std::size_t> ManifestRow::defect_count(const std::string& name) const {
  std::istringstream words(defects);
  std::string word;
  std::size_t count = 0;
  while (words >> word >> count) {
    if (word == name) return count;
  }
  return std::nullopt;
}

std::vector<ManifestRow> read_manifest() {
  std::vector<ManifestRow> rows;
  const auto shared = shared_folder();
  if (!shared) return rows;
  std::ifstream stream(*shared / "parts" / "manifest.tsv");
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::istringstream columns(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(columns, cell, '\t');) cells.push_back(cell);
    cells.resize(std::max<std::size_t>(cells.size(), 11));
    ManifestRow row;
    row.file = cells[0];
    row.format = cells[2];
    row.defects = cells[7];
    if (!cells[3].empty()) row.facets = std::stoull(cells[3]);
    if (!cells[5].empty()) row.vertices = std::stoull(cells[5]);
    if (!cells[8].empty()) row.components = std::stoull(cells[8]);
    if (!cells[10].empty()) row.signed_volume = std::stod(cells[10]);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace moldlight::test
