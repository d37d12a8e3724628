// The list of the shared real parts and what is known of them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace moldlight::test {

struct ManifestRow {
  std::string file;                       // relative to the folder of parts
  std::string format;                     // "STL binary", "STL ascii", "OBJ", "PLY ascii", "3MF", …
  std::optional<std::size_t> facets;      // triangles; none where the file cannot be read
  std::string defects;                    // "bnd 0 nonman 3 flip 0 …": counts of edges and facets
  std::optional<std::size_t> vertices;    // after welding equal ones
  std::optional<std::size_t> components;  // connected by edges
  std::optional<double> signed_volume;    // five digits

  /// The number after `name` in `defects`; none where it is not given.
  [[nodiscard]] std::optional<std::size_t> defect_count(const std::string& name) const;
};

/// Rows of parts/manifest.tsv in the shared folder; empty without one.
[[nodiscard]] std::vector<ManifestRow> read_manifest();

}  // namespace moldlight::test
