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

/// Of half the size, each pixel the mean of four.
[[nodiscard]] inline Image halved(const Image& image) {
  Image half = empty_image(image.width / 2, image.height / 2);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (std::size_t c = 0; c < 4; ++c)
        half.at(x, y)[c] = static_cast<std::uint8_t>(
            (image.at(2 * x, 2 * y)[c] + image.at(2 * x + 1, 2 * y)[c] + image.at(2 * x, 2 * y + 1)[c] +
             image.at(2 * x + 1, 2 * y + 1)[c] + 2) /
            4);
  return half;
}

}  // namespace moldlight
