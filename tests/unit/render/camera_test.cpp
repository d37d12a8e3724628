// The camera's pure functions: what a hand does to the view.
#include "render/camera.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include "support/sight_line.hpp"

namespace moldlight {
namespace {

constexpr glm::ivec2 k_size(1280, 720);
const glm::dvec3 k_z(0, 0, 1);

Camera some_camera(Projection projection) {
  Camera camera;
  camera.orientation = looking_along({-0.4, 0.8, -0.3}, k_z);
  camera.target = {0.1, -0.05, 0.2};
  camera.height = 0.7;
  camera.projection = projection;
  return camera;
}

constexpr std::array k_projections = {Projection::orthographic, Projection::perspective};

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  EXPECT_LT(glm::distance(a, b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Camera, MatricesProjectAndSightLineAgree) {
  for (const Projection projection : k_projections) {
    const Camera camera = some_camera(projection);
    for (const glm::dvec2& pixel : {glm::dvec2(0.5, 0.5), glm::dvec2(900.25, 100.0), glm::dvec2(640, 360)}) {
      const test::SightLine line = test::sight_line(camera, k_size, pixel);
      const glm::dvec3 point = line.origin + (camera.eye_distance() + 0.13) * line.direction;
      const auto seen = project(camera, k_size, point);
      ASSERT_TRUE(seen);
      EXPECT_LT(glm::distance(*seen, pixel), 1e-6);
      const glm::dvec4 clip =
          projection_matrix(camera, k_size) * view_matrix(camera) * glm::dvec4(point, 1.0);
      EXPECT_NEAR(clip.x / clip.w, 2.0 * pixel.x / k_size.x - 1.0, 1e-9);
      EXPECT_NEAR(clip.y / clip.w, 1.0 - 2.0 * pixel.y / k_size.y, 1e-9);
      EXPECT_LT(std::abs(clip.z / clip.w), 1.0);
    }
  }
}

TEST(Camera, ShiftMovesThePictureByPixels) {
  for (const Projection projection : k_projections) {
    const Camera camera = some_camera(projection);
    const glm::dvec4 point(0.05, 0.1, 0.15, 1.0);
    const auto at = [&](const glm::dvec2& shift) {
      const glm::dvec4 clip = projection_matrix(camera, k_size, shift) * view_matrix(camera) * point;
      return glm::dvec2((clip.x / clip.w + 1.0) * k_size.x / 2.0, (1.0 - clip.y / clip.w) * k_size.y / 2.0);
    };
    EXPECT_LT(glm::distance(at({0.25, -0.5}) - at({0, 0}), glm::dvec2(0.25, -0.5)), 1e-9);
  }
}

TEST(Camera, StandardViewsLookAsNamed) {
  const auto camera = [](StandardView view) { return Camera{.orientation = standard_orientation(view)}; };
  expect_near(camera(StandardView::front).toward_viewer(), {0, -1, 0}, 1e-12);
  expect_near(camera(StandardView::front).up(), k_z, 1e-12);
  expect_near(camera(StandardView::right).toward_viewer(), {1, 0, 0}, 1e-12);
  expect_near(camera(StandardView::top).toward_viewer(), k_z, 1e-12);
  expect_near(camera(StandardView::top).up(), {0, 1, 0}, 1e-12);
  expect_near(camera(StandardView::isometric).toward_viewer(), glm::dvec3(1, -1, 1) / std::sqrt(3.0), 1e-12);
}

TEST(Camera, LooksAlongItsOwnUp) {
  for (const glm::dvec3& forward : {k_z, -k_z, glm::dvec3(0, 1, 0)}) {
    const Camera camera{.orientation = looking_along(forward, forward)};
    expect_near(camera.toward_viewer(), -forward, 1e-12);
    EXPECT_NEAR(glm::length(camera.up()), 1.0, 1e-12);
  }
}

TEST(Camera, FittedPointsFillThePicture) {
  std::vector<glm::vec3> corners;
  for (const float x : {-0.3F, 0.3F}) {
    for (const float y : {-0.1F, 0.2F}) {
      for (const float z : {-0.2F, 0.4F}) corners.emplace_back(x, y, z);
    }
  }
  for (const Projection projection : k_projections) {
    const Camera camera = fitted(some_camera(projection), corners, k_size, 0.8);
    double widest = 0.0, tallest = 0.0;
    for (const glm::vec3& corner : corners) {
      const auto seen = project(camera, k_size, glm::dvec3(corner));
      ASSERT_TRUE(seen);
      widest = std::max(widest, std::abs(seen->x / k_size.x - 0.5));
      tallest = std::max(tallest, std::abs(seen->y / k_size.y - 0.5));
    }
    EXPECT_LE(std::max(widest, tallest), 0.4 + 1e-9);
    EXPECT_GE(std::max(widest, tallest), 0.39);
  }
}

TEST(Camera, OrbitFollowsTheHandAndStopsAtThePoles) {
  const glm::dvec3 pivot(0.2, 0.0, 0.1);
  const Camera start{.target = pivot, .orientation = standard_orientation(StandardView::front)};
  const Camera right = orbited(start, {0.2, 0.0}, k_z, pivot);
  EXPECT_LT(right.toward_viewer().x, 0.0);  // the scene turns to the right, so the viewer goes left
  const Camera down = orbited(start, {0.0, 0.3}, k_z, pivot);
  EXPECT_GT(down.toward_viewer().z, 0.0);
  expect_near(down.target, pivot, 1e-12);
  const Camera above = orbited(start, {0.4, 20.0}, k_z, pivot);
  EXPECT_NEAR(above.toward_viewer().z, 1.0, 1e-5);
  EXPECT_GT(above.up().z, 0.0);
  const Camera back = orbited(above, {0.0, -20.0}, k_z, pivot);
  EXPECT_NEAR(back.toward_viewer().z, -1.0, 1e-5);
}

TEST(Camera, OrbitKeepsThePivotInPlace) {
  const glm::dvec3 pivot(0.25, -0.1, 0.05);
  for (const Projection projection : k_projections) {
    const Camera start = some_camera(projection);
    const auto before = project(start, k_size, pivot);
    const Camera turned = orbited(start, {0.7, -0.2}, k_z, pivot);
    EXPECT_LT(glm::distance(*before, *project(turned, k_size, pivot)), 1e-6);
  }
}

TEST(Camera, PanAndZoomKeepWhatIsUnderTheHand) {
  for (const Projection projection : k_projections) {
    const Camera start = some_camera(projection);
    const glm::dvec2 pixel(300.0, 500.0);
    const test::SightLine line = test::sight_line(start, k_size, pixel);
    const double along = glm::dot(start.target - line.origin, start.toward_viewer()) /
                         glm::dot(line.direction, start.toward_viewer());
    const glm::dvec3 under = line.origin + along * line.direction;
    const glm::dvec2 by(40.0, -25.0);
    EXPECT_LT(glm::distance(*project(panned(start, by, k_size), k_size, under), pixel + by), 1e-6);
    const Camera close = zoomed(start, 1.7, pixel, k_size);
    EXPECT_NEAR(close.height, start.height / 1.7, 1e-12);
    EXPECT_LT(glm::distance(*project(close, k_size, under), pixel), 1e-6);
  }
}

TEST(Camera, FlightsStartAndEndWhereTheyShould) {
  const Camera from = some_camera(Projection::perspective);
  Camera to = some_camera(Projection::perspective);
  to.orientation = standard_orientation(StandardView::top);
  to.height = 0.2;
  expect_near(interpolated(from, to, 0.0).up(), from.up(), 1e-12);
  expect_near(interpolated(from, to, 1.0).up(), to.up(), 1e-12);
  EXPECT_NEAR(interpolated(from, to, 0.5).height, std::sqrt(0.7 * 0.2), 1e-12);
}

}  // namespace
}  // namespace moldlight
