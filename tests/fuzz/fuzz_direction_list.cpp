#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "base/error.hpp"
#include "io/csv_tables.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto directions =
        moldlight::directions_in(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    CHECK(!directions.empty());
    for (const glm::dvec3& direction : directions) {
      const double length = glm::length(direction);
      CHECK(std::isfinite(length) && length > 0.0);
    }
  } catch (const moldlight::FileError& error) {
    CHECK(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
