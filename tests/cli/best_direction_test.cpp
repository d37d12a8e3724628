// What --direction best says of the direction that it takes, on stderr and in JSON.
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "cli/small_parts.hpp"
#include "support/mesh_edits.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

using test::json_of;
using test::run_moldlight;

constexpr double k_turn_deg = 25.0;
constexpr const char* k_sentence = "the best direction is not an axis of the file: ";

/// A plate with a recess that opens upwards, turned about x.
TriangleMesh plate(double turn_deg) {
  test::SolidBuilder solid;
  const glm::dvec3 size(60, 40, 10), low(10, 8, 4), high(50, 32, 10);
  solid.box({0, 0, 0}, size, {5});
  solid.box(low, high, {5}, true);
  solid.face(test::box_face({0, 0, 0}, size, 5), {test::box_face(low, high, 5)});
  return test::rotated(solid.mesh(), glm::angleAxis(glm::radians(turn_deg), glm::dvec3(1, 0, 0)));
}

class BestDirectionCommand : public ::testing::Test {
 protected:
  BestDirectionCommand() {
    write(straight, 0.0);
    write(turned, k_turn_deg);
  }
  static void write(const std::string& file, double turn_deg) {
    const TriangleMesh mesh = plate(turn_deg);
    write_coloured_mesh(file, {mesh, std::vector<Region>(mesh.facets.size(), Region::core)});
  }
  test::SmallParts parts{0};
  std::string straight = parts.path("parts/straight.obj"), turned = parts.path("parts/turned.obj");
};

TEST_F(BestDirectionCommand, SaysHowFarItIsOffAnAxis) {
  for (const char* command : {"classify", "actions", "mold"}) {
    const auto run = run_moldlight({command, turned, "--unit", "mm", "--direction", "best", "--json", "-"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.err.find(k_sentence), std::string::npos) << run.err;
    const auto best = json_of(run.out)["best_direction"];
    EXPECT_NEAR(best["off_axis_deg"].get<double>(), k_turn_deg, 1e-4) << best;
    EXPECT_EQ(best["off_axis"].get<std::string>().find(k_sentence), 0U) << best;
    EXPECT_NE(best["off_axis"].get<std::string>().find("25° from z"), std::string::npos) << best;
    EXPECT_NE(best["name"].get<std::string>().find("normal of the largest plane"), std::string::npos) << best;
    EXPECT_NE(best["why"].get<std::string>().find("The core is on the side of"), std::string::npos) << best;
  }
}

TEST_F(BestDirectionCommand, IsQuietAboutAnAxis) {
  const auto run =
      run_moldlight({"classify", straight, "--unit", "mm", "--direction", "best", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err.find(k_sentence), std::string::npos) << run.err;
  const auto best = json_of(run.out)["best_direction"];
  EXPECT_EQ(best["off_axis_deg"], 0.0);
  EXPECT_TRUE(best["off_axis"].is_null()) << best;
  const auto given = run_moldlight({"classify", straight, "--unit", "mm", "--direction", "z", "--json", "-"});
  EXPECT_FALSE(json_of(given.out).contains("best_direction")) << "it was not asked for";
}

TEST_F(BestDirectionCommand, OfABatchIsToldOfEachPart) {
  ASSERT_EQ(parts.plan("parts", "night", {"classify", "--direction", "best", "--unit", "mm"}).exit_code, 0);
  const auto run = parts.batch("run");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find(std::string("turned.obj: ") + k_sentence), std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("straight.obj"), std::string::npos) << run.err;
  std::size_t leaning = 0;
  for (const auto& [name, result] : parts.results()) {
    const auto best = result["report"]["best_direction"];
    EXPECT_EQ(best["off_axis"].is_null(), best["off_axis_deg"] == 0.0) << best;
    leaning += best["off_axis"].is_null() ? 0 : 1;
  }
  EXPECT_EQ(leaning, 1U);
}

}  // namespace
}  // namespace moldlight
