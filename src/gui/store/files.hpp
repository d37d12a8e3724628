// Files of the window: the user's own state (XDG base directories), the parts and the documentation that come
// with the program, pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <nlohmann/json_fwd.hpp>

#include "base/file_watch.hpp"

namespace moldlight::gui {

/// $XDG_STATE_HOME/moldlight, else ~/.local/state/moldlight; nothing without a home. Need not exist yet.
[[nodiscard]] std::optional<std::filesystem::path> state_folder();

/// From the root; as it is where that is not to be found.
[[nodiscard]] std::string absolute_path(const std::string& path);

/// All bytes of a small text file; nothing where it cannot be read.
[[nodiscard]] std::optional<std::string> read_text(const std::filesystem::path& path);

/// The JSON document in the text; is_discarded() where the text is none, or nests deeper than anything that
/// the window reads.
[[nodiscard]] nlohmann::json parse_json(std::string_view text);

/// Replaces the file whole or not at all, and makes its folder. Throws FileError.
void write_text(const std::filesystem::path& path, const std::string& text);

/// Paths of the shipped parts, by name: beside the installed program or in the source tree; empty where they
/// are not found.
[[nodiscard]] std::vector<std::string> shipped_parts();

/// Opens the installed pages of the documentation in the user's browser. What was done, as a sentence: the
/// pages open on the desktop, or where they are, or that there are none.
[[nodiscard]] std::string open_documentation();

/// Where a user keeps pictures: $XDG_PICTURES_DIR, else ~/Pictures, else the home folder, else here.
[[nodiscard]] std::filesystem::path pictures_folder();
/// A path "folder/stem-01.png" with the first number under which there is no file.
[[nodiscard]] std::string free_name(const std::filesystem::path& folder, const std::string& stem);

/// A PNG of the window: RGBA8, rows from above; the alpha is ignored. The file is replaced whole or not at
/// all; throws FileError.
void write_picture(const std::string& path, const glm::ivec2& size, std::vector<std::uint8_t> rgba);

}  // namespace moldlight::gui
