// Where the user's own state is kept (XDG base directories).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace moldlight::gui {

/// $XDG_STATE_HOME/moldlight, else ~/.local/state/moldlight; nothing without a home. Need not exist yet.
[[nodiscard]] std::optional<std::filesystem::path> state_folder();

/// All bytes of a small text file; nothing where it cannot be read.
[[nodiscard]] std::optional<std::string> read_text(const std::filesystem::path& path);

/// Replaces the file whole or not at all, and makes its folder. Throws FileError.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace moldlight::gui
