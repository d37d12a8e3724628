// A part in another size is named as that, and the headline says what the table says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "compare/comparison.hpp"
#include "unit/compare/revisions.hpp"

namespace moldlight {
namespace {

Comparison compared(const TriangleMesh& a, const TriangleMesh& b, bool aligned,
                    const glm::dvec3& direction = {0, 0, 1}) {
  CompareSettings settings;
  settings.align = aligned;
  settings.with_actions = false;
  Comparison comparison = prepare_comparison(test::model_of(a), test::model_of(b), settings, Progress());
  compare_parts(comparison, {.a = direction, .b = direction, .method = {}}, Progress());
  return comparison;
}

TEST(Scale, IsFoundAndNamed) {
  const TriangleMesh mesh = plate_mesh({.hole_radius = 3.0, .rib = 2.0});
  for (const double factor : {1.01, 0.93, 1.0986}) {
    const Comparison found = compared(
        mesh, test::rounded_to_float(test::translated(test::scaled(mesh, factor), {3, 1, -2})), false);
    ASSERT_TRUE(found.scale.has_value()) << factor;
    EXPECT_NEAR(found.scale->factor, factor, 1e-6);
    EXPECT_EQ(found.scale->other, 0.0);
    EXPECT_TRUE(comparison_verdict(found).starts_with(fmt::format("B is A × {:.4f}.", factor)))
        << comparison_verdict(found);
  }
}

TEST(Scale, OfAnotherUnitIsNamedByBoth) {
  const TriangleMesh mesh = plate_mesh({.hole_radius = 3.0, .rib = 2.0});
  for (const auto& [factor, text] :
       {std::pair(25.4, "B is A × 25.4, as if A were in inches and B in mm."),
        std::pair(1.0 / 25.4, "B is A × 0.03937, as if A were in mm and B in inches."),
        std::pair(10.0, "B is A × 10, as if A were in cm and B in mm."),
        std::pair(1e-3, "B is A × 0.001, as if A were in mm and B in m.")}) {
    const TriangleMesh other = test::rounded_to_float(test::scaled(mesh, factor));
    EXPECT_TRUE(comparison_verdict(compared(mesh, other, false)).starts_with(text)) << factor;
    const TriangleMesh turned = test::rounded_to_float(test::rotated(other, test::random_rotation(3)));
    EXPECT_TRUE(comparison_verdict(compared(mesh, turned, true)).starts_with(text)) << factor << " turned";
  }
  EXPECT_FALSE(compared(mesh, test::scaled(mesh, 24.0), false).scale.has_value());
}

TEST(Scale, IsFoundOfATurnedPart) {
  const TriangleMesh mesh = plate_mesh({.hole_radius = 3.0, .rib = 2.0});
  const Comparison found =
      compared(mesh, test::rotated(test::scaled(mesh, 1.01), test::random_rotation(3)), true);
  ASSERT_TRUE(found.scale.has_value());
  EXPECT_NEAR(found.scale->factor, 1.01, 1e-6);
}

TEST(Scale, IsFoundBesideAnotherChange) {
  const Comparison found = compared(plate_mesh({.rib = 2.0}),
                                    test::scaled(plate_mesh({.hole_radius = 2.0, .rib = 2.0}), 1.02), false);
  ASSERT_TRUE(found.scale.has_value());
  EXPECT_NEAR(found.scale->factor, 1.02, 1e-6);
  EXPECT_GT(found.scale->other, 0.0);
  EXPECT_LT(found.scale->other, 0.1);
  EXPECT_NE(comparison_verdict(found).find("B is A × 1.0200 but for "), std::string::npos);
}

TEST(Scale, IsNoneOfOtherChanges) {
  const TriangleMesh mesh = plate_mesh({.hole_radius = 3.0});
  PlateWithBoss moved{.hole_radius = 3.0};
  moved.boss.x += 0.5;
  TriangleMesh longer = mesh;
  for (glm::dvec3& vertex : longer.vertices) vertex.x *= 1.01;
  for (const TriangleMesh& other : {plate_mesh(moved), plate_mesh({}), longer, test::scaled(mesh, 1.3),
                                    plate_mesh({.height = 10.5, .hole_radius = 3.0})}) {
    EXPECT_FALSE(compared(mesh, other, false).scale.has_value());
  }
}

/// A roof that reaches farther by a 50th: less than what stays open of new and gone surface may explain.
TEST(Headline, SaysOfTheUndercutWhatTheTableSays) {
  const auto with_roof = [](double overhang) {
    SolidBuilder solid;
    solid.extrude(
        {{0, 0}, {30, 0}, {30, 4}, {4, 4}, {4, 12}, {6 + overhang, 12}, {6 + overhang, 14}, {0, 14}}, {},
        20.0);
    return solid.mesh();
  };
  EXPECT_NE(comparison_verdict(compared(with_roof(6.0), with_roof(6.16), false)).find("Undercut grew to"),
            std::string::npos);
  EXPECT_NE(comparison_verdict(compared(with_roof(6.16), with_roof(6.0), false)).find("Undercut shrank to"),
            std::string::npos);
  const Comparison same = compared(plate_mesh({}), plate_mesh({.rib = 2.0}), false);
  EXPECT_NE(comparison_verdict(same).find("Undercut as before, 0 unit²"), std::string::npos)
      << comparison_verdict(same);
}

}  // namespace
}  // namespace moldlight
