// What the regions are told by: exactly, or by the shadow maps, whose controls are seen to act.
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

class RegionsAre : public WindowWithPart {
 protected:
  RegionsAre() { window.wait_until_measured(); }

  [[nodiscard]] RegionsBy by() const { return state().settings.look.regions_by; }
  /// Pixels of the scene that differ by more than rounding, in all.
  [[nodiscard]] std::size_t differing(const std::vector<std::uint8_t>& before) const {
    const std::vector<std::uint8_t> now = window.pixels();
    std::size_t count = 0;
    for (std::size_t k = 0; k < now.size(); k += 4) {
      const std::size_t x = k / 4 % static_cast<std::size_t>(window.size().x);
      if (x < 300 || x > 980) continue;  // panels
      int most = 0;
      for (std::size_t c = 0; c < 3; ++c)
        most = std::max(most, std::abs(int(now[k + c]) - int(before[k + c])));
      if (most > 24) ++count;
    }
    return count;
  }
};

TEST_F(RegionsAre, ExactUntilAControlOfTheMapsIsTouched) {
  EXPECT_EQ(by(), RegionsBy::exact);
  const std::vector<std::pair<std::string, float>> sliders = {
      {"Kernel", 0.9F}, {"Edge thickness", 0.9F}, {"Map resolution", 0.05F}};
  for (const auto& [control, share] : sliders) {
    slide(control, share);
    EXPECT_EQ(by(), RegionsBy::maps) << control;
    undo();
    EXPECT_EQ(by(), RegionsBy::exact) << control << ": one step of undo";
  }
  click("Kernel shape=symmetric");
  EXPECT_EQ(by(), RegionsBy::maps);
  undo();
  slide("Draft tolerance", 0.3F);
  EXPECT_EQ(by(), RegionsBy::exact) << "it is not the maps' alone";
}

TEST_F(RegionsAre, SwitchedInThePanelAndInTheLegend) {
  click("Regions by=maps");
  EXPECT_EQ(by(), RegionsBy::maps);
  click("by=exact");
  EXPECT_EQ(by(), RegionsBy::exact);
  click("by=maps");
  EXPECT_EQ(by(), RegionsBy::maps);
}

TEST_F(RegionsAre, ThoseOfTheMapsAtOnce) {
  const std::vector<std::uint8_t> exact = window.pixels();
  // Maps so coarse that they show; the picture changes while the slider is still held.
  const ControlPlace place = window.control("Map resolution");
  drag(place.centre(), {place.min.x, place.centre().y}, false);
  EXPECT_GT(differing(exact), 500U);
  window.set_button(0, false);
  window.settle();
  EXPECT_GT(differing(exact), 500U);
  window.wait_until_measured();
  EXPECT_GT(differing(exact), 500U) << "the split mesh is not what is asked for";
  click("by=exact");
  move_to({640, 60});
  window.wait_until_measured();
  EXPECT_LT(differing(exact), 50U);
}

TEST_F(RegionsAre, MarkedWhereTheyDiffer) {
  slide("Map resolution", 0.0F);
  window.wait_until_measured();
  const std::vector<std::uint8_t> plain = window.pixels();
  click("Mark the difference");
  window.settle();
  EXPECT_GT(differing(plain), 500U);
  click("by=exact");
  window.wait_until_measured();
  const std::vector<std::uint8_t> marked = window.pixels();
  click("Mark the difference");
  window.settle();
  EXPECT_GT(differing(marked), 500U);
}

}  // namespace
}  // namespace moldlight::gui::test
