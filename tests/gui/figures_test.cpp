// The legend's figures are those of every other output, to the last digit.
#include <algorithm>
#include <chrono>
#include <thread>

#include <nlohmann/json.hpp>

#include "classify/classifier.hpp"
#include "classify/classify_report.hpp"
#include "classify/headless.hpp"
#include "gui/window_with_part.hpp"

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
  const Classification expected = classifier.classify(state().settings, Progress{});
  EXPECT_GT(expected.areas[Region::undercut], 0.0);
  EXPECT_EQ(report(*state().model, *state().figures.shown).dump(), report(*model, expected).dump());
  for (const Region region : k_regions)
    EXPECT_EQ(state().figures.shown->areas[region], expected.areas[region]);
}

TEST_F(WindowWithPart, FiguresAreOfTheOldSettingsUntilThereAreOthers) {
  window.wait_until_measured();
  const RegionValues before = state().figures.shown->areas;
  key({.key = 'X'});
  window.wait_until_measured();
  EXPECT_FALSE(state().figures.stale);
  EXPECT_TRUE(state().figures.shown->answers(state().settings));
  // Reversing the direction swaps core and cavity.
  EXPECT_NEAR(state().figures.shown->areas[Region::core], before[Region::cavity], 1e-12 * before.total());
  EXPECT_NEAR(state().figures.shown->areas[Region::cavity], before[Region::core], 1e-12 * before.total());
  EXPECT_NEAR(state().figures.shown->areas[Region::undercut], before[Region::undercut],
              1e-12 * before.total());
}

TEST_F(WindowWithPart, AChangeWhileMeasuringIsMeasuredLast) {
  for (int k = 0; k < 5; ++k) {
    key({.key = k_right});
    window.frames(12);  // the measuring of one change has begun when the next one comes
  }
  window.wait_until_measured();
  EXPECT_TRUE(state().figures.shown->answers(state().settings));
}

/// Turns the direction by its arrow, a little a frame, and keeps it in the hand.
class Dragging : public WindowWithPart {
 protected:
  void grip() {
    window.wait_until_measured();
    tip = window.control("core arrow").centre();
    move_to(tip);
    window.set_button(0, true);
    window.frames(2);
  }
  /// A frame, and the time that a display takes for one.
  void turn_to(int step) {
    window.move_mouse(tip + glm::vec2(6 + 2 * step, step));
    window.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  glm::vec2 tip{0.0F};
};

TEST_F(Dragging, FiguresFollowTheHandAndAreNeverPale) {
  grip();
  constexpr int k_steps = 60;
  const auto start = std::chrono::steady_clock::now();
  std::uint64_t revision = state().figures.revision;
  glm::dvec3 shown = state().figures.shown->direction, former = direction();
  int followed = 0;
  for (int step = 0; step < k_steps; ++step) {
    turn_to(step);
    EXPECT_NE(direction(), former) << "the direction waits for something";
    former = direction();
    EXPECT_FALSE(state().figures.pale);
    if (state().figures.revision == revision) continue;
    revision = state().figures.revision;
    EXPECT_NE(state().figures.shown->direction, shown);
    shown = state().figures.shown->direction;
    ++followed;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_GE(followed, std::min(10.0 * took.count(), 0.5 * k_steps)) << "in " << took.count() << " s";
  window.set_button(0, false);
  window.wait_until_measured();
  EXPECT_TRUE(state().figures.shown->answers(state().settings));
}

TEST_F(Dragging, TheSplitMeshComesWhenTheHandRests) {
  grip();
  for (int step = 0; step < 10; ++step) turn_to(step);
  ASSERT_TRUE(state().figures.shown);
  EXPECT_FALSE(state().figures.shown->split) << "while it moves";
  // Still held, but at rest.
  window.wait_until_measured();
  EXPECT_TRUE(state().figures.shown->answers(state().settings));
  ASSERT_TRUE(state().figures.shown->split);
  const RegionValues at_rest = state().figures.shown->areas;
  const auto split = state().figures.shown->split;
  window.set_button(0, false);
  window.frames(3);
  window.wait_until_measured();
  EXPECT_EQ(state().figures.shown->split, split) << "found once";
  EXPECT_EQ(state().figures.shown->areas.values, at_rest.values);
}

TEST_F(WindowWithPart, FiguresByAnotherReadoutComeWhenTheSettingsRest) {
  turn_maps_drawer();
  click("Accuracy");
  click("Readout=facet-id");
  move_to({640, 60});  // beside the list of accuracy: it closes
  press();
  window.wait_until_measured();
  EXPECT_EQ(state().figures.shown->settings.readout, Readout::facet_id);
  EXPECT_TRUE(state().figures.shown->split);
  const auto revision = state().figures.revision;
  const glm::vec2 tip = window.control("core arrow").centre();
  drag(tip, tip + glm::vec2(70, 25), false);
  EXPECT_EQ(state().figures.revision, revision);
  window.frames(30);
  EXPECT_EQ(state().figures.revision, revision) << "while the hand holds the arrow";
  EXPECT_TRUE(state().figures.pale);
  window.set_button(0, false);
  window.wait_until_measured();
  EXPECT_TRUE(state().figures.shown->answers(state().settings));
  EXPECT_FALSE(state().figures.pale);
}

}  // namespace
}  // namespace moldlight::gui::test
