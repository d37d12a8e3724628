#include <chrono>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mesh/part.hpp"
#include "support/shared_parts.hpp"
#include "unit/io/read_text.hpp"

namespace moldlight {
namespace {

using test::read_bytes;
using test::read_error;

/// A pin of radius 1 and height 2, and a unit cube beside it, in inches.
std::string pin_and_block() { return test::file_bytes(test::data_folder() / "pin_and_block_inch.step"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class Step : public testing::Test {
 protected:
  void SetUp() override {
    if (!MOLDLIGHT_STEP_BUILT) GTEST_SKIP() << "built without STEP support";
  }
};

TEST_F(Step, ReadsBodiesFacesAndUnit) {
  const Part part = read_bytes("part.step", pin_and_block());
  EXPECT_EQ(part.format, "STEP");
  EXPECT_EQ(part.unit, "in");
  EXPECT_TRUE(part.warnings.empty());
  ASSERT_EQ(part.bodies.size(), 2u);
  EXPECT_EQ(part.bodies[0].name, "pin");
  EXPECT_EQ(part.bodies[1].name, "block");
  EXPECT_EQ(part.bodies[1].first_facet, part.bodies[0].facet_count);
  EXPECT_EQ(part.bodies[1].facet_count, 12u);
  ASSERT_EQ(part.facet_source.size(), part.mesh.facets.size());
  EXPECT_EQ(std::set<std::uint32_t>(part.facet_source.begin(), part.facet_source.end()).size(), 9u);
  EXPECT_EQ(part.facet_source.front(), 0u);
  EXPECT_EQ(part.facet_source.back(), 8u);
  const FacetGeometry geometry = facet_geometry(part.mesh);
  const HealthReport health = health_report(part.mesh, geometry);
  EXPECT_TRUE(health.closed);
  EXPECT_EQ(health.components, 2u);
  EXPECT_NEAR(health.volume, 2.0 * std::numbers::pi + 1.0, 0.005);
  EXPECT_NEAR(health.area, 6.0 * std::numbers::pi + 6.0, 0.01);
}

/// Two pairs of upright pins of radius 2 and height 5, one pair turned by one radian about x, the other moved
/// by 30 along y; and a pin mirrored at z = -20.
TEST_F(Step, PlacesThePartsOfAssemblies) {
  const Part part = read_part((test::data_folder() / "pins_assembly_mm.step").string(), {}, Progress());
  EXPECT_EQ(part.unit, "mm");
  ASSERT_EQ(part.bodies.size(), 5u);
  EXPECT_EQ(part.bodies[0].name, "pin");
  EXPECT_EQ(part.bodies[4].name, "mirrored pin");
  const HealthReport health = health_report(part.mesh, facet_geometry(part.mesh));
  EXPECT_TRUE(health.closed);
  EXPECT_NEAR(health.volume, 5 * 20 * std::numbers::pi, 0.2);
  const glm::dvec3 centers[] = {{0, -2.5 * std::sin(1.0), 2.5 * std::cos(1.0)},
                                {10, -2.5 * std::sin(1.0), 2.5 * std::cos(1.0)},
                                {0, 30, 2.5},
                                {10, 30, 2.5},
                                {0, 0, -42.5}};
  for (std::size_t i = 0; i < 5; ++i) {
    const Part pin = extract_body(part, i);
    EXPECT_GT(signed_volume(pin.mesh), 0.0) << i;
    const Bounds box = bounds(pin.mesh);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(box.center()[axis], centers[i][axis], 0.01) << i;
  }
}

TEST_F(Step, FollowsTheDeflection) {
  const auto facets_and_gap = [](const ReadOptions& options) {
    const Part part = read_bytes("part.step", pin_and_block(), options);
    double least_radius = 1.0;
    for (FacetIndex facet = 0; facet < part.bodies[0].facet_count; ++facet) {
      for (int i = 0; i < 3; ++i) {
        const glm::dvec3 middle = 0.5 * (part.mesh.corner(facet, i) + part.mesh.corner(facet, (i + 1) % 3));
        const bool on_wall = part.facet_source[facet] == 0;
        if (on_wall) least_radius = std::min(least_radius, std::hypot(middle.x, middle.y));
      }
    }
    return std::pair(part.mesh.facets.size(), 1.0 - least_radius);
  };
  const auto [fine_facets, fine_gap] =
      facets_and_gap({.linear_deflection = 0.0001, .angular_deflection_deg = 30.0});
  const auto [coarse_facets, coarse_gap] =
      facets_and_gap({.linear_deflection = 0.01, .angular_deflection_deg = 30.0});
  EXPECT_GT(fine_facets, coarse_facets);
  EXPECT_LT(fine_gap, 0.0002);
  EXPECT_LT(coarse_gap, 0.02);
  EXPECT_GT(coarse_gap, 0.0005);
  const auto [angular_facets, angular_gap] =
      facets_and_gap({.linear_deflection = 1.0, .angular_deflection_deg = 2.0});
  EXPECT_LT(angular_gap, 0.002);
  EXPECT_GT(angular_facets, coarse_facets);
}

TEST_F(Step, GivesTheSameFacetsEachTime) {
  const Part first = read_bytes("part.step", pin_and_block());
  const Part second = read_bytes("part.step", pin_and_block());
  EXPECT_EQ(first.mesh.vertices, second.mesh.vertices);
  EXPECT_EQ(first.mesh.facets, second.mesh.facets);
}

TEST_F(Step, SaysWhatIsMissingOrFaulty) {
  const Part open = read_bytes("part.step", replaced(pin_and_block(), "ADVANCED_FACE", "ADVANCED_FUCE"));
  ASSERT_FALSE(open.warnings.empty());
  EXPECT_NE(open.warnings[0].find("of the STEP file"), std::string::npos);
  const Part no_unit = read_bytes(
      "part.step", replaced(pin_and_block(), "CONVERSION_BASED_UNIT('INCH'", "CONVERSION_BASED_UNIT('ELL'"));
  EXPECT_EQ(no_unit.unit, "mm");
  EXPECT_NEAR(bounds(no_unit.mesh).max.z, 50.8, 1e-9);
  EXPECT_FALSE(no_unit.warnings.empty());
}

TEST_F(Step, EndsCleanlyForDamagedFiles) {
  const std::string whole = pin_and_block();
  const std::string half = whole.substr(0, whole.size() / 2);
  EXPECT_EQ(read_error("a.step", half),
            "a.step: byte " + std::to_string(half.size()) +
                ": the STEP file ends without 'END-ISO-10303-21'; export the part again");
  EXPECT_TRUE(read_error("a.step", "ISO-10303-21;\nEND-ISO-10303-21;\n").starts_with("a.step: "));
  EXPECT_TRUE(read_error("a.step", half + "\nEND-ISO-10303-21;\n").starts_with("a.step: "));
  EXPECT_EQ(
      read_error("a.step", whole, {.max_facets = 100}),
      "a.step: gives more facets than the limit of 100; raise the limit (--max-facets) or the deflection");
}

/// A file that breaks OpenCASCADE ends the reading program, not this one.
TEST_F(Step, SurvivesWhatOpenCascadeDoesNot) {
  std::size_t ended_cleanly = 0;
  const std::string whole = pin_and_block();
  for (std::size_t at = whole.find("ADVANCED_FACE('',("); at != std::string::npos;
       at = whole.find("ADVANCED_FACE('',(", at + 1)) {
    std::string broken = whole;
    broken.insert(at + 18, "#99999");
    const std::string error = read_error("a.step", broken);
    EXPECT_TRUE(error == "no error" || error.starts_with("a.step: ")) << error;
    ++ended_cleanly;
  }
  EXPECT_EQ(ended_cleanly, 9u);
}

TEST_F(Step, StopsWhenCancelled) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  // Of this program and of the one that reads.
  const auto processor_s = [] {
    double seconds = 0.0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
      rusage usage{};
      ::getrusage(who, &usage);
      for (const timeval& time : {usage.ru_utime, usage.ru_stime})
        seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
    return seconds;
  };
  const double before = processor_s();
  const auto start = std::chrono::steady_clock::now();
  Progress* watched = nullptr;
  Progress progress([&](std::string_view, double) {
    if (std::chrono::steady_clock::now() - start > std::chrono::milliseconds(200)) watched->cancel();
  });
  watched = &progress;
  const std::string path = (*test::shared_folder() / "parts" / "m5_base26_main.stp").string();
  EXPECT_THROW(static_cast<void>(read_part(path, {.angular_deflection_deg = 1.0}, progress)), Cancelled);
  EXPECT_LT(processor_s() - before, 2.0);
}

TEST(StepSupport, IsNamedWhereItIsMissing) {
  if (MOLDLIGHT_STEP_BUILT) GTEST_SKIP() << "built with STEP support";
  EXPECT_TRUE(read_error("a.step", pin_and_block()).find("this build has no STEP support") !=
              std::string::npos);
}

}  // namespace
}  // namespace moldlight
