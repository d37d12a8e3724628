// Where the seams between two pieces run: level, on creases, beside cosmetic faces.
#include "pieces/formed_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mesh/faces.hpp"
#include "pieces/find_pieces.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

constexpr int k_sides = 24;
constexpr double k_radius = 10.0, k_shoulder = 30.0;

/// An upright round wall in two bands, ring by ring rounded off at its top without a crease; its lower end
/// is cut off by the plane z = slope x.
TriangleMesh round_post(double slope) {
  test::SolidBuilder builder;
  const test::Loop2 circle = test::regular_polygon(k_sides, k_radius);
  test::Loop lower = test::at_height(circle, 0.0);
  for (glm::dvec3& point : lower) point.z = slope * point.x;
  test::Loop bottom = lower;
  std::ranges::reverse(bottom);
  builder.face(bottom);
  double radius = k_radius, height = k_shoulder;
  for (const double z : {k_shoulder - 8.0, k_shoulder}) {
    builder.walls(lower, test::at_height(circle, z));
    lower = test::at_height(circle, z);
  }
  for (const double lean_deg : {15.0, 30.0, 45.0, 60.0, 75.0}) {
    const double lean = lean_deg * std::numbers::pi / 180.0;
    radius -= 2.0 * std::sin(lean);
    height += 2.0 * std::cos(lean);
    const test::Loop upper = test::at_height(test::regular_polygon(k_sides, radius), height);
    builder.walls(lower, upper);
    lower = upper;
  }
  builder.face(lower);
  return builder.mesh();
}

std::vector<double> seam_heights(const FormedSurface& formed) {
  std::vector<double> heights;
  for (const PieceSeam& seam : formed.seams)
    for (const glm::dvec3& point : seam.points) heights.push_back(point.z);
  return heights;
}

FormedSurface formed_along_z(const PartModel& model, const SurfaceWishes& wishes = {}) {
  const std::array<glm::dvec3, 2> directions = {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)};
  return form_surface(model, exact_query(model, {}), directions, Progress(), wishes);
}

/// The rim of the cut is a crease, and half its length is less than that of a level line.
TEST(FormedSurface, ALevelSeamIsBetterThanASteepCrease) {
  const auto steep = test::model_of(round_post(std::tan(60.0 * std::numbers::pi / 180.0)));
  for (const double height : seam_heights(formed_along_z(*steep)))
    EXPECT_TRUE(std::abs(height - k_shoulder) < 1e-6 || std::abs(height - k_shoulder + 8.0) < 1e-6) << height;
  const auto flat = test::model_of(round_post(0.0));
  for (const double height : seam_heights(formed_along_z(*flat))) EXPECT_NEAR(height, 0.0, 1e-6);
}

TEST(FormedSurface, ASeamKeepsOffACosmeticFace) {
  const auto model = test::model_of(round_post(std::tan(60.0 * std::numbers::pi / 180.0)));
  const auto is_wall = [&](FacetIndex facet) { return std::abs(model->geometry.normals[facet].z) < 1e-9; };
  std::vector<double> heights = seam_heights(formed_along_z(*model));
  ASSERT_FALSE(heights.empty());
  EXPECT_NEAR(std::ranges::max(heights), k_shoulder - 8.0, 1e-6);  // so that the later piece forms less
  SurfaceWishes wishes;
  for (FacetIndex facet = 0; facet < model->part.mesh.facets.size(); ++facet)
    wishes.cosmetic.push_back(is_wall(facet) ? 7U : SurfaceWishes::k_none);
  heights = seam_heights(formed_along_z(*model, wishes));
  ASSERT_FALSE(heights.empty());
  EXPECT_NEAR(std::ranges::min(heights), k_shoulder, 1e-6);
}

TEST(FormedSurface, APieceFormsTheFacesThatItIsGivenIfItReleasesThem) {
  const auto model = test::model_of(test::box_mesh({0, 0, 0}, {20, 30, 10}));
  const Faces faces = part_faces(model->part, model->geometry, model->adjacency);
  std::uint32_t wall = 0, bottom = 0;
  for (FacetIndex facet = 0; facet < model->part.mesh.facets.size(); ++facet) {
    if (model->geometry.normals[facet].x > 0.5) wall = faces.of_facet[facet];
    if (model->geometry.normals[facet].z < -0.5) bottom = faces.of_facet[facet];
  }
  ASSERT_NE(wall, bottom);
  PiecesSettings settings{.fixed = {{0, 0, 1}, {0, 0, -1}}};
  for (const std::uint32_t piece : {0U, 1U}) {
    settings.cosmetic = fmt::format("{}:{}", piece + 1, wall);
    const PiecesResult result = find_pieces(*model, {}, settings, Progress());
    for (std::size_t k = 0; k < result.formed.formed_by.size(); ++k) {
      if (faces.of_facet[result.formed.mesh.pieces[k].facet] == wall) {
        EXPECT_EQ(result.formed.formed_by[k], piece);
      }
    }
  }
  for (const auto& [text, said] :
       {std::pair(fmt::format("1:{}", bottom), "does not release 100.0 % of its faces"),
        std::pair(fmt::format("3:{}", wall), "no piece 3"), std::pair(std::string("1:99"), "no face 99")}) {
    settings.cosmetic = text;
    try {
      static_cast<void>(find_pieces(*model, {}, settings, Progress()));
      ADD_FAILURE() << text;
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
  }
  for (const std::string text : {"0:1", "x", "1:", "1,", "/"})
    EXPECT_THROW(static_cast<void>(cosmetic_groups(text)), UsageError) << text;
}

}  // namespace
}  // namespace moldlight
