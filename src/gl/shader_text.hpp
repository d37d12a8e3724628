// The text of the files below shaders/, embedded at build time; from it to what the driver compiles, and from
// the driver's log back to file and line.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace moldlight::gl {

struct ShaderFile {
  std::string_view path;  // below shaders/, with forward slashes
  std::string_view text;
};

[[nodiscard]] std::span<const ShaderFile> shader_files();

using Defines = std::vector<std::pair<std::string, std::string>>;

/// The text of one stage, and where each of its lines comes from. Kept here rather than in #line directives,
/// since Mesa forgets their second number in most messages.
struct ShaderText {
  struct Origin {
    std::size_t file;  // index into `files`
    int line;          // from 1; of a define, that of the #version line
  };
  std::string text;
  std::vector<std::string> files;
  std::vector<Origin> origins;
};

/// Puts `defines` after the #version line of `path` and replaces lines `#include "…"` by that file, each file
/// once. Throws Error for a file that is not in `files` and for a first file without #version.
[[nodiscard]] ShaderText expand_shader(std::string_view path, const Defines& defines,
                                       std::span<const ShaderFile> files);

/// The same text for GLSL ES 3.00, as a browser's WebGL 2 takes it: its own version line, and everything in
/// high precision.
[[nodiscard]] std::string es_text(const ShaderText& shader);

/// One line "shaders/a.frag:12: what is wrong" from a driver's log: its first error, and how many more there
/// are.
[[nodiscard]] std::string readable_log(const ShaderText& shader, std::string_view log);

}  // namespace moldlight::gl
