// Sweeps of parts whose best parting directions are known: one, a cone of them, two alike, or none that is
// free of undercut.
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"
#include "sweep/candidates/candidate.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

using test::Loop;
using test::Shape;
using test::ShapeSettings;
using test::SolidBuilder;

SweepSettings quick_settings() {
  SweepSettings settings;
  settings.directions = 200;
  settings.refine = 3;
  settings.rank = SweepRank::objective;
  settings.top = 4;
  return settings;
}

SweepResult sweep_of(const TriangleMesh& mesh, const SweepSettings& settings = quick_settings()) {
  SweepResult result = run_sweep(test::model_of(mesh), settings, Progress{}, {});
  EXPECT_TRUE(result.complete);
  EXPECT_FALSE(result.candidates.empty());
  return result;
}

double undercut(const SweepCandidate& candidate) { return candidate.classification.areas[Region::undercut]; }
double uncertainty(const SweepCandidate& candidate) { return candidate.classification.uncertainty.total(); }

double angle_deg(const SweepCandidate& candidate, const glm::dvec3& direction) {
  return line_angle_deg(candidate.classification.direction, direction);
}

Loop square(double low, double high, double z) {
  return {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}};
}

Loop reversed(const Loop& loop) { return {loop.rbegin(), loop.rend()}; }

constexpr double k_pocket_depth = 18.0, k_floor = 6.0, k_block = 30.0;

/// A block with a square pocket from above, whose walls have this draft.
TriangleMesh drafted_pocket(double draft_deg) {
  const double inset = k_pocket_depth * std::tan(glm::radians(draft_deg));
  const Loop rim = square(5.0, 25.0, k_floor + k_pocket_depth),
             floor = square(5.0 + inset, 25.0 - inset, k_floor);
  const glm::dvec3 size(k_block, k_block, k_floor + k_pocket_depth);
  SolidBuilder solid;
  solid.box({0, 0, 0}, size, {5});
  solid.face(test::box_face({0, 0, 0}, size, 5), {rim});
  solid.walls(reversed(floor), reversed(rim));
  solid.face(floor);
  return solid.mesh();
}

TEST(SweepKnownAnswers, TheOnlyDirectionWithoutUndercutIsFound) {
  for (const std::uint32_t seed : {3U, 4U}) {
    const Shape shape = turned(cup(ShapeSettings{}), test::random_rotation(seed));
    const SweepResult result = sweep_of(shape.mesh);
    const SweepCandidate& best = result.candidates.front();
    EXPECT_LT(angle_deg(best, shape.direction), 0.05);
    EXPECT_LE(undercut(best), uncertainty(best));
    ASSERT_TRUE(best.tilt);
    EXPECT_LT(best.tilt->deg, 0.3) << "its walls have no draft";
    for (const SweepCandidate& other : result.candidates) {
      if (angle_deg(other, shape.direction) < 0.2) continue;
      EXPECT_GT(other.tie_group, 1U);
      EXPECT_GT(undercut(other), undercut(best) + uncertainty(best) + uncertainty(other));
    }
  }
}

TEST(SweepKnownAnswers, DraftIsTheTiltMargin) {
  for (const double draft_deg : {3.0, 8.0}) {
    const glm::dquat rotation = test::random_rotation(7);
    const SweepSettings settings = quick_settings();
    const SweepResult result = sweep_of(test::rotated(drafted_pocket(draft_deg), rotation), settings);
    const SweepCandidate& best = result.candidates.front();
    EXPECT_LE(undercut(best), uncertainty(best));
    const double off_deg = angle_deg(best, rotation * glm::dvec3(0, 0, 1));
    EXPECT_LT(off_deg, 0.05);
    // A wall that overhangs shades itself up to the lateral tolerance over the tangent of the overhang from
    // its upper end; the margin ends where what is shaded is the growth allowed.
    const double growth = 0.01 * settings.tilt_growth_pct * best.classification.total_area;
    const double shaded = growth / 20.0;
    const double past_deg =
        glm::degrees(std::atan(best.classification.lateral_tolerance / (k_pocket_depth - shaded)));
    ASSERT_TRUE(best.tilt);
    // Eight sides are tried: one lies within 22.5 degrees of a wall's. Margins are found to a tenth.
    EXPECT_GE(best.tilt->deg, 0.9 * draft_deg) << draft_deg;
    EXPECT_LE(best.tilt->deg, (draft_deg + past_deg) / std::cos(glm::radians(22.5)) + 0.1) << draft_deg;
    EXPECT_NEAR(line_angle_deg(best.tilt->toward, best.classification.direction), best.tilt->deg,
                0.12 * best.tilt->deg)
        << "it lies just past the margin";
    for (const SweepCandidate& candidate : result.candidates) {
      const double lean_deg = angle_deg(candidate, rotation * glm::dvec3(0, 0, 1));
      EXPECT_EQ(candidate.tie_group == 1, undercut(candidate) <= uncertainty(candidate) + uncertainty(best));
      if (lean_deg < draft_deg) {
        EXPECT_EQ(candidate.tie_group, 1U) << lean_deg;
      }
    }
  }
}

TEST(SweepKnownAnswers, AVoidIsAnUndercutForEveryDirection) {
  const Shape shape = hollow_sphere(ShapeSettings{});
  const SweepResult result = sweep_of(shape.mesh);
  ASSERT_EQ(result.candidates.size(), 4U);
  for (const SweepCandidate& candidate : result.candidates) {
    EXPECT_NEAR(undercut(candidate), shape.expected[Region::undercut],
                uncertainty(candidate) + 1e-4 * candidate.classification.total_area);
    EXPECT_EQ(candidate.tie_group, 1U);
  }
}

TEST(SweepKnownAnswers, TheBestMayLeaveAnUndercutOfKnownArea) {
  const Shape shape = turned(cup_with_side_hole(ShapeSettings{}), test::random_rotation(11));
  const SweepResult result = sweep_of(shape.mesh);
  const SweepCandidate& best = result.candidates.front();
  EXPECT_LT(angle_deg(best, shape.direction), 0.05);
  EXPECT_NEAR(undercut(best), shape.expected[Region::undercut],
              uncertainty(best) + 1e-4 * best.classification.total_area);
  EXPECT_EQ(figure_value(direction_figure("undercuts"), best), 1.0);
}

/// A cube with the same deep pocket in its top and in its +x side.
TriangleMesh two_pockets() {
  const glm::dvec3 size(30.0), top_low(3.0, 12.0, 14.0), top_high(9.0, 18.0, 30.0), side_low(14.0, 12.0, 3.0),
      side_high(30.0, 18.0, 9.0);
  SolidBuilder solid;
  solid.box({0, 0, 0}, size, {1, 5});
  solid.box(top_low, top_high, {5}, true);
  solid.box(side_low, side_high, {1}, true);
  solid.face(test::box_face({0, 0, 0}, size, 5), {test::box_face(top_low, top_high, 5)});
  solid.face(test::box_face({0, 0, 0}, size, 1), {test::box_face(side_low, side_high, 1)});
  return solid.mesh();
}

TEST(SweepKnownAnswers, TwoEqualDirectionsTie) {
  const double pocket = 4.0 * 6.0 * 16.0 + 6.0 * 6.0;
  const SweepResult result = sweep_of(two_pockets());
  ASSERT_GE(result.candidates.size(), 3U);
  const SweepCandidate &first = result.candidates[0], &second = result.candidates[1];
  EXPECT_EQ(first.tie_group, 1U);
  EXPECT_EQ(second.tie_group, 1U);
  EXPECT_GT(result.candidates[2].tie_group, 1U);
  const glm::dvec3 x(1, 0, 0), z(0, 0, 1);
  EXPECT_LT(std::min(angle_deg(first, x), angle_deg(first, z)), 1e-6);
  EXPECT_LT(std::min(angle_deg(second, x), angle_deg(second, z)), 1e-6);
  EXPECT_NEAR(line_angle_deg(first.classification.direction, second.classification.direction), 90.0, 1e-6);
  for (const SweepCandidate* candidate : {&first, &second}) {
    EXPECT_NEAR(undercut(*candidate), pocket,
                uncertainty(*candidate) + 1e-4 * candidate->classification.total_area);
    EXPECT_DOUBLE_EQ(figure_value(direction_figure("draw_depth"), *candidate).value_or(0.0), 30.0);
  }
}

TEST(SweepKnownAnswers, ScoresByRaysStateTwoStandardErrors) {
  SweepSettings settings = quick_settings();
  settings.engine = SweepEngine::rays;
  settings.thorough = true;
  settings.kinds = {CandidateKind::uniform};
  settings.directions = 12;
  settings.refine = 0;
  settings.top = 1;
  const TriangleMesh mesh = test::cup_with_side_hole({}).mesh;
  const double area = facet_geometry(mesh).total_area, count = settings.scoring_samples + 2.0;
  const SweepResult result = sweep_of(mesh, settings);
  for (std::size_t i = 0; i < 12; ++i) {
    const EvaluatedDirection& evaluated = result.evaluated[i];
    // One sample more of either kind, so that none seen is not none there.
    const double share = (evaluated.undercut / area * settings.scoring_samples + 1.0) / count;
    EXPECT_NEAR(evaluated.undercut_error, 2.0 * area * std::sqrt(share * (1.0 - share) / count), 1e-9 * area);
  }
}

TEST(SweepKnownAnswers, DirectionsFoundBySearchAreListedApart) {
  SweepSettings settings = quick_settings();
  settings.kinds = {CandidateKind::uniform};
  settings.directions = 500;
  settings.apart_deg = 15.0;
  const SweepResult result = sweep_of(test::cup_with_side_hole({}).mesh, settings);
  ASSERT_EQ(result.candidates.size(), 4U);
  for (std::size_t b = 0; b < 4; ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      EXPECT_GT(angle_deg(result.candidates[a], result.candidates[b].candidate.direction), 15.0);
    }
  }
}

}  // namespace
}  // namespace moldlight
