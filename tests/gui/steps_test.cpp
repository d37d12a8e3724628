// The steps along the top: entered by mouse and keys, each with its own panel, marks that tell how it stands,
// and the part left in sight.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gui/panels/step_parts.hpp"
#include "gui/sceneries.hpp"

namespace moldlight::gui::test {
namespace {

class Steps : public WindowSceneries {
 protected:
  Steps() { window.wait_until_measured(); }
  [[nodiscard]] bool has(const std::string& control) const {
    return window.app().controls().contains(control);
  }
};

TEST_F(Steps, AreEnteredByMouseAndKeysInAnyOrder) {
  for (const int step : {7, 1, 4, 2, 6, 3, 5}) {
    click(fmt::format("step {}", step));
    EXPECT_EQ(static_cast<int>(state().step) + 1, step);
    key({.key = '2'});
    EXPECT_EQ(state().step, Step::direction);
    key({.key = '0' + step});
    EXPECT_EQ(static_cast<int>(state().step) + 1, step);
  }
}

TEST_F(Steps, HaveTheirOwnControlsAlone) {
  const std::array<std::vector<const char*>, 7> own = {{{"Unit=mm"},
                                                        {"ball", "Find directions"},
                                                        {"action options"},
                                                        {"loop 1", "Move faces"},
                                                        {"draft chart", "Required draft"},
                                                        {"Open the mold", "export mold"},
                                                        {"Page (HTML)"}}};
  for (std::size_t here = 0; here < own.size(); ++here) {
    go_to(static_cast<Step>(here));
    window.wait_until_measured();
    window.frames(3);
    for (std::size_t k = 0; k < own.size(); ++k)
      for (const char* control : own[k])
        EXPECT_EQ(has(control), k == here) << control << " in " << k_step_titles[here];
  }
}

TEST_F(Steps, LeaveSevenTenthsOfTheWindowToThePart) {
  const glm::ivec2 size(1440, 900);
  lay_out(size, 1.0F);
  for (std::size_t step = 0; step < k_step_titles.size(); ++step) {
    go_to(static_cast<Step>(step));
    window.wait_until_measured();
    lay_out(size, 1.0F);
    // On a grid of 8 pixels.
    std::size_t covered = 0, all = 0;
    for (int y = 4; y < size.y; y += 8) {
      for (int x = 4; x < size.x; x += 8) {
        ++all;
        const bool under =
            std::ranges::any_of(ImGui::GetCurrentContext()->Windows, [&](const ImGuiWindow* each) {
              return each->Active && !each->Hidden && (each->Flags & ImGuiWindowFlags_NoBackground) == 0 &&
                     each->Rect().Contains(ImVec2(static_cast<float>(x), static_cast<float>(y))) &&
                     std::string_view(each->Name).find("Debug") == std::string_view::npos;
            });
        covered += under ? 1 : 0;
      }
    }
    EXPECT_LE(10 * covered, 3 * all) << k_step_titles[step];
  }
}

TEST_F(Steps, NeverHaveATickWhileRedIsOnTheScreen) {
  ASSERT_TRUE(verdict_card(state()).red) << "the cup has an undercut";
  EXPECT_FALSE(verdict_card(state()).good());
  const StepMark mark = step_mark(state(), Step::undercuts);
  EXPECT_NE(mark.sign, StepMark::Sign::good);
  EXPECT_EQ(mark.text, std::to_string(state().verdict->undercuts));
  EXPECT_EQ(step_mark(state(), Step::part).sign, StepMark::Sign::warning) << "its file has no unit";
}

TEST_F(Steps, TheDrawerOfTheMapsIsOneClickAway) {
  EXPECT_FALSE(has("Kernel"));
  click("Shadow maps");
  window.settle();
  for (const char* control :
       {"Azimuth", "Elevation", "Near-vertical below", "Kernel", "Edge thickness", "Map resolution",
        "Kernel shape=symmetric", "tolerance", "Couple δ to the kernel"})
    EXPECT_TRUE(has(control)) << control;
  slide("Elevation", 0.6F);
  EXPECT_NEAR(direction().z / glm::length(direction()), std::sin(glm::radians(18.0)), 0.02);
  click("close drawer");
  EXPECT_FALSE(has("Kernel"));
}

TEST_F(Steps, ArePresentedWithoutPanels) {
  key({.key = '3'});
  key({.key = 294});  // F5
  window.settle();
  EXPECT_FALSE(has("panel Step"));
  EXPECT_FALSE(has("step 3"));
  const auto& texts = window.app().texts();
  EXPECT_TRUE(std::ranges::any_of(texts, [](const DrawnText& each) { return each.window == "Caption"; }));
  key({.key = k_escape});
  EXPECT_TRUE(has("panel Step"));
}

}  // namespace
}  // namespace moldlight::gui::test
