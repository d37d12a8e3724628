// The parts that come with the program.
#pragma once

#include <string>
#include <vector>

namespace moldlight::gui {

/// Paths of the shipped parts, by name: beside the installed program or in the source tree; empty where they
/// are not found.
[[nodiscard]] std::vector<std::string> shipped_parts();

}  // namespace moldlight::gui
