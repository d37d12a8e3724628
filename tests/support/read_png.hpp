// PNG files, read back.
#pragma once

#include <string>

#include "base/image.hpp"

namespace moldlight::test {

/// A PNG of any kind as RGBA; throws std::runtime_error for what is none.
[[nodiscard]] Image read_png(const std::string& path);

}  // namespace moldlight::test
