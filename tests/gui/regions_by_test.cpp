// Where the regions come from: exactly, or by the shadow maps, whose controls are seen to act.
#include "classify/classifier.hpp"
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

class RegionsAre : public WindowWithPart {
 protected:
  RegionsAre() { window.wait_until_measured(); }

  [[nodiscard]] RegionsBy by() const { return state().settings.look.regions_by; }
  /// Pixels of the scene that differ by more than rounding, in all.
  [[nodiscard]] std::size_t differing(const std::vector<std::uint8_t>& before, std::size_t from = 300,
                                      std::size_t to = 980, std::size_t low = 500) const {
    const std::vector<std::uint8_t> now = window.pixels();
    std::size_t count = 0;
    for (std::size_t k = 0; k < now.size(); k += 4) {
      const std::size_t x = k / 4 % static_cast<std::size_t>(window.size().x);
      const std::size_t y = k / 4 / static_cast<std::size_t>(window.size().x);
      if (x < from || x > to || y > low) continue;  // panels, and the drawer
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
  turn_maps_drawer();
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
  slide("Near-vertical below", 0.3F);
  EXPECT_EQ(by(), RegionsBy::exact) << "it is not the maps' alone";
}

TEST_F(RegionsAre, SwitchedInTheLegend) {
  click("Regions by=maps");
  EXPECT_EQ(by(), RegionsBy::maps);
  click("Regions by=exact");
  EXPECT_EQ(by(), RegionsBy::exact);
}

TEST_F(RegionsAre, ThoseOfTheMapsAtOnce) {
  turn_maps_drawer();
  move_to({640, 60});
  window.settle();
  const std::vector<std::uint8_t> exact = window.pixels();
  // Maps so coarse that they show; the picture changes while the slider is still held.
  const ScreenBox place = window.control("Map resolution");
  drag(place.centre(), {place.min.x, place.centre().y}, false);
  EXPECT_GT(differing(exact), 500U);
  window.set_button(0, false);
  window.settle();
  EXPECT_GT(differing(exact), 500U);
  window.wait_until_measured();
  EXPECT_GT(differing(exact), 500U) << "the split mesh is not what is asked for";
  click("Regions by=exact");
  move_to({640, 60});
  window.wait_until_measured();
  EXPECT_LT(differing(exact), 50U);
}

TEST_F(RegionsAre, MarkedWhereTheyDiffer) {
  turn_maps_drawer();
  slide("Map resolution", 0.0F);
  window.wait_until_measured();
  const std::vector<std::uint8_t> plain = window.pixels();
  click("Mark the difference");
  window.settle();
  EXPECT_GT(differing(plain), 500U);
  click("Regions by=exact");
  window.wait_until_measured();
  const std::vector<std::uint8_t> marked = window.pixels();
  click("Mark the difference");
  window.settle();
  EXPECT_GT(differing(marked), 500U);
}

TEST_F(RegionsAre, OfTheMapsAndExactOnEitherSideOfALineThatIsDragged) {
  turn_maps_drawer();
  slide("Map resolution", 0.0F);
  move_to({640, 60});
  window.wait_until_measured();
  const std::vector<std::uint8_t> maps = window.pixels();
  click("Regions by=exact");
  move_to({640, 60});
  window.wait_until_measured();
  const std::vector<std::uint8_t> exact = window.pixels();
  ASSERT_GT(differing(maps), 500U) << "so coarse that it shows";
  click("Split view");
  EXPECT_TRUE(state().settings.look.mark_difference) << "the difference is marked";
  window.wait_until_measured();
  EXPECT_GT(differing(exact), 500U);
  EXPECT_TRUE(window.app().controls().contains("map comparison"));
  click("Mark the difference");  // to compare the pictures
  std::optional<double> before = state().divider;
  ASSERT_TRUE(before);
  for (const float by : {0.0F, -90.0F, 150.0F}) {
    const glm::vec2 handle = window.control("dividing line").centre();
    drag(handle, handle + glm::vec2(by, 0.0F));
    move_to({640, 60});
    window.wait_until_measured();
    EXPECT_EQ(*state().divider > *before, by > 0.0F);
    EXPECT_NEAR(window.control("dividing line").centre().x, handle.x + by, 2.0F);
    before = state().divider;
    const auto line = static_cast<std::size_t>(handle.x + by);
    constexpr std::size_t k_beside = 14;  // of the line, with its handle; and above the names at its foot
    const auto low = static_cast<std::size_t>(window.control("panel Shadow maps").min.y - 44.0F);
    EXPECT_LT(differing(maps, 300, line - k_beside, low), 50U) << "on the left";
    EXPECT_LT(differing(exact, line + k_beside, 980, low), 50U) << "on the right";
  }
  EXPECT_GT(differing(exact), 100U);
  key({.key = ','});
  EXPECT_NEAR(*state().divider, *before - 0.02, 1e-9);
  key({.key = k_escape});
  EXPECT_FALSE(state().divider);
}

class MapsAreCompared : public RegionsAre {
 protected:
  [[nodiscard]] std::string text() const {
    return state().figures.maps ? comparison_text(*state().figures.maps) : std::string();
  }
  /// What is to be said of the present settings, from the part's file on.
  [[nodiscard]] std::string expected(std::size_t samples) {
    const auto model = load_part(part.file(), ReadOptions{}, Progress{});
    const Classification exact = classify_exact(*model, state().settings, Progress{}, true);
    const PieceSamples set = sample_pieces(*exact.split, model->frame, samples);
    Classifier classifier(window.context(), model);
    classifier.draw_maps(state().settings);
    SamplePass pass(window.context().functions());
    return comparison_text(compare_maps(set, pass.run(set.samples, classifier.maps())));
  }
  [[nodiscard]] bool is_shown() { return window.app().controls().contains("map comparison"); }
  /// Holds a slider at a share of its width, without letting go.
  void hold(const std::string& control, float share) {
    const ScreenBox place = window.control(control);
    drag(place.centre(), {glm::mix(place.min.x, place.max.x, share), place.centre().y}, false);
  }
};

TEST_F(MapsAreCompared, ByTheSamplesOfTheSplitMeshWhileTheyTellTheRegions) {
  EXPECT_EQ(text(), "");
  EXPECT_FALSE(is_shown());
  click("Regions by=maps");
  window.settle();
  ASSERT_TRUE(state().figures.samples);
  EXPECT_NEAR(static_cast<double>(state().figures.maps->samples), 20'000.0, 10.0);
  EXPECT_EQ(text(), expected(20'000));
  EXPECT_TRUE(is_shown());
  click("Regions by=exact");
  window.settle();
  EXPECT_EQ(text(), "");
  EXPECT_FALSE(is_shown());
}

TEST_F(MapsAreCompared, WhileASliderOfTheMapsIsHeld) {
  turn_maps_drawer();
  slide("Map resolution", 0.05F);
  window.wait_until_measured();
  std::string before = text();
  EXPECT_EQ(before, expected(20'000));
  for (const auto& [control, share] :
       std::vector<std::pair<std::string, float>>{{"Edge thickness", 1.0F}, {"Kernel", 0.9F}}) {
    hold(control, share);
    window.wait_until_measured();
    EXPECT_NE(text(), before) << control;
    EXPECT_EQ(text(), expected(20'000)) << control;
    before = text();
    window.set_button(0, false);
    window.wait_until_measured();
    EXPECT_EQ(text(), before) << control;
  }
}

TEST_F(MapsAreCompared, OnceTheDirectionRests) {
  click("Regions by=maps");
  window.settle();
  const std::string before = text();
  const glm::vec2 tip = window.control("core arrow").centre();
  move_to(tip);
  window.set_button(0, true);
  window.frames(2);
  for (int step = 1; step <= 5; ++step) {
    window.move_mouse(tip + glm::vec2(12 * step, 5 * step));
    window.frame();
  }
  EXPECT_EQ(text(), "") << "the maps of a direction that moves are coarse ones";
  window.set_button(0, false);
  window.wait_until_measured();
  EXPECT_EQ(text(), expected(20'000));
  EXPECT_NE(text(), before);
}

}  // namespace
}  // namespace moldlight::gui::test
