// Files that belong to the program, found from its own place, so that an installation may stand anywhere.
#pragma once

#include <filesystem>
#include <optional>
#include <span>

namespace moldlight {

/// The first of the places that is there, each relative to the folder of the shared library of a module in
/// another program, then to that of the running program.
[[nodiscard]] std::optional<std::filesystem::path> own_file(std::span<const char* const> places);

}  // namespace moldlight
