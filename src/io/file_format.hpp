// Which format a part file has: by its content; by its name only where the content leaves it open.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace moldlight {

enum class FileFormat : std::uint8_t { stl_binary, stl_ascii, obj, ply, off, threemf, step };

/// Throws FileError for an empty file and for what is no part file of any known format.
[[nodiscard]] FileFormat detect_format(const std::string& path, std::string_view bytes);

/// "STL binary", "STL ASCII", "OBJ", "PLY", "OFF", "3MF", "STEP".
[[nodiscard]] std::string_view format_name(FileFormat format);

/// The name's extension in lower case without the dot; empty where there is none.
[[nodiscard]] std::string lower_extension(const std::string& path);

}  // namespace moldlight
