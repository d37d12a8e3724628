// The text of the files below shaders/, embedded at build time.
#pragma once

#include <span>
#include <string_view>

namespace moldlight::gl {

struct ShaderFile {
  std::string_view path;  // below shaders/, with forward slashes
  std::string_view text;
};

[[nodiscard]] std::span<const ShaderFile> shader_files();

}  // namespace moldlight::gl
