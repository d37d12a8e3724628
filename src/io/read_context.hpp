// Input of every reader: the file's bytes, the limits, and how to fail with the place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "io/file_contents.hpp"
#include "io/read_options.hpp"

namespace moldlight {

struct ReadContext {
  const std::string& path;
  FileContents& contents;
  const ReadOptions& options;
  const Progress& progress;

  [[nodiscard]] std::string_view bytes() const { return contents.bytes(); }

  /// Throws FileError for a place such as "line 12"; the text is formatted as by fmt::format.
  template <typename... Args>
  [[noreturn]] void fail(const std::string& place, fmt::format_string<Args...> what, Args&&... args) const {
    throw FileError(path, place, fmt::format(what, std::forward<Args>(args)...));
  }

  /// Throws where `facets` exceeds the limit of the options.
  void check_facet_count(std::uint64_t facets) const {
    if (facets <= static_cast<std::uint64_t>(options.max_facets)) return;
    fail("", "holds more facets than the limit of {}; raise the limit (--max-facets) if they are meant",
         options.max_facets);
  }
};

/// Most vertices that a mesh can number.
inline constexpr std::uint32_t k_max_vertices = 0xffff'fffe;

/// Largest coordinate magnitude that is read; the sixth power of it, as volumes of volumes need it, is still
/// finite.
inline constexpr double k_max_coordinate = 1e30;

/// False for NaN, infinity and what is beyond k_max_coordinate.
[[nodiscard]] inline bool is_usable_coordinate(double value) {
  return value <= k_max_coordinate && value >= -k_max_coordinate;
}
[[nodiscard]] inline bool is_usable_point(const glm::dvec3& point) {
  return is_usable_coordinate(point.x) && is_usable_coordinate(point.y) && is_usable_coordinate(point.z);
}

}  // namespace moldlight
