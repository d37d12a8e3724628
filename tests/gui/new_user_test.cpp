// What made somebody hesitate who used the window for the first time.
#include <algorithm>
#include <filesystem>

#include "gui/draw/ui.hpp"
#include "gui/window_with_part.hpp"
#include "support/shared_parts.hpp"

namespace moldlight::gui::test {
namespace {

namespace fs = std::filesystem;

class NewUser : public WindowWithPart {
 protected:
  NewUser() { window.wait_until_measured(); }

  [[nodiscard]] bool says(std::string_view text) const {
    return std::ranges::any_of(window.app().texts(), [&](const DrawnText& each) {
      return each.text.find(text) != std::string::npos;
    });
  }
  [[nodiscard]] float height_of(const std::string& control) const {
    const ScreenBox box = window.control(control);
    return box.max.y - box.min.y;
  }
};

TEST_F(NewUser, FoldsAPanelByAClickOnItsTitle) {
  const ScreenBox open = window.control("panel Verdict");
  const glm::vec2 title(open.centre().x, open.min.y + 12.0F);
  move_to(title);
  press();
  window.settle();
  EXPECT_LT(height_of("panel Verdict"), 40.0F);
  window.pass_time(1.0);  // no double click
  move_to(title);
  press();
  window.settle();
  EXPECT_EQ(height_of("panel Verdict"), open.max.y - open.min.y);
  window.pass_time(1.0);  // a drag moves it
  drag(title, title + glm::vec2(-60.0F, 30.0F));
  window.settle();
  EXPECT_EQ(height_of("panel Verdict"), open.max.y - open.min.y);
  EXPECT_LT(window.control("panel Verdict").min.x, open.min.x);
}

TEST_F(NewUser, SeesAButtonThatOpensTheMold) {
  enter(Step::mold);
  window.wait_until_measured();
  ASSERT_TRUE(says("Open the mold"));
  click("play the shot");
  window.settle();
  EXPECT_EQ(state().settings.look.open_mold, 1.0);
  EXPECT_TRUE(says("Close the mold"));
  click("play the shot");
  EXPECT_EQ(state().settings.look.open_mold, 0.0);
}

TEST_F(NewUser, ExportsTheMoldWithItsSlidesByEnter) {
  enter(Step::mold);
  window.wait_until_measured();
  window.settle();
  ASSERT_FALSE(state().mold.solids->halves().inserts.empty());
  EXPECT_FALSE(says("Neither half forms ")) << "side actions do";
  EXPECT_TRUE(says("Both halves are made and checked."));
  click("export mold");
  ASSERT_TRUE(state().dialogs.exporting_mold);
  key({.key = k_enter});
  for (int k = 0; k < 200'000 && state().toasts.empty(); ++k) window.frame();
  ASSERT_FALSE(state().toasts.empty());
  EXPECT_TRUE(state().toasts.back().text.starts_with("Exported ")) << state().toasts.back().text;
  EXPECT_TRUE(fs::exists(part.output("cup-mold/core.stl")));
}

TEST_F(NewUser, ReadsEachAreaWithItsUnit) {
  enter(Step::undercuts);
  window.settle();
  EXPECT_TRUE(says("unit² · depth ")) << "in the list of undercuts";
  enter(Step::mold);
  window.wait_until_measured();
  window.settle();
  EXPECT_TRUE(says(" unit³")) << "of the halves";
}

TEST_F(NewUser, FindsTheWordsOfASectionWhereTheyWere) {
  const ScreenBox before = window.control("Section=along");
  click("Section=across");
  window.settle();
  const ScreenBox after = window.control("Section=along");
  EXPECT_EQ(after.min, before.min) << "the next click is where the mouse is";
}

TEST_F(NewUser, SeesTheStripBesideItsTooltips) {
  const ScreenBox step = window.control("step Direction");
  move_to(step.centre());
  window.pass_time(1.0);
  window.frames(4);
  bool told = false;
  for (const ImGuiWindow* const each : ImGui::GetCurrentContext()->Windows) {
    if ((each->Flags & ImGuiWindowFlags_Tooltip) == 0 || !each->Active || each->Hidden) continue;
    told = true;
    EXPECT_GE(each->Pos.y, step.max.y);
  }
  EXPECT_TRUE(told);
}

TEST_F(NewUser, HasNoGuideOnceAPartOfTheirOwnIsOpen) {
  OffscreenOptions own = options();
  own.shipped_parts = {(moldlight::test::asset_folder() / "parts" / "enclosure_lid.stl").string()};
  OffscreenWindow other(own);
  other.app().offer_tour();
  other.wait_until_loaded();
  ASSERT_TRUE(other.state().tour);
  other.app().open(part.file());
  other.wait_until_loaded();
  EXPECT_FALSE(other.state().tour);
}

TEST_F(NewUser, SeesWhatAppearsInAPresentationFadeIn) {
  key({.key = 294});
  ASSERT_TRUE(state().presented);
  double most = 0.0, least = 1.0;
  std::size_t frames = 0;
  for (int k = 0; k < 4000 && state().presented; ++k) {
    window.pass_time(0.1);
    window.frame();
    if (!state().presented || state().presented->fading == 0) continue;
    ++frames;
    most = std::max(most, state().presented->fade);
    least = std::min(least, state().presented->fade);
  }
  EXPECT_GE(frames, 6U) << "slides, and then the halves";
  EXPECT_EQ(most, 1.0);
  EXPECT_LT(least, 0.3);
}

}  // namespace
}  // namespace moldlight::gui::test
