// The parts that the speed suite runs on.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace moldlight::bench {

struct PartFile {
  std::string name;
  std::string path;
};

/// Facets of the parts that the suite makes: an enclosure lid with snap hooks, windows and bosses, its facets
/// split into more; below its own 21,496 a cable clip.
inline constexpr std::size_t k_part_sizes[] = {5'000, 50'000, 500'000, 2'000'000};

/// Writes the part of about that many facets to the folder, as binary STL.
PartFile make_part(const std::filesystem::path& folder, std::size_t facets);

/// Where make_part writes it.
[[nodiscard]] PartFile part_file(const std::filesystem::path& folder, std::size_t facets);

/// Real parts beside the project, the smaller ones of those that are closed; none where there is no such
/// folder.
[[nodiscard]] std::vector<PartFile> real_parts();

}  // namespace moldlight::bench
