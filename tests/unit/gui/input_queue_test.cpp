// What a frame takes of the input that waits, and what ImGui then sees.
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
  ImGui::GetIO().WantTextInput = false;
  type();
  EXPECT_EQ(queue_.play(ImGui::GetIO(), 1.0).keys.size(), 1U) << "it may open a field";
  EXPECT_EQ(ImGui::GetIO().InputQueueCharacters.Size, 1);
  ImGui::GetIO().WantTextInput = true;
  EXPECT_EQ(queue_.play(ImGui::GetIO(), 1.2).keys.size(), 2U);
  EXPECT_EQ(ImGui::GetIO().InputQueueCharacters.Size, 3);
  EXPECT_TRUE(queue_.empty());
}

}  // namespace
}  // namespace moldlight::gui
