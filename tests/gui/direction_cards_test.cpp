// Cards of the directions that the ranking recommends: what they say and where they lead.
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "gui/panels/panels.hpp"
#include "gui/quick_options.hpp"
#include "gui/window_with_part.hpp"
#include "io/mesh_writer.hpp"
#include "support/shapes.hpp"
#include "sweep/sweep.hpp"

namespace moldlight::gui::test {
namespace {

class CardWindow : public ::testing::Test {
 protected:
  explicit CardWindow(int directions = 40) : window(options(directions)) {}

  static OffscreenOptions options(int directions) {
    OffscreenOptions options = quick_options();
    options.size = {1440, 900};
    options.user.window.motion = false;
    options.user.sweep.directions = directions;
    options.user.sweep.refine = 1;
    options.user.sweep.rank = SweepRank::objective;  // which what nobody asked for does not ask about
    return options;
  }

  /// A block with a pocket in its side: along z one slide, along the pocket none.
  void open_part(const TriangleMesh& mesh = moldlight::test::plate_with_side_pocket({}).mesh) {
    const std::vector<Region> regions(mesh.facets.size(), Region::both);
    const std::string path = folder.file("part.stl");
    write_coloured_mesh(path, {.mesh = mesh, .regions = regions});
    window.app().open(path);
    window.wait_until_loaded();
    window.wait_until_measured();
  }
  void click(const std::string& control) {
    window.move_mouse(window.control(control).centre());
    window.frames(2);
    window.set_button(0, true);
    window.frame();
    window.set_button(0, false);
    window.frames(3);
  }
  [[nodiscard]] const SweepState& sweep() const { return window.state().sweep; }
  [[nodiscard]] bool has(const std::string& control) const {
    return window.app().controls().contains(control);
  }
  [[nodiscard]] bool writes(const std::string& text) const {
    const auto& texts = window.app().texts();
    return std::ranges::any_of(texts, [&](const DrawnText& each) { return each.text.starts_with(text); });
  }
  void allow_least_travel(double mm) {
    PartNotes notes;
    notes.settings = window.state().settings;
    notes.settings.actions.least_travel_mm = mm;
    window.app().set_notes(notes);
    window.frames(2);
  }

  moldlight::test::ScratchFolder folder;
  OffscreenWindow window;
};

TEST_F(CardWindow, LeadToWhatTheRankingRecommends) {
  open_part();
  window.wait_until_swept();
  ASSERT_TRUE(sweep().result && sweep().result->recommended);
  SweepSettings settings = sweep().result->settings;
  EXPECT_EQ(settings.rank, SweepRank::mold);
  const SweepResult expected = run_sweep(window.state().model, settings, Progress{}, {});
  EXPECT_EQ(sweep().result->recommended->direction, expected.recommended->direction);
  ASSERT_FALSE(sweep().cards.empty());
  const DirectionCard first = sweep().cards.front();
  EXPECT_EQ(first.direction, expected.recommended->direction);
  EXPECT_TRUE(first.verdict.starts_with("two-plate, ")) << first.verdict;
  EXPECT_TRUE(first.offered);
  ASSERT_FALSE(first.trade.wins.empty());
  EXPECT_EQ(first.trade.wins.front(), "needs 1 slide less");
  EXPECT_TRUE(writes("+ needs 1 slide less"));
  EXPECT_TRUE(writes("two-plate")) << "in the card";

  EXPECT_TRUE(has("verdict go")) << "the verdict leads there";
  click("card 1");
  EXPECT_EQ(window.state().settings.direction.unit(), first.direction);
  window.wait_until_measured();
  window.frames(2);
  EXPECT_TRUE(sweep().cards.front().here);
  EXPECT_FALSE(sweep().cards.front().offered);
  EXPECT_EQ(sweep().result->recommended->direction, first.direction) << "nothing is searched for anew";
  EXPECT_FALSE(window.app().sweeping());
  EXPECT_FALSE(has("verdict go")) << "nor away from it, whatever others win";
}

TEST_F(CardWindow, HaveTheWholeVerdictWhereThereIsRoom) {
  open_part(moldlight::test::hollow_sphere({}).mesh);
  window.wait_until_swept();
  ASSERT_FALSE(sweep().cards.empty());
  const DirectionCard& card = sweep().cards.front();
  ASSERT_TRUE(card.trade.wins.empty() && card.trade.costs.empty()) << card.verdict;
  const std::string last = card.verdict.substr(card.verdict.rfind(' ') + 1);
  EXPECT_TRUE(std::ranges::any_of(window.app().texts(), [&](const DrawnText& each) {
    return each.text.ends_with(last);
  })) << card.verdict;
}

TEST_F(CardWindow, FoldsAndShowsAllDirections) {
  open_part();
  window.wait_until_swept();
  ASSERT_TRUE(has("card 1"));
  EXPECT_FALSE(has("direction 1"));
  EXPECT_TRUE(writes("recommended")) << "the card says it";
  click("All directions");
  window.frames(2);
  EXPECT_TRUE(has("direction 1"));
  click("close directions");
  window.frames(2);
  EXPECT_FALSE(has("direction 1"));
  ASSERT_TRUE(has("card 1"));
}

TEST_F(CardWindow, StartAnewWhenSettingsOfSideActionsChange) {
  open_part();
  window.wait_until_swept();
  const auto former = sweep().result;
  allow_least_travel(1000.0);
  // A quick machine has found the new ones already.
  EXPECT_TRUE(sweep().cards.empty() || sweep().result != former) << "of other settings";
  window.wait_until_measured();
  window.wait_until_swept();
  ASSERT_TRUE(sweep().result);
  EXPECT_NE(sweep().result, former);
  EXPECT_EQ(sweep().result->settings.action_settings.least_travel_mm, 1000.0);
  EXPECT_EQ(sweep().result->candidates.front().undercuts->count, 0U);
}

class LongCardWindow : public CardWindow {
 protected:
  LongCardWindow() : CardWindow(100'000) {}
  void wait_for_cards() {
    for (int k = 0; k < 20'000 && sweep().cards.empty(); ++k) {
      window.frame();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
};

TEST_F(LongCardWindow, TheRecommendedOneIsThereWhileOthersAreLookedFor) {
  open_part();
  wait_for_cards();
  ASSERT_FALSE(sweep().cards.empty());
  ASSERT_TRUE(sweep().running.has_value());
  EXPECT_GT(sweep().running->share, 0.0);
  const glm::dvec3 recommended = sweep().cards.front().direction;
  // A hand that turns the direction has the processor for itself; what is known stays.
  window.frames(10);  // the view makes room for them
  const glm::vec2 tip = window.control("core arrow").centre();
  window.move_mouse(tip);
  window.frames(2);
  window.set_button(0, true);
  window.frames(2);
  window.move_mouse(tip + glm::vec2(60.0F, 40.0F));
  window.frames(3);
  EXPECT_FALSE(sweep().running.has_value());
  EXPECT_FALSE(sweep().cards.empty());
  window.set_button(0, false);
  window.frames(3);
  window.wait_until_measured();
  window.frames(3);
  ASSERT_TRUE(sweep().running.has_value()) << "at rest it begins anew";
  EXPECT_FALSE(sweep().cards.empty());
  EXPECT_EQ(sweep().cards.front().direction, recommended);
  click("Cancel");
  window.wait_until_swept();
  ASSERT_FALSE(window.app().sweeping());
  EXPECT_FALSE(sweep().result->complete);
  window.frames(10);
  EXPECT_FALSE(window.app().sweeping()) << "what was cancelled stays so";
}

}  // namespace
}  // namespace moldlight::gui::test
