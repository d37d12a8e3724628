// What a frame takes of the input that waits, and what ImGui then sees.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include "gui/input.hpp"

namespace moldlight::gui {
namespace {

class InputQueues : public ::testing::Test {
 protected:
  InputQueues() : context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(100, 100);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  }
  ~InputQueues() override { ImGui::DestroyContext(context_); }

  /// A frame; returns what it took.
  InputQueue::Played frame(double now_s) {
    auto played = queue_.play(ImGui::GetIO(), now_s);
    ImGui::NewFrame();
    double_clicked_ = double_clicked_ || ImGui::IsMouseDoubleClicked(0);
    clicks_ += ImGui::IsMouseClicked(0) ? 1 : 0;
    clicked_at_ = ImGui::IsMouseClicked(0) ? ImGui::GetIO().MousePos.x : clicked_at_;
    ImGui::EndFrame();
    return played;
  }
  void click(double time_s, float x) {
    queue_.move_mouse(time_s, {x, 10});
    queue_.set_button(time_s, 0, true);
    queue_.set_button(time_s + 0.01, 0, false);
  }
  int drain(double from_s, double frame_s) {
    int frames = 0;
    for (; !queue_.empty(); ++frames) frame(from_s + frame_s * frames);
    return frames;
  }

  ImGuiContext* context_;
  InputQueue queue_;
  bool double_clicked_ = false;
  int clicks_ = 0;
  double time_s_ = 0.0;
  float clicked_at_ = -1.0F;
};

TEST_F(InputQueues, AQuickClickIsSeenWhereItWasMadeHoweverLongTheFrame) {
  click(0.1, 20);
  queue_.move_mouse(0.2, {90, 10});
  drain(1.0, 0.2);
  EXPECT_EQ(clicks_, 1);
  EXPECT_EQ(clicked_at_, 20.0F);
  EXPECT_EQ(ImGui::GetIO().MousePos.x, 90.0F);
  EXPECT_FALSE(ImGui::GetIO().MouseDown[0]);
}

TEST_F(InputQueues, TheTimeBetweenPressesIsThatOfTheHandNotOfTheFrames) {
  for (const double frame_s : {1.0 / 60.0, 0.2}) {
    for (const double between_s : {0.29, 0.31}) {
      double_clicked_ = false;
      const double start_s = time_s_ += 2.0;
      for (const double press_s : {start_s + 0.13, start_s + 0.13 + between_s}) {
        for (; time_s_ < press_s; time_s_ += frame_s) frame(time_s_);
        for (const bool down : {true, false}) {
          queue_.set_button(press_s, 0, down);
          frame(time_s_ += frame_s);
        }
      }
      EXPECT_EQ(double_clicked_, between_s < 0.3) << frame_s << " " << between_s;
    }
  }
}

TEST_F(InputQueues, TwoClicksAreADoubleClickByTheTimeBetweenThem) {
  click(0.1, 20);
  click(0.25, 20);
  drain(1.0, 0.4);
  EXPECT_TRUE(double_clicked_);

  double_clicked_ = false;
  click(5.0, 20);
  click(6.0, 20);
  drain(6.0, 0.001);
  EXPECT_FALSE(double_clicked_) << "a second apart";
  EXPECT_EQ(clicks_, 4);
}

TEST_F(InputQueues, MovesShareAFrame) {
  for (int k = 0; k < 50; ++k) queue_.move_mouse(0.01 * k, {static_cast<float>(k), 3});
  EXPECT_EQ(drain(1.0, 0.2), 1);
  EXPECT_EQ(ImGui::GetIO().MousePos.x, 49.0F);
}

TEST_F(InputQueues, AKeyIsHeldForAFrameWithItsModifiers) {
  queue_.hold_modifiers(0.1, true, false, false);
  queue_.press_key(0.1, {.key = 'A', .ctrl = true});
  queue_.release_key(0.11, 'A');
  queue_.hold_modifiers(0.12, false, false, false);
  const auto first = frame(1.0);
  ASSERT_EQ(first.keys.size(), 1U);
  EXPECT_EQ(first.keys[0].key, 'A');
  EXPECT_TRUE(first.keys[0].ctrl);
  EXPECT_TRUE(ImGui::GetIO().KeyCtrl);
  EXPECT_TRUE(ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_A)));
  const auto second = frame(1.2);
  EXPECT_TRUE(second.keys.empty());
  EXPECT_FALSE(ImGui::GetIO().KeyCtrl);
  EXPECT_TRUE(queue_.empty());
}

TEST_F(InputQueues, WhatIsTypedIsInOneFrameOnceAFieldListensAndAKeyAFrameBefore) {
  const auto type = [&] {
    for (const char letter : {'B', 'O', 'B'}) {
      queue_.press_key(0.1, {.key = letter});
      queue_.type(0.1, std::string(1, letter));
      queue_.release_key(0.1, letter);
    }
  };
  const auto play = [&](double now_s, bool field) {
    ImGui::GetIO().WantTextInput = field;
    const std::size_t keys = queue_.play(ImGui::GetIO(), now_s).keys.size();
    ImGui::NewFrame();
    const int letters = ImGui::GetIO().InputQueueCharacters.Size;
    ImGui::EndFrame();
    return std::pair(keys, letters);
  };
  type();
  EXPECT_EQ(play(1.0, false), std::pair(std::size_t{1}, 1)) << "it may open a field";
  EXPECT_EQ(play(1.2, true), std::pair(std::size_t{2}, 2));
  EXPECT_TRUE(queue_.empty());
}

}  // namespace
}  // namespace moldlight::gui
