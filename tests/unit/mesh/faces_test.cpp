// Faces: planes end where they bend, round walls do not.
#include "mesh/faces.hpp"

#include <cmath>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "support/boxes.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

Faces faces_of(const TriangleMesh& mesh) {
  return smooth_faces(mesh, facet_geometry(mesh), build_adjacency(mesh));
}

/// Between two outlines of equal size at heights 0 and 10.
TriangleMesh drawn(const test::Loop2& below, const test::Loop2& above) {
  test::SolidBuilder solid;
  const test::Loop low = test::at_height(below, 0.0), high = test::at_height(above, 10.0);
  solid.face({low.rbegin(), low.rend()});
  solid.face(high);
  solid.walls(low, high);
  return solid.mesh();
}

TriangleMesh prism(int sides) {
  const test::Loop2 outline = test::regular_polygon(sides, 8.0);
  return drawn(outline, outline);
}

TEST(SmoothFaces, ABoxHasSix) {
  const Faces faces = faces_of(test::box_mesh({0, 0, 0}, {3, 2, 1}));
  ASSERT_EQ(faces.count(), 6U);
  for (std::uint32_t face = 0; face < 6; ++face) {
    ASSERT_EQ(faces.facets(face).size(), 2U);
    for (const FacetIndex facet : faces.facets(face)) EXPECT_EQ(faces.of_facet[facet], face);
  }
}

TEST(SmoothFaces, ARoundWallIsOneAndAPrismHasItsSides) {
  for (const int sides : {19, 24, 64, 200}) EXPECT_EQ(faces_of(prism(sides)).count(), 3U) << sides;
  for (const int sides : {6, 8, 12, 17}) EXPECT_EQ(faces_of(prism(sides)).count(), sides + 2U) << sides;
  const auto round = [](double radius) { return test::regular_polygon(24, radius); };
  EXPECT_EQ(faces_of(drawn(round(8.0), round(5.0))).count(), 3U) << "a cone";
  EXPECT_EQ(faces_of(test::hollow_sphere({}).mesh).count(), 2U) << "outside and inside";
}

TEST(SmoothFaces, AFilletEndsAtThePlanesBesideIt) {
  test::Loop2 outline;
  const glm::dvec2 corners[] = {{12, 7}, {-12, 7}, {-12, -7}, {12, -7}};
  for (int corner = 0; corner < 4; ++corner) {
    for (int step = 0; step <= 9; ++step) {
      const double angle = glm::radians(90.0 * corner + 10.0 * step);
      outline.push_back(corners[corner] + 2.0 * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
  }
  EXPECT_EQ(faces_of(drawn(outline, outline)).count(), 2U + 4U + 4U);
}

TEST(SmoothFaces, ARoofHasTwoSides) {
  const test::Loop2 house = {{0, 0}, {20, 0}, {20, 8}, {10, 9}, {0, 8}};
  EXPECT_EQ(faces_of(drawn(house, house)).count(), 7U);
}

TEST(SmoothFaces, TheFilesOwnGoFirst) {
  Part part;
  part.mesh = test::box_mesh({0, 0, 0}, {3, 2, 1});
  part.facet_source = {0, 0, 0, 0, 2, 2, 2, 2, 2, 2, 2, k_no_facet};
  const auto faces = [&] { return part_faces(part, facet_geometry(part.mesh), build_adjacency(part.mesh)); };
  EXPECT_EQ(faces().count(), 6U) << "polygons are no faces";
  part.has_cad_faces = true;
  const Faces noted = faces();
  ASSERT_EQ(noted.count(), 4U);
  EXPECT_EQ(noted.facets(0).size(), 4U);
  EXPECT_TRUE(noted.facets(1).empty());
  EXPECT_EQ(noted.facets(2).size(), 7U);
  EXPECT_EQ(noted.facets(3)[0], 11U) << "what a repair has added";
}

}  // namespace
}  // namespace moldlight
