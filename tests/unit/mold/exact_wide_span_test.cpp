// Split meshes of parts whose edges differ in length by more than a double in the unit frame resolves.
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "support/box_pile.hpp"
#include "support/boxes.hpp"
#include "support/exact_model.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"
#include "support/split_checks.hpp"

namespace moldlight {
namespace {

/// Every corner is a vertex at a number, and the mesh is closed where the part is.
void expect_usable_split(const test::ExactModel& model, const ExactSplit& split, const std::string& name) {
  for (const glm::dvec3& vertex : split.mesh.vertices)
    ASSERT_TRUE(std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z)) << name;
  for (const SplitPiece& piece : split.mesh.pieces) {
    for (const VertexIndex corner : piece.corners) ASSERT_LT(corner, split.mesh.vertices.size()) << name;
  }
  EXPECT_EQ(test::split_faults(model, split).unmatched_edges, 0U) << name;
}

TEST(ExactWideSpan, AnEdgeShorterThanAnyToleranceIsCutWhereTheShadowEnds) {
  // A sheet five billionths of a micrometre thick, half of it under a block.
  constexpr double k_thickness = 5e-12;
  const TriangleMesh mesh =
      test::joined(test::box_mesh({-0.5 * k_thickness, -5, -5}, {0.5 * k_thickness, 5, -1}),
                   test::box_mesh({0, -6, 1}, {4, 6, 5}));
  const test::ExactModel model(mesh);
  const test::ShapeSettings settings{.tau_deg = 1.0, .lateral_tolerance = 0.02};
  for (const double sense : {1.0, -1.0}) {
    const ExactSplit split = model.split({0, 0, sense}, settings);
    test::expect_sound_split(model, split, "sheet");
    RegionValues of_top;
    for (const SplitPiece& piece : split.mesh.pieces) {
      if (piece.facet >= 12 || model.geometry().normals[piece.facet].z < 0.5) continue;
      const glm::dvec3& at = split.mesh.vertices[piece.corners[0]];
      const glm::dvec3 to_1 = split.mesh.vertices[piece.corners[1]] - at;
      of_top[piece.region] += 0.5 * glm::length(glm::cross(to_1, split.mesh.vertices[piece.corners[2]] - at));
    }
    const double half = 0.5 * k_thickness * 10.0;
    EXPECT_NEAR(of_top[Region::undercut], half, 1e-3 * half);
    EXPECT_NEAR(of_top[sense > 0.0 ? Region::core : Region::cavity], half, 1e-3 * half);
  }
}

TEST(ExactWideSpan, CoordinatesWithFlippedExponentsLeaveASplitThatIsClosed) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    TriangleMesh mesh = test::pile_mesh(test::random_pile(seed), seed);
    // The largest is some 1e10 to 1e13 times the others, so that an edge of these is about as long as the
    // tolerance within which two points are one.
    for (std::size_t flips = 0; flips < 1 + seed % 6; ++flips) {
      double& coordinate =
          mesh.vertices[random.below(mesh.vertices.size())][static_cast<int>(random.below(3))];
      coordinate = std::ldexp(coordinate, 33 + static_cast<int>(random.below(10)));
    }
    const test::ExactModel model(mesh);
    for (const glm::dvec3& direction : test::five_directions())
      expect_usable_split(model, model.split(direction, model.default_settings()), std::to_string(seed));
  }
}

}  // namespace
}  // namespace moldlight
