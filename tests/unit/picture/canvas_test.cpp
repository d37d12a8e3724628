// Drawing on pictures: pixels where they should be, text that is measured as it is drawn.
#include "picture/canvas.hpp"

#include <gtest/gtest.h>

#include "base/shown_text.hpp"
#include "picture/legend.hpp"

namespace moldlight {
namespace {

constexpr Colour k_red = {200, 10, 20};

/// First and last column in which anything was drawn; -1 for none.
std::pair<int, int> columns(const Image& image) {
  std::pair<int, int> found{-1, -1};
  for (int x = 0; x < image.width; ++x) {
    for (int y = 0; y < image.height; ++y) {
      if (image.at(x, y)[3] == 0) continue;
      if (found.first < 0) found.first = x;
      found.second = x;
    }
  }
  return found;
}

TEST(Canvas, FillsAndKeepsColoursAndAlpha) {
  Canvas canvas(20, 10);
  canvas.fill_box({{2, 3}, {5, 4}}, {k_red});
  const Image image = canvas.image();
  EXPECT_EQ(image.at(1, 4)[3], 0);
  EXPECT_EQ(image.at(2, 3)[0], k_red.r);
  EXPECT_EQ(image.at(6, 6)[2], k_red.b);
  EXPECT_EQ(image.at(7, 6)[3], 0);
  EXPECT_EQ(Canvas(image).image().rgba, image.rgba);

  canvas.fill({{0, 0, 255}, 0.5});
  EXPECT_NEAR(canvas.image().at(15, 8)[3], 128, 1);
  EXPECT_NEAR(canvas.image().at(15, 8)[2], 255, 2);
}

TEST(Canvas, PicturesAreScaledIntoTheirBox) {
  Canvas small(2, 2);
  small.fill({k_red});
  Canvas canvas(30, 30);
  canvas.picture(small.image(), {{10, 5}, {12, 8}});
  EXPECT_EQ(canvas.image().at(15, 9)[0], k_red.r);
  EXPECT_EQ(canvas.image().at(8, 9)[3], 0);
  EXPECT_EQ(canvas.image().at(24, 9)[3], 0);
}

TEST(Canvas, TextStandsWhereItIsAligned) {
  TextStyle style{.size_px = 20.0, .ink = {k_red}};
  Canvas measuring(1, 1);
  const double width = measuring.text_width("Undercut 12.5", style);
  EXPECT_GT(width, 80.0);
  EXPECT_LT(width, 200.0);
  for (const auto& [align, start] :
       {std::pair{Align::left, 150.0}, {Align::centre, 150.0 - width / 2}, {Align::right, 150.0 - width}}) {
    Canvas canvas(400, 40);
    style.align = align;
    canvas.text({150.0, 28.0}, "Undercut 12.5", style);
    const auto [first, last] = columns(canvas.image());
    EXPECT_NEAR(first, start, 4.0);
    EXPECT_NEAR(last, start + width, 4.0);
  }
}

TEST(Canvas, TabularDigitsAreOfOneWidth) {
  Canvas canvas(1, 1);
  const TextStyle style{.size_px = 15.0, .tabular = true};
  for (const char* digits : {"1111", "7777", "0000"}) {
    EXPECT_DOUBLE_EQ(canvas.text_width(digits, style), canvas.text_width("8888", style));
  }
}

TEST(Canvas, LongTextIsElidedInItsMiddle) {
  Canvas canvas(1, 1);
  const TextStyle style{.size_px = 15.0};
  EXPECT_EQ(canvas.elided("short.stl", style, 500.0), "short.stl");
  const std::string shorter = canvas.elided("a_rather_long_name_of_a_part.stl", style, 120.0);
  EXPECT_LE(canvas.text_width(shorter, style), 120.0);
  EXPECT_TRUE(shorter.starts_with("a_") && shorter.ends_with("stl")) << shorter;
  EXPECT_NE(shorter.find("…"), std::string::npos);
}

TEST(Letters, GoThroughUtf8AndBack) {
  const std::string text = "mm² ± 5° Gehäuse 部品 😀";
  EXPECT_EQ(utf8_of(letters_of(text)), text);
  EXPECT_EQ(letters_of("部").size(), 1U);
  EXPECT_EQ(letters_of("a\xC3"), U"a\uFFFD");
  EXPECT_EQ(letters_of("\xFF\x80z").back(), U'z');
}

TEST(Legend, TakesTheRoomItSaysAndShowsItsColours) {
  LegendContent content{
      .title = "part.stl", .lines = {"direction 0, 0, 1"}, .unit = "mm²", .note = "checks agree"};
  content.shares = {0.4, 0.3, 0.2, 0.1};
  content.percents = {"40.00", "30.00", "20.00", "10.00"};
  content.areas = {"400", "300", "200", "100"};
  for (const double scale : {1.0, 2.0}) {
    const LegendStyle style{.dark = true, .scale = scale};
    const glm::dvec2 size = legend_size(content, style);
    Canvas canvas(800, 800);
    draw_legend(canvas, {10.0, 10.0}, content, style);
    const Image image = canvas.image();
    const auto [first, last] = columns(image);
    EXPECT_NEAR(first, 10, 1);
    EXPECT_NEAR(last, 10 + size.x, 2);
    for (const Region region : k_regions) {
      const Colour colour = region_colour(region, style.palette);
      std::size_t seen = 0;
      for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        seen += image.rgba[i] == colour.r && image.rgba[i + 1] == colour.g && image.rgba[i + 2] == colour.b
                    ? 1
                    : 0;
      }
      EXPECT_GT(seen, 60U) << region_name(region);
    }
  }
}

}  // namespace
}  // namespace moldlight
