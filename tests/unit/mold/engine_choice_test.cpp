// The choice between maps and rays, and the quick look before either.
#include "mold/sweep/engine_choice.hpp"

#include <gtest/gtest.h>

#include "mold/sweep/screened_scorer.hpp"

namespace moldlight {
namespace {

TEST(EngineChoice, MapsForFineErrorsRaysForCoarseOnesOfLargeParts) {
  EXPECT_EQ(choose_engine(50'000, 0.0002, true).method, ScoringMethod::scan);
  EXPECT_EQ(choose_engine(500'000, 0.0002, true).method, ScoringMethod::scan);
  EXPECT_EQ(choose_engine(5'000, 0.001, true).method, ScoringMethod::scan);
  EXPECT_EQ(choose_engine(500'000, 0.003, true).method, ScoringMethod::rays);
  EXPECT_EQ(choose_engine(5'000'000, 0.001, true).method, ScoringMethod::rays);
}

TEST(EngineChoice, OnlyRaysForOpenParts) {
  EXPECT_EQ(choose_engine(50'000, 0.0002, false).method, ScoringMethod::rays);
}

TEST(EngineChoice, LessErrorTakesMore) {
  double resolution = 0.0, ray_samples = 0.0, scan_ms = 0.0, rays_ms = 0.0;
  for (const double error : {0.01, 0.001, 0.0003, 0.0001, 0.00001}) {
    const ScoringPlan plan = choose_engine(50'000, error, true);
    EXPECT_GE(plan.resolution, resolution);
    EXPECT_GT(plan.ray_samples, ray_samples);
    EXPECT_GE(plan.scan_ms, scan_ms);
    EXPECT_GT(plan.rays_ms, rays_ms);
    EXPECT_LE(plan.resolution, 8192);
    EXPECT_NEAR(ray_error(plan.ray_samples), error, 1e-6 * error);
    resolution = plan.resolution;
    ray_samples = plan.ray_samples;
    scan_ms = plan.scan_ms;
    rays_ms = plan.rays_ms;
  }
}

TEST(EngineChoice, SaysWhy) {
  const std::string reason = choose_engine(50'000, 0.0002, true).reason();
  EXPECT_NE(reason.find("512 texels"), std::string::npos) << reason;
  EXPECT_NE(choose_engine(500'000, 0.003, true).reason().find("exact rays"), std::string::npos);
}

/// Gives up above its limit if told so; counts how often it is asked.
class FakeScorer : public DirectionScorer {
 public:
  FakeScorer(double undercut, bool gives_up, int& asked)
      : undercut_(undercut), gives_up_(gives_up), asked_(&asked) {}

  [[nodiscard]] DirectionScore score(const glm::dvec3&) override {
    ++*asked_;
    DirectionScore score;
    score.areas[Region::undercut] = undercut_;
    score.given_up = gives_up_ && undercut_ > limit();
    return score;
  }

 private:
  double undercut_;
  bool gives_up_;
  int* asked_;
};

TEST(ScreenedScorer, AsksTheThoroughOneOnlyForWhatTheQuickOneDoesNotGiveUp) {
  int quick = 0, thorough = 0;
  ScreenedScorer scorer(std::make_unique<FakeScorer>(5.0, true, quick),
                        std::make_unique<FakeScorer>(4.0, false, thorough));
  EXPECT_EQ(scorer.score({0, 0, 1}).undercut(), 4.0);
  EXPECT_EQ(quick, 0);
  scorer.give_up_above(6.0);
  EXPECT_EQ(scorer.score({0, 0, 1}).undercut(), 4.0);
  EXPECT_EQ(thorough, 2);
  scorer.give_up_above(3.0);
  EXPECT_TRUE(scorer.score({0, 0, 1}).given_up);
  EXPECT_EQ(thorough, 2);
  EXPECT_EQ(quick, 2);
}

}  // namespace
}  // namespace moldlight
