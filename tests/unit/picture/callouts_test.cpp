// Numbers that point at places, and the bar that shows the scale.
#include "picture/callouts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace moldlight {
namespace {

struct Pixel {
  int red, green, blue, alpha;
};
Pixel pixel(const Image& image, int x, int y) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

std::size_t marked(const Image& image) {
  std::size_t count = 0;
  for (std::size_t k = 3; k < image.rgba.size(); k += 4) count += image.rgba[k] > 0 ? 1 : 0;
  return count;
}

/// What is drawn for so many numbers of one place.
std::size_t marked_by(std::size_t numbers) {
  Canvas canvas(600, 600);
  const std::vector<Callout> callouts(numbers, {{300.0, 300.0}, "8"});
  draw_callouts(canvas, callouts, {300.0, 500.0}, {.dark = false});
  return marked(canvas.image());
}

TEST(Callouts, OfOnePlaceStandBesideEachOther) {
  // Discs that lay on each other would show no more than one.
  const double one = static_cast<double>(marked_by(1));
  EXPECT_GT(one, 700.0);
  EXPECT_GT(static_cast<double>(marked_by(6)), 5.0 * 3.1 * 15.0 * 15.0);
}

TEST(Callouts, StayWithinThePicture) {
  Canvas canvas(200, 120);
  const std::vector<Callout> corners = {{{0, 0}, "1"}, {{199, 0}, "2"}, {{0, 119}, "3"}, {{199, 119}, "4"}};
  draw_callouts(canvas, corners, {100.0, 60.0}, {.dark = false});
  const Image image = canvas.image();
  // Each has its whole disc, in the quarter of its corner.
  for (const auto& [from_x, from_y] :
       {std::pair(0, 0), std::pair(100, 0), std::pair(0, 60), std::pair(100, 60)}) {
    std::size_t count = 0;
    for (int y = from_y; y < from_y + 60; ++y)
      for (int x = from_x; x < from_x + 100; ++x) count += pixel(image, x, y).alpha > 0 ? 1 : 0;
    EXPECT_GT(count, 700u) << from_x << " " << from_y;
  }
}

TEST(ScaleBar, IsAsLongAsItSays) {
  for (const double pixel_length : {0.013, 0.25, 0.3, 7.0}) {
    Canvas canvas(800, 500);
    draw_scale_bar(canvas, pixel_length, "mm", {.dark = false});
    const Image image = canvas.image();
    // The bar is the longest dark run of a row.
    int longest = 0;
    for (int y = 0; y < image.height; ++y) {
      int run = 0;
      for (int x = 0; x < image.width; ++x) {
        const Pixel at = pixel(image, x, y);
        const bool dark = at.alpha > 200 && at.red + at.green + at.blue < 384;
        run = dark ? run + 1 : 0;
        longest = std::max(longest, run);
      }
    }
    const double length = longest * pixel_length;
    const double power = std::pow(10.0, std::floor(std::log10(length * 1.03)));
    double off = 1.0;
    for (const double step : {1.0, 2.0, 5.0}) off = std::min(off, std::abs(length / (step * power) - 1.0));
    EXPECT_LT(off, 0.03) << length << " for " << pixel_length;
    EXPECT_LE(longest, 203);
    EXPECT_GT(longest, 75);
  }
}

}  // namespace
}  // namespace moldlight
