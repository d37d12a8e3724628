// Reading VTK's XML PolyData as far as the program writes it: appended arrays of raw numbers.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace moldlight::test {

struct VtpArrayRead {
  std::string type;            // "Int32", …
  std::vector<double> values;  // whole numbers, too
};

struct Vtp {
  TriangleMesh mesh;
  std::map<std::string, VtpArrayRead> of_facets;
};

/// Throws std::runtime_error where sizes do not fit each other.
[[nodiscard]] Vtp read_vtp(std::string_view bytes);

}  // namespace moldlight::test
