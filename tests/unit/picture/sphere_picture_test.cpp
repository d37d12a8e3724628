// The pictures of a sweep: colours where they belong, labels that cover nothing, sheets that hold their
// tiles.
#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/direction_field.hpp"
#include "picture/design_space.hpp"
#include "picture/direction_sphere.hpp"
#include "picture/sphere_map.hpp"

namespace moldlight {
namespace {

bool apart(const Box& a, const Box& b) {
  return a.far_corner().x <= b.corner.x || b.far_corner().x <= a.corner.x || a.far_corner().y <= b.corner.y ||
         b.far_corner().y <= a.corner.y;
}

double distance_to(const Box& box, const glm::dvec2& point) {
  return glm::distance(glm::clamp(point, box.corner, box.far_corner()), point);
}

TEST(LabelPlaces, NoneCoversAnotherOrAMark) {
  // Three clusters and a few alone, as the best directions of a sweep lie.
  std::vector<LabelledMark> marks;
  for (int k = 0; k < 24; ++k) {
    const double around = 2.4 * k, far = k % 3 == 0 ? 8.0 : 30.0;
    marks.push_back(
        {glm::dvec2(150.0 + 120.0 * (k % 3), 200.0) + far * glm::dvec2(std::cos(around), std::sin(around)),
         4.0,
         {k < 9 ? 18.0 : 26.0, 18.0}});
  }
  const Box room{{0, 0}, {560, 400}}, taken{{240, 150}, {60, 40}};
  const auto places = place_labels(marks, std::vector<Box>{taken}, room);
  ASSERT_EQ(places.size(), marks.size());
  std::size_t placed = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    ++placed;
    EXPECT_TRUE(apart(*places[i], taken));
    EXPECT_EQ(places[i]->size, marks[i].label);
    for (std::size_t k = 0; k < places.size(); ++k) {
      EXPECT_GE(distance_to(*places[i], marks[k].centre), marks[k].radius) << i << " over mark " << k;
      if (k < i && places[k]) {
        EXPECT_TRUE(apart(*places[i], *places[k])) << i << ' ' << k;
      }
    }
  }
  EXPECT_GE(placed, 22U);
}

TEST(LabelPlaces, AMarkWithoutRoomHasNoLabel) {
  const std::vector<LabelledMark> marks = {{{10, 10}, 4.0, {30, 18}}};
  EXPECT_FALSE(place_labels(marks, {}, {{0, 0}, {20, 20}})[0]);
  EXPECT_TRUE(place_labels(marks, {}, {{0, 0}, {200, 200}})[0]);
}

TEST(ScaleTicks, AreRoundAndApart) {
  EXPECT_EQ(scale_ticks(0.0), std::vector<double>{0.0});
  EXPECT_EQ(scale_ticks(100.0), (std::vector<double>{0, 2, 10, 20, 50, 100}));
  for (const double worst : {1e-9, 0.37, 3.7, 99.0, 13659.0, 4e11}) {
    const std::vector<double> ticks = scale_ticks(worst);
    EXPECT_GE(ticks.size(), 4U) << worst;
    for (std::size_t k = 1; k < ticks.size(); ++k) {
      EXPECT_GE(undercut_scale(ticks[k], worst) - undercut_scale(ticks[k - 1], worst), 0.1) << worst;
      EXPECT_LE(ticks[k], worst * 1.000001);
    }
  }
}

UndercutField slope_field() {
  UndercutField field{.areas = DirectionField(20.0), .worst = 100.0};
  for (int k = 0; k < 400; ++k) {
    const double z = (k + 0.5) / 400.0, turn = 2.399963 * k, r = std::sqrt(1.0 - z * z);
    field.areas.add({r * std::cos(turn), r * std::sin(turn), z}, 100.0 * (1.0 - z));
  }
  return field;
}

SphereContent content_of(std::size_t rows) {
  SphereContent content{.title = "part.stl", .lines = {"one", "two"}, .unit = "mm²", .total_area = 1000.0};
  for (std::size_t k = 0; k < rows; ++k) {
    const double turn = 0.7 * static_cast<double>(k);
    content.rows.push_back(
        {.mark = {.direction = glm::normalize(glm::dvec3(std::cos(turn), std::sin(turn), 0.4)),
                  .label = std::to_string(k + 1),
                  .best = k == 0,
                  .tilt_deg = 5.0},
         .undercut = 10.0});
  }
  content.note = "nothing";
  return content;
}

TEST(DirectionSphere, HasTheColoursOfTheField) {
  const UndercutField field = slope_field();
  const Image image = direction_sphere_picture({1600, 1000}, field, content_of(0), false);
  ASSERT_EQ(image.width, 1600);
  ASSERT_EQ(image.height, 1000);
  // Between the lines of the map, on its diagonal at 20, 45 and 75 degrees from +z.
  for (const double polar_deg : {20.0, 45.0, 75.0}) {
    const double polar = polar_deg / 57.29577951308232, azimuth = 0.8;
    const glm::dvec3 direction(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                               std::cos(polar));
    const glm::dvec2 at = glm::dvec2(496.0, 492.0) + 412.0 * equal_area_point(direction) * glm::dvec2(1, -1);
    const Colour wanted = undercut_scale_colour(undercut_scale(field.areas.at(direction).value, field.worst));
    const std::uint8_t* found = image.at(static_cast<int>(at.x), static_cast<int>(at.y));
    EXPECT_NEAR(found[0], wanted.r, 6) << polar_deg;
    EXPECT_NEAR(found[1], wanted.g, 6) << polar_deg;
    EXPECT_NEAR(found[2], wanted.b, 6) << polar_deg;
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);
}

TEST(DirectionSphere, ShowsWhereNothingIsKnown) {
  UndercutField field{.areas = DirectionField(10.0), .worst = 1.0};
  field.areas.add({0, 0, 1}, 0.5);
  const Image image = direction_sphere_picture({1600, 1000}, field, content_of(0), true);
  // Far from the one direction all is gray: no more red than blue.
  for (int y = 300; y < 700; ++y) {
    const std::uint8_t* rgba = image.at(496 + 300, y);
    EXPECT_LE(rgba[0], rgba[2] + 40) << y;
    EXPECT_GE(rgba[0] + 40, rgba[2]) << y;
  }
  const std::uint8_t* known = image.at(496 + 14, 492 - 14);
  EXPECT_GT(known[0], known[2] + 40);
}

TEST(DirectionSphere, IsTheSameEveryTimeAndTakesAnyNumberOfRows) {
  const UndercutField field = slope_field();
  for (const std::size_t rows : {1, 10, 11, 100}) {
    const Image image = direction_sphere_picture({800, 500}, field, content_of(rows), rows % 2 == 0);
    EXPECT_EQ(image.rgba, direction_sphere_picture({800, 500}, field, content_of(rows), rows % 2 == 0).rgba);
    // The margins stay free.
    for (int x = 0; x < image.width; ++x) {
      const Colour ground = picture_ground(rows % 2 == 0);
      EXPECT_EQ(image.at(x, 1)[0], ground.r);
      EXPECT_EQ(image.at(x, image.height - 2)[0], ground.r);
    }
  }
}

TEST(ContactSheet, HasRoomForItsTiles) {
  EXPECT_EQ(sheet_columns(0), 1U);
  EXPECT_EQ(sheet_columns(4), 4U);
  EXPECT_EQ(sheet_columns(6), 3U);
  EXPECT_EQ(sheet_columns(10), 5U);
  EXPECT_EQ(sheet_columns(12), 4U);
  Canvas plain(k_tile_width, k_tile_height);
  plain.fill({{12, 200, 34}});
  for (const std::size_t tiles : {0, 1, 5, 12}) {
    ContactSheet sheet{.title = "part.stl", .line = "a line"};
    for (std::size_t k = 0; k < tiles; ++k) {
      sheet.tiles.push_back(
          {.picture = plain.image(), .number = "1", .heading = "along", .reasons = {"why"}});
    }
    const Image image = contact_sheet_picture(sheet, 1.0);
    std::size_t green = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
      green += image.rgba[i] == 12 && image.rgba[i + 1] == 200;
    const auto area = static_cast<std::size_t>((k_tile_width - 4) * (k_tile_height - 4));
    EXPECT_GE(green, tiles * area);
    EXPECT_LE(green, tiles * k_tile_width * k_tile_height);
  }
}

}  // namespace
}  // namespace moldlight
