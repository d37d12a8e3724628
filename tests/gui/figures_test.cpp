// The legend's figures are those of every other output, to the last digit.
#include "gui/window_with_part.hpp"
#include "session/classifier.hpp"
#include "session/classify_report.hpp"
#include "session/headless.hpp"

namespace moldlight::gui::test {
namespace {

/// What `classify --json` says, but for times.
nlohmann::ordered_json report(const PartModel& model, const Classification& result) {
  nlohmann::ordered_json json = classify_json(model, result);
  json.erase("timings_ms");
  return json;
}

TEST_F(WindowWithPart, LegendEqualsClassify) {
  window.wait_until_measured();
  ASSERT_TRUE(state().figures.shown);
  EXPECT_FALSE(state().figures.stale);

  const auto model = load_part(part.file(), ReadOptions{}, Progress{});
  const auto context = create_context(Backend::automatic);
  Classifier classifier(*context, model);
  const Classification expected = classifier.classify(method(), Progress{});
  EXPECT_GT(expected.areas[Region::undercut], 0.0);
  EXPECT_EQ(report(*state().model, *state().figures.shown).dump(), report(*model, expected).dump());
  for (const Region region : k_regions)
    EXPECT_EQ(state().figures.shown->areas[region], expected.areas[region]);
}

TEST_F(WindowWithPart, FiguresAreStaleUntilMeasuredAnew) {
  window.wait_until_measured();
  const RegionValues before = state().figures.shown->areas;
  key({.key = 'X'});
  EXPECT_TRUE(state().figures.stale);
  ASSERT_TRUE(state().figures.shown);
  EXPECT_EQ(state().figures.shown->areas.values, before.values);
  window.wait_until_measured();
  EXPECT_FALSE(state().figures.stale);
  EXPECT_EQ(state().figures.shown->settings, method());
  // Reversing the direction swaps core and cavity.
  EXPECT_NEAR(state().figures.shown->areas[Region::core], before[Region::cavity], 0.01 * before.total());
  EXPECT_NEAR(state().figures.shown->areas[Region::cavity], before[Region::core], 0.01 * before.total());
}

TEST_F(WindowWithPart, AChangeWhileMeasuringIsMeasuredLast) {
  for (int k = 0; k < 5; ++k) {
    key({.key = k_right});
    window.frames(12);  // the measuring of one change has begun when the next one comes
  }
  window.wait_until_measured();
  EXPECT_EQ(state().figures.shown->settings, method());
}

}  // namespace
}  // namespace moldlight::gui::test
