// PNG files (libpng).
#pragma once

#include <string>

#include "base/image.hpp"

namespace moldlight {

/// The bytes of a PNG file; without an alpha channel where every pixel is opaque.
[[nodiscard]] std::string png_bytes(const Image& image);

/// Throws FileError for what is no PNG file, and for pictures of more than 4096 x 4096 pixels.
[[nodiscard]] Image read_png(const std::string& path);

/// Replaces the file whole or not at all; throws FileError.
void write_png(const std::string& path, const Image& image);

}  // namespace moldlight
