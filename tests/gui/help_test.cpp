// The help sheet is searched by typing; hints show a newcomer what to do, each until it was done or
// dismissed.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "gui/window_with_part.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/shared_parts.hpp"

namespace moldlight::gui::test {
namespace {

class Help : public WindowWithPart {
 protected:
  [[nodiscard]] bool noted(std::string_view text) const {
    return std::ranges::any_of(window.app().texts(), [&](const DrawnText& each) {
      return each.text.find(text) != std::string::npos;
    });
  }
};

TEST_F(Help, TypingLeavesTheLinesThatHaveTheWords) {
  key({.key = 'H'});
  window.frames(3);
  EXPECT_TRUE(noted("section across"));
  EXPECT_TRUE(noted("bookmark the direction"));
  const Section section = state().settings.look.section;
  window.type("SECTION");
  window.frames(3);
  EXPECT_TRUE(noted("section across"));
  EXPECT_FALSE(noted("bookmark the direction"));
  EXPECT_EQ(state().settings.look.section, section) << "letters are no shortcuts there";
  key({.key = k_escape});
  EXPECT_FALSE(state().dialogs.help);
  key({.key = 'H'});
  window.frames(3);
  EXPECT_TRUE(noted("bookmark the direction")) << "whole again";
}

/// At the first start, with the part on which the tour is given.
class Tour : public ::testing::Test {
 public:
  Tour() {
    window.app().show_hints(true);
    window.app().offer_tour();
    window.wait_until_loaded();
    window.wait_until_measured();
  }

  OffscreenWindow window{first_start()};

 private:
  static OffscreenOptions first_start() {
    OffscreenOptions options = quick_options();
    options.user.window.motion = options.user.window.quick_sweep = false;
    options.shipped_parts = {(moldlight::test::asset_folder() / "parts" / "enclosure_lid.stl").string()};
    return options;
  }
};

TEST_F(Tour, GoesThroughTheStepsOfTheLidInAMinuteAndNeverAgain) {
  ASSERT_TRUE(window.state().tour);
  EXPECT_TRUE(window.state().path.ends_with("enclosure_lid.stl"));
  std::vector<Step> steps;
  double gone_s = 0.0;
  for (; window.state().tour && gone_s < 120.0; gone_s += 0.5) {
    if (steps.empty() || steps.back() != window.state().step) steps.push_back(window.state().step);
    EXPECT_TRUE(gone_s != 2.0 || window.app().controls().contains("end the tour"));
    window.pass_time(0.5);
    window.frame();
  }
  EXPECT_NEAR(gone_s, 60.0, 8.0);
  EXPECT_EQ(steps, (std::vector<Step>{Step::direction, Step::undercuts, Step::parting_line, Step::draft,
                                      Step::mold, Step::report}));
  EXPECT_TRUE(window.state().hints_done.contains(Hint::tour));
  window.app().offer_tour();
  EXPECT_FALSE(window.state().tour) << "never again";
}

TEST_F(Tour, EndsForWhoGoesElsewhere) {
  window.frames(3);
  ASSERT_TRUE(window.state().tour);
  window.press_key({.key = '6'});
  window.frames(3);
  EXPECT_EQ(window.state().step, Step::mold);
  EXPECT_FALSE(window.state().tour);
}

TEST_F(Tour, IsSkipped) {
  OffscreenOptions options = quick_options();
  options.user.window.motion = options.user.window.quick_sweep = false;
  options.shipped_parts = {(moldlight::test::asset_folder() / "parts" / "enclosure_lid.stl").string()};
  for (const bool by_key : {false, true}) {
    OffscreenWindow other(options);
    other.app().show_hints(true);
    other.app().offer_tour();
    other.wait_until_loaded();
    other.wait_until_measured();
    ASSERT_TRUE(other.state().tour);
    if (by_key) {
      other.press_key({.key = k_escape});
    } else {
      other.move_mouse(other.control("end the tour").centre());
      other.frames(2);
      other.set_button(0, true);
      other.frame();
      other.set_button(0, false);
    }
    other.frames(3);
    EXPECT_FALSE(other.state().tour);
  }
}

TEST_F(Help, HintsComeOneByOneAndGoForGood) {
  window.wait_until_measured();
  EXPECT_FALSE(noted("Drag the arrow")) << "only where they are asked for";
  window.app().show_hints(true);
  window.settle();
  EXPECT_TRUE(noted("Drag the arrow"));
  drag(window.control("core arrow").centre(), window.control("core arrow").centre() + glm::vec2(60, 30));
  window.wait_until_measured();  // the next one stands beside the verdict, which has other lines then
  EXPECT_FALSE(noted("Drag the arrow"));
  EXPECT_TRUE(noted("The regions of the part"));
  click("dismiss the hint");
  window.settle();
  EXPECT_FALSE(noted("The regions of the part"));
  EXPECT_TRUE(noted("Looking for the best"));
  EXPECT_GT(window.control("dismiss the hint").min.x, window.control("panel Direction").max.x)
      << "it covers no panel";
  key({.key = 'W'});
  EXPECT_FALSE(noted("Looking for the best"));
  EXPECT_EQ(state().hints_done, (std::set<Hint>{Hint::arrow, Hint::verdict, Hint::sweep}));
}

TEST_F(Help, OpensTheDocumentationInTheBrowser) {
  const moldlight::test::ScratchFolder folder;
  const std::string opener = folder.file("xdg-open"), opened = folder.file("opened");
  std::ofstream(opener) << "#!/bin/sh\necho \"$1\" > " << opened << ".new && mv " << opened << ".new "
                        << opened << '\n';
  std::filesystem::permissions(opener, std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder.file("") + ":" + path).c_str(), 1);
  ::setenv("DISPLAY", ":none", 1);
  key({.key = 'H'});
  click("Documentation");
  ::setenv("PATH", path.c_str(), 1);
  ::unsetenv("DISPLAY");
  const auto page = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() /
                    "share/doc/moldlight/html/index.html";
  if (!std::filesystem::exists(page)) {
    EXPECT_TRUE(noted("The documentation is not installed"));
    GTEST_SKIP() << "the documentation is not built: pandoc is missing";
  }
  EXPECT_TRUE(noted("The documentation opens in the browser"));
  for (int tries = 0; tries < 100 && !std::filesystem::exists(opened); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(moldlight::test::file_bytes(opened), page.string() + "\n");
}

}  // namespace
}  // namespace moldlight::gui::test
