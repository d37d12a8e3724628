// The one table of the formats of part files, and which of them a file has: by its content; by its name only
// where the content leaves it open.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "io/read_options.hpp"
#include "io/readers.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// Everything that the program knows of a format but how it is read.
struct PartFormat {
  std::string_view name;                     // "STL binary"
  std::vector<std::string_view> extensions;  // in lower case; the first in capitals is its name in lists
  bool binary;                               // never text, which distinguishes formats of one extension
  /// Each is null where the format has no such sign. `magic`: the beginning leaves no doubt. `words`: a text
  /// that begins so is one of it. `refuse`: throws FileError for a file that has its name but not its magic.
  bool (*magic)(const FileBeginning& file);
  bool (*words)(std::string_view first, std::string_view second);
  void (*refuse)(const std::string& path, const FileBeginning& file);
  Part (*read)(const ReadContext& context);
};

[[nodiscard]] std::span<const PartFormat> part_formats();

/// By the content, else by the extension, in lower case. Throws FileError for an empty file and for what is
/// no part file of any known format.
[[nodiscard]] const PartFormat& detect_format(const std::string& path, const FileBeginning& file,
                                              const std::string& extension);

/// "STL, OBJ, PLY" and so on, with `last` before the last one.
[[nodiscard]] std::string part_format_names(std::string_view last);
/// True if files of this name are part files, as far as the name says.
[[nodiscard]] bool is_part_file_name(const std::string& name);

/// The name's extension in lower case without the dot; empty where there is none.
[[nodiscard]] std::string lower_extension(const std::string& path);

/// Reads a part file of any known format; equal vertices are welded, no facet is dropped or reordered unless
/// the options choose a body or ask for a full repair (Part::file_facets has them then). Throws FileError
/// that names the place for a file that is unreadable, damaged or holds no facets, Cancelled when asked to.
[[nodiscard]] Part read_part(const std::string& path, const ReadOptions& options, const Progress& progress);
/// The same of a part file's bytes, which messages call `name`.
[[nodiscard]] Part read_part_bytes(const std::string& name, std::string_view bytes,
                                   const ReadOptions& options, const Progress& progress);

}  // namespace moldlight
