// A picture in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace moldlight {

/// Rows from above, four bytes a pixel: red, green, blue (sRGB) and straight alpha.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  /// The four bytes of a pixel.
  [[nodiscard]] std::uint8_t* at(int x, int y) { return &rgba[offset(x, y)]; }
  [[nodiscard]] const std::uint8_t* at(int x, int y) const { return &rgba[offset(x, y)]; }

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
};

/// A transparent picture.
[[nodiscard]] inline Image empty_image(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) * height)};
}

}  // namespace moldlight
