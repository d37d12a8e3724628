// A score that ends early must be on the side that the whole score is on, and beside another direction a
// score to the end is what it is alone.
#include "sweep/ray_scorer.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mold/map_frame.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

constexpr std::uint64_t k_scored_samples = 20'000;

/// A part with its samples; scores one task after the other.
class Scored {
 public:
  explicit Scored(const TriangleMesh& mesh)
      : model_(test::model_of(mesh)),
        samples_(sample_surface_evenly(model_->part.mesh, model_->geometry, model_->frame, k_scored_samples)),
        scorer_({model_->rays(), model_->geometry, samples_}, 1.0, 1.0 / 2048.0) {}

  DirectionScore operator()(const ScoringTask& task) { return scorer_.score({&task, 1}).front(); }
  [[nodiscard]] double total_area() const { return model_->geometry.total_area; }

 private:
  std::shared_ptr<const PartModel> model_;
  SurfaceSamples samples_;
  RayScorer scorer_;
};

std::vector<test::Shape> shapes() {
  return {test::cup_with_side_hole({}), test::snap_hook({}), test::t_slot({}), test::oblique_l_bracket({})};
}

/// Directions near the shape's own and far from it.
std::vector<glm::dvec3> directions_around(const glm::dvec3& direction) {
  std::vector<glm::dvec3> all;
  for (const double deg : {0.2, 3.0, 20.0, 70.0}) {
    for (const glm::dvec3& d : ring_around(direction, deg, 5, 10.0)) all.push_back(d);
  }
  return all;
}

TEST(RayScorer, BesideAnotherDirectionWithoutALimitIsTheSameToTheBit) {
  for (const test::Shape& shape : shapes()) {
    Scored scored(test::subdivided(shape.mesh, 2000));
    const DirectionScore own = scored({.direction = shape.direction});
    for (const glm::dvec3& direction : directions_around(shape.direction)) {
      const DirectionScore alone = scored({.direction = direction});
      const DirectionScore beside = scored({.direction = direction, .beside = &own});
      EXPECT_FALSE(alone.given_up || beside.given_up);
      EXPECT_EQ(alone.areas.values, beside.areas.values) << shape.name;
      EXPECT_EQ(alone.undercut_error, beside.undercut_error) << shape.name;
      EXPECT_EQ(alone.shadow_area, beside.shadow_area) << shape.name;
      ASSERT_TRUE(alone.undercut_samples && beside.undercut_samples);
      EXPECT_EQ(*alone.undercut_samples, *beside.undercut_samples) << shape.name;
    }
  }
}

TEST(RayScorer, WhatEndsEarlyIsOnTheSideOfTheWholeScore) {
  std::size_t given_up = 0, surely_below = 0, undecided = 0;
  for (const test::Shape& shape : shapes()) {
    Scored scored(test::subdivided(shape.mesh, 2000));
    const DirectionScore own = scored({.direction = shape.direction});
    for (const glm::dvec3& direction : directions_around(shape.direction)) {
      const double whole = scored({.direction = direction}).undercut();
      for (const double share : {-0.05, -0.01, -0.001, 0.001, 0.01, 0.05}) {
        const double limit = whole + share * scored.total_area();
        const std::string of = std::string(shape.name) + ", limit off by " + std::to_string(share);
        const DirectionScore alone = scored({direction, limit});
        const DirectionScore beside = scored({direction, limit, &own});
        const DirectionScore side = scored({direction, limit, &own, true});
        // Never given up below the limit, and never taken for below it above.
        for (const DirectionScore& score : {alone, beside, side})
          EXPECT_TRUE(!score.given_up || whole > limit) << of;
        EXPECT_EQ(side.undercut() > limit, whole > limit) << of;
        // One that is not given up was scored to the end, unless the side alone was asked for.
        for (const DirectionScore& score : {alone, beside}) {
          EXPECT_EQ(score.undercut_samples != nullptr, !score.given_up) << of;
          EXPECT_TRUE(score.given_up || score.undercut() == whole) << of;
        }
        given_up += beside.given_up ? 1 : 0;
        surely_below += !side.given_up && !side.undercut_samples ? 1 : 0;
        undecided += side.undercut_samples ? 1 : 0;
      }
    }
  }
  // All three happen, so that none of the above is said of nothing.
  EXPECT_GT(given_up, 20U);
  EXPECT_GT(surely_below, 20U);
  EXPECT_GT(undecided, 20U);
}

}  // namespace
}  // namespace moldlight
