// Proofs of a sweep: what they say of it, and when they end.
#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

SweepSettings quick_settings() {
  SweepSettings settings;
  settings.directions = 100;
  settings.refine = 2;
  settings.top = 3;
  settings.scoring_samples = 2000;
  return settings;
}

TEST(SweepProof, AllProofsTogetherEndAtTheLimit) {
  SweepSettings settings = quick_settings();
  settings.prove_pct = 0.001;
  settings.all_free_pct = 2.0;
  settings.proof_grade = ProofGrade::area;
  settings.proof_limit_s = 0.3;
  const auto mesh = test::subdivided(test::cup_with_side_hole({}).mesh, 20'000);
  const SweepResult result = run_sweep(test::model_of(mesh), settings, Progress{}, {});
  EXPECT_TRUE(result.complete) << "the proof's limit is not the sweep's";
  ASSERT_TRUE(result.proof && result.all_free);
  EXPECT_FALSE(result.proof->complete);
  EXPECT_FALSE(result.proof->holds);
  EXPECT_FALSE(result.all_free->complete);
  EXPECT_EQ(result.all_free->looked_at, 0U) << "the time was over before";
  EXPECT_EQ(result.all_free->proved_share, 0.0);
}

}  // namespace
}  // namespace moldlight
