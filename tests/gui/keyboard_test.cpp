// All of the window by keys: Tab goes through the controls, arrows and Space change them, Escape closes what
// is open, one at a time; and a click beside a popup does what it does there.
#include <filesystem>
#include <fstream>
#include <set>

#include "gui/sceneries.hpp"

namespace moldlight::gui::test {
namespace {

constexpr int k_space = 32, k_down = 264, k_page_down = 267, k_home = 268, k_end = 269, k_backspace = 259;

class Keys : public WindowSceneries {
 protected:
  void tab() { key({.key = k_tab}); }
  /// Goes on with Tab until the control has the keyboard, as the ring shows that changes the picture.
  void tab_to(const std::string& control) {
    std::string seen;
    for (int k = 0; k < 120; ++k) {
      if (window.app().focused() == control) return;
      tab();
      seen += window.app().focused() + ", ";
    }
    FAIL() << "Tab does not come to " << control << ", but to " << seen;
  }
  [[nodiscard]] bool any_popup() const {
    return std::ranges::any_of(ImGui::GetCurrentContext()->Windows, [](const ImGuiWindow* each) {
      return std::string_view(each->Name).starts_with("Popup") && each->Active;
    });
  }
};

TEST_F(Keys, TabReachesTheControlsOfAllPanelsAndComesRound) {
  std::set<std::string> seen;
  turn_maps_drawer();
  for (const Step step : {Step::part, Step::direction, Step::mold}) {
    enter(step);
    key({.key = k_escape});
    std::string first;
    for (int k = 0; k < 120; ++k) {
      tab();
      const std::string control = window.app().focused();
      if (k == 0) first = control;
      if (k > 0 && control == first) break;
      seen.insert(control);
      if (state().settings.direction.given() != glm::dvec3(0, 0, 1)) ADD_FAILURE() << control;
    }
    EXPECT_EQ(window.app().focused(), first) << "round";
    key({.key = k_tab, .shift = true});
    EXPECT_NE(window.app().focused(), first);
  }
  for (const char* control : {"cup.obj##part",
                              "open",
                              "help",
                              "settings",
                              "+X",
                              "−Z",
                              "flip",
                              "bookmark",
                              "x",
                              "elevation",
                              "Near-vertical below",
                              "Kernel",
                              "Map resolution",
                              "Mark the difference",
                              "Hatching",
                              "Open the mold (O)",
                              "Opened",
                              "Section",
                              "Find directions",
                              "step Part",
                              "step Report"})
    EXPECT_TRUE(seen.contains(control)) << control;
}

TEST_F(Keys, SpaceAndArrowsUseTheControlThatHasTheKeyboard) {
  turn_maps_drawer();
  tab_to("Near-vertical below");
  const double before = method().tau_deg;
  key({.key = k_right});
  EXPECT_GT(method().tau_deg, before);
  key({.key = k_left});
  EXPECT_EQ(method().tau_deg, before);
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1)) << "arrows belong to the control";
  tab_to("Map resolution");
  const int resolution = method().resolution;
  key({.key = k_right});
  EXPECT_GT(method().resolution, resolution);
  tab_to("Hatching");
  const bool hatching = state().settings.look.hatching;
  key({.key = k_space});
  EXPECT_NE(state().settings.look.hatching, hatching);
  key({.key = k_enter});
  EXPECT_EQ(state().settings.look.hatching, hatching);
  // Escape leaves it, and the arrows turn the direction again.
  key({.key = k_escape});
  EXPECT_EQ(window.app().focused(), "");
  key({.key = k_right});
  EXPECT_NE(direction(), glm::dvec3(0, 0, 1));
}

TEST_F(Keys, LegendRowsViewCubeAndBallAreReachedToo) {
  tab_to("undercut");
  key({.key = k_enter});
  EXPECT_TRUE(any_popup()) << "its area is offered to be copied";
  key({.key = k_escape});
  tab_to("TOP");
  key({.key = k_enter});
  window.settle();
  EXPECT_GT(state().camera.toward_viewer().z, 1.0 - 1e-9);
  tab_to("ball");
  key({.key = k_right});
  EXPECT_NEAR(glm::degrees(std::acos(direction().z)), 1.0, 1e-6);
}

TEST_F(Keys, TheRingStandsOut) {
  tab_to("+X");
  window.settle();
  const ScreenBox box = window.control("+X");
  const auto pixels = window.pixels();
  const auto brightness = [&](const glm::vec2& at) {
    const glm::ivec2 pixel(at);
    return static_cast<int>(pixels[4 * static_cast<std::size_t>(pixel.y * window.size().x + pixel.x)]);
  };
  const float middle = box.centre().x;
  EXPECT_GT(brightness({middle, box.min.y - 2.0F}), brightness({middle, box.min.y - 4.0F}) + 120);
}

TEST_F(Keys, PanelsHideByControlAndTab) {
  turn_maps_drawer();
  key({.key = k_tab, .ctrl = true});
  EXPECT_FALSE(window.app().controls().contains("Kernel"));
  tab();
  EXPECT_FALSE(window.app().controls().contains("Kernel"));
  key({.key = k_tab, .ctrl = true});
  EXPECT_TRUE(window.app().controls().contains("Kernel"));
}

TEST_F(Keys, EscapeClosesTheInnermostFirst) {
  key({.key = 'M'});  // nothing is swept: it does not show
  click("settings");
  move_to(window.control("Size").centre());
  window.set_button(1, true);
  window.frame();
  window.set_button(1, false);
  window.frames(3);
  ASSERT_TRUE(any_popup());
  key({.key = k_escape});
  EXPECT_FALSE(any_popup());
  EXPECT_TRUE(state().dialogs.settings) << "one at a time";
  key({.key = k_escape});
  EXPECT_FALSE(state().dialogs.settings);
  EXPECT_TRUE(state().sweep_choices.large_ball);
  key({.key = k_escape});
  EXPECT_FALSE(state().sweep_choices.large_ball);
  turn_maps_drawer();
  for (const char* control : {"Accuracy", "part name", "bookmark"}) {
    click(control);
    EXPECT_TRUE(any_popup()) << control;
    key({.key = k_escape});
    EXPECT_FALSE(any_popup()) << control;
  }
  for (const int letter : {'H', 'O', 'E'}) {
    key({.key = letter, .ctrl = letter != 'H'});
    EXPECT_FALSE(state().dialogs == Dialogs{}) << static_cast<char>(letter);
    key({.key = k_escape});
    EXPECT_TRUE(state().dialogs == Dialogs{}) << static_cast<char>(letter);
  }
  click("+d");
  EXPECT_TRUE(state().dialogs.large_map);
  key({.key = k_escape});
  EXPECT_FALSE(state().dialogs.large_map);
}

TEST_F(Keys, AClickBesideAPopupDoesWhatItDoesThere) {
  turn_maps_drawer();
  click("part name");
  ASSERT_TRUE(any_popup());
  const bool hatching = state().settings.look.hatching;
  click("Hatching");
  EXPECT_FALSE(any_popup());
  EXPECT_NE(state().settings.look.hatching, hatching);

  click("Accuracy");
  ASSERT_TRUE(any_popup());
  const glm::dquat before = state().camera.orientation;
  drag({640, 500}, {700, 520});
  EXPECT_FALSE(any_popup());
  EXPECT_NE(state().camera.orientation, before) << "the drag turns the view";

  click("Accuracy");
  click("Accuracy");
  EXPECT_FALSE(any_popup()) << "its own button closes it, too";
}

TEST_F(Keys, RecentFilesOpenBelowTheirButtonAndGoByArrows) {
  click("part name");
  ASSERT_TRUE(any_popup());
  const ImGuiWindow* popup = nullptr;
  for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows) {
    if (std::string_view(each->Name).starts_with("Popup") && each->Active) popup = each;
  }
  const ScreenBox button = window.control("part name");
  EXPECT_EQ(popup->Pos.x, button.min.x);
  EXPECT_NEAR(popup->Pos.y, button.max.y, 8.0F);
  window.move_mouse({640, 600});
  window.settle();
  key({.key = k_down});
  key({.key = k_enter});
  EXPECT_TRUE(state().loading || !any_popup());
  EXPECT_FALSE(any_popup());
  window.wait_until_loaded();
}

class Browser : public Keys {
 protected:
  Browser() {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(part.file()).parent_path();
    fs::create_directory(folder / "aaa");
    for (int k = 0; k < 60; ++k)
      fs::copy_file(part.file(), folder / ("copy_" + std::to_string(100 + k) + ".obj"));
    key({.key = 'O', .ctrl = true});
    window.frames(3);
  }
  [[nodiscard]] bool open() const { return state().dialogs.browser; }
};

TEST_F(Browser, FiltersAtOnceAndOpensByEnter) {
  window.type("copy_123");
  window.frames(2);
  key({.key = k_enter});
  EXPECT_FALSE(open());
  window.wait_until_loaded();
  EXPECT_TRUE(state().path.ends_with("copy_123.obj")) << state().path;
}

TEST_F(Browser, OpensTheFileOfAPathThatIsTyped) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(part.file()).parent_path();
  fs::copy_file(part.file(), folder / "aaa" / "deep.obj");
  window.type("aaa/dee");
  window.frames(2);
  EXPECT_TRUE(window.app().controls().contains("file deep.obj")) << "what begins so in that folder";
  window.type("p.obj");
  window.frames(2);
  key({.key = k_enter});
  EXPECT_FALSE(open());
  window.wait_until_loaded();
  EXPECT_TRUE(state().path.ends_with("aaa/deep.obj")) << state().path;
}

TEST_F(Browser, OpensAFullPathByTheButtonAndSaysWhatIsNotThere) {
  const auto says = [&](const std::string& words) {
    return std::ranges::any_of(window.app().texts(), [&](const DrawnText& text) {
      return text.text.find(words) != std::string::npos;
    });
  };
  window.type("/no/such/folder/part.stl");
  window.frames(2);
  key({.key = k_enter});
  EXPECT_TRUE(open());
  EXPECT_TRUE(says("This folder cannot be read"));
  EXPECT_FALSE(window.app().controls().contains("Open"));
  for (int k = 0; k < 24; ++k) key({.key = k_backspace});
  window.type(part.file());
  window.frames(2);
  click("Open");
  EXPECT_FALSE(open());
  window.wait_until_loaded();
  EXPECT_EQ(state().path, part.file());
}

TEST_F(Browser, GoesThroughListAndFoldersByKeys) {
  const auto shown = [&](const char* name) { return window.app().controls().contains(name); };
  EXPECT_TRUE(shown("file copy_100.obj"));
  EXPECT_FALSE(shown("file copy_159.obj"));
  key({.key = k_end});
  EXPECT_TRUE(shown("file cup.obj")) << "the selected row is scrolled to";
  EXPECT_FALSE(shown("file copy_100.obj"));
  key({.key = k_home});
  key({.key = k_page_down});
  key({.key = k_home});
  // One recent part, then the folder.
  key({.key = k_down});
  key({.key = k_enter});
  EXPECT_TRUE(open());
  EXPECT_FALSE(shown("file copy_100.obj")) << "in the folder aaa";
  key({.key = k_backspace});
  EXPECT_TRUE(shown("file copy_100.obj")) << "back in the folder above";
  window.type("aa");
  window.frames(2);
  EXPECT_FALSE(shown("file copy_100.obj"));
  key({.key = k_backspace});
  key({.key = k_backspace});
  EXPECT_TRUE(shown("file copy_100.obj")) << "Backspace is the filter's while there is one";
  key({.key = k_escape});
  EXPECT_FALSE(open());
}

TEST_F(Keys, TheTableOfDirectionsIsSortedByItsHeadings) {
  key({.key = 'W'});
  window.wait_until_swept();
  ASSERT_TRUE(state().sweep.result) << state().sweep.error;
  const auto top = [&](const char* row) { return window.control(row).min.y; };
  ASSERT_GT(state().sweep.result->candidates.size(), 1U);
  ASSERT_LT(top("direction 1"), top("direction 2"));
  tab_to("sort by #");
  key({.key = k_enter});
  window.settle();
  EXPECT_TRUE(!window.app().controls().contains("direction 1") || top("direction 1") > top("direction 2"));
  key({.key = k_enter});
  window.settle();
  EXPECT_LT(top("direction 1"), top("direction 2"));
}

TEST_F(Keys, TheTableOfDirectionsGoesByKeys) {
  window.wait_until_measured();
  key({.key = 'W'});
  window.wait_until_swept();
  ASSERT_TRUE(state().sweep.result) << state().sweep.error;
  ASSERT_GT(state().sweep.result->candidates.size(), 2U) << state().sweep.error;
  tab_to("table");
  const auto& candidates = state().sweep.result->candidates;
  key({.key = k_end});
  key({.key = k_up});
  key({.key = k_enter});
  window.settle();
  EXPECT_LT(glm::length(direction() - candidates[candidates.size() - 2].candidate.direction), 1e-9);
}

}  // namespace
}  // namespace moldlight::gui::test
