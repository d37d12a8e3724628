// The body of every fuzz target: one reader, bytes in memory, a part that holds what it promises or a
// FileError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/error.hpp"
#include "fuzz/check_part.hpp"
#include "io/readers.hpp"

namespace moldlight::fuzz {

inline constexpr std::size_t k_repaired_facets = 200;

template <typename Reader>
int run_reader(const Reader& reader, const std::uint8_t* data, std::size_t size) {
  static const std::string k_name = "fuzz";
  const ReadOptions options{.max_facets = 20'000};
  const Progress progress;
  FileContents contents(std::string_view(reinterpret_cast<const char*>(data), size));
  try {
    Part part = reader(ReadContext{k_name, contents, options, progress});
    // More facets try nothing new in health report and repair, and cost executions.
    if (part.mesh.facets.size() <= k_repaired_facets) {
      check_part(std::move(part));
    } else {
      check_lists(part);
    }
  } catch (const FileError& error) {
    CHECK(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}

}  // namespace moldlight::fuzz
