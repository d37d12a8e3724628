// The same hands, at sixty frames a second and at five: the window is in the same state afterwards.
#include <cstdlib>
#include <iostream>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "gui/window_with_part.hpp"
#include "support/random.hpp"

namespace moldlight::gui::test {
namespace {

constexpr double k_quick_s = 1.0 / 60.0, k_slow_s = 0.2;
constexpr double k_past_double_click_s = 0.35;

/// What a hand does, with the time between the moments of it.
class Hand {
 public:
  Hand(OffscreenWindow& window, double frame_s) : window_(window), frame_s_(frame_s) {}

  void wait(double seconds) {
    for (const double end_s = time_s_ + seconds; time_s_ < end_s;) {
      const double step_s = std::min(end_s - time_s_, frame_s_ - since_frame_s_);
      time_s_ += step_s;
      since_frame_s_ += step_s;
      window_.pass_time(step_s);
      if (since_frame_s_ < frame_s_ - 1e-9) continue;
      since_frame_s_ = 0.0;
      window_.frame_at_once();
    }
  }
  void press(int button, bool down) {
    window_.set_button(button, down);
    wait(0.03);
  }
  void go(const glm::vec2& to) {
    constexpr int k_steps = 5;
    const glm::vec2 from = at_;
    for (int step = 1; step <= k_steps; ++step) {
      at_ = from + (to - from) * (static_cast<float>(step) / k_steps);
      window_.move_mouse(at_);
      wait(0.02);
    }
  }
  void key(const KeyPress& press) {
    window_.press_key(press);
    window_.hold_modifiers(false, false, false);
    wait(0.05);
  }

 private:
  OffscreenWindow& window_;
  double frame_s_, time_s_ = 0.0, since_frame_s_ = 0.0;
  glm::vec2 at_{2.0F, 2.0F};
};

class SlowFrames : public WindowWithPart {
 protected:
  /// Back to where every sequence begins.
  void begin() {
    window.app().set_notes(notes_);
    key({.key = GLFW_KEY_ESCAPE});
    key({.key = '1', .shift = true});
    key({.key = 'F'});
    window.move_mouse({2, 2});
    window.frames(4);  // the pictures need not be refined
  }
  /// Gestures drawn from the seed.
  void act(std::uint32_t seed, double frame_s) {
    moldlight::test::Random random(seed);
    Hand hand(window, frame_s);
    // Beside the panels, whose folding would last.
    const auto place = [&] { return glm::vec2(random.between(340.0, 940.0), random.between(120.0, 620.0)); };
    const std::size_t gestures = 2 + random.below(4);
    for (std::size_t k = 0; k < gestures; ++k) {
      switch (random.below(7)) {
        case 0: {  // turn the part
          hand.go(place());
          const int button = random.chance(0.5) ? 0 : 1;
          hand.press(button, true);
          hand.go(place());
          hand.press(button, false);
          break;
        }
        case 1: {                  // a slider
          hand.key({.key = '1'});  // to its step, and back
          hand.wait(k_past_double_click_s);
          const ScreenBox box = window.control("Near-vertical below");
          hand.go(box.centre());
          hand.press(0, true);
          hand.go(
              {glm::mix(box.min.x, box.max.x, static_cast<float>(random.between(0.1, 0.9))), box.centre().y});
          hand.press(0, false);
          hand.wait(k_past_double_click_s);  // two in a row are no double click, which asks for a number
          hand.key({.key = '2'});
          hand.wait(k_past_double_click_s);
          break;
        }
        case 2:
          hand.key({.key = 'Z', .ctrl = true});
          break;
        case 3:
          hand.key({.key = 'X'});
          break;
        case 4: {
          const char* const name = random.chance(0.5) ? "+X" : "+Y";
          hand.go(window.control(name).centre());
          hand.press(0, true);
          hand.press(0, false);
          break;
        }
        case 5:
          hand.go(window.control("Section=x").centre());
          hand.press(0, true);
          hand.press(0, false);
          hand.go(place());
          break;
        default:  // two clicks beside the part
          hand.go({300.0F, 90.0F});
          for (int click = 0; click < 2; ++click) {
            hand.press(0, true);
            hand.press(0, false);
          }
          break;
      }
    }
    window.settle();
  }

  PartNotes notes_ = {.settings = state().settings, .bookmarks = {}};
};

TEST_F(SlowFrames, LoseNothing) {
  // As many as are asked for, as a number or as "FIRST-END"; a few are tried every time.
  const char* const wanted = std::getenv("MOLDLIGHT_SEQUENCES");
  const std::string range = wanted != nullptr ? wanted : "5";
  const std::size_t dash = range.find('-');
  const int first = dash == std::string::npos ? 0 : std::stoi(range);
  const int end = std::stoi(dash == std::string::npos ? range : range.substr(dash + 1));
  int changed = 0;
  for (int k = first; k < end; ++k) {
    if (k % 50 == 49) std::cout << k + 1 << " sequences" << std::endl;
    SCOPED_TRACE(k);
    begin();
    const Camera start = state().camera;
    act(static_cast<std::uint32_t>(k), k_quick_s);
    const EditedSettings settings = state().settings;
    const Camera camera = state().camera;
    const std::optional<ChosenFace> face = state().face;
    begin();
    ASSERT_EQ(state().camera, start) << k;
    act(static_cast<std::uint32_t>(k), k_slow_s);
    EXPECT_EQ(part_notes_json({.settings = state().settings, .bookmarks = {}}, "part"),
              part_notes_json({.settings = settings, .bookmarks = {}}, "part"))
        << k;
    EXPECT_GT(std::abs(glm::dot(state().camera.orientation, camera.orientation)), 1.0 - 1e-9) << k;
    EXPECT_NEAR(state().camera.height, camera.height, 1e-9) << k;
    EXPECT_LT(glm::distance(state().camera.target, camera.target), 1e-6) << k;
    EXPECT_EQ(state().face.has_value(), face.has_value()) << k;
    changed += settings == notes_.settings && camera == start ? 0 : 1;
    if (HasFailure()) return;
  }
  EXPECT_GT(2 * changed, end - first) << "they do something";
}

}  // namespace
}  // namespace moldlight::gui::test
