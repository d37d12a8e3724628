// Everything that a user may have open in the window, one after the other; and which window lies on which.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include <imgui_internal.h>

#include "cli/small_parts.hpp"
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {

/// What a user has open, and how to get there and back.
struct Scenery {
  const char* name;
  std::function<void()> open, close;
};

class WindowSceneries : public WindowWithPart {
 protected:
  static constexpr glm::ivec2 k_size{1280, 800};

  WindowSceneries() { window.resize(k_size); }

  /// Each leaves the window as it found it, but for the sweep's result.
  std::vector<Scenery> sceneries() {
    const auto press = [this](int code, bool ctrl = false) {
      return [this, code, ctrl] { key({.key = code, .ctrl = ctrl}); };
    };
    const auto click_on = [this](const char* control) {
      return [this, control] {
        click(control);
        window.settle();
      };
    };
    return {
        {"part", [] {}, [] {}},
        {"shadow maps", click_on("fold maps"), [] {}},
        {"accuracy", click_on("Accuracy"),
         [this, click_on, press] {
           press(k_escape)();
           click_on("fold maps")();
         }},
        {"recent files", click_on("part name"), press(k_escape)},
        {"bookmarks", click_on("bookmark"), press(k_escape)},
        {"section across", press('S'), [] {}},
        {"section along", press('S'), press('S')},
        {"measuring", press('R'), press(k_escape)},
        {"regions by maps", click_on("Regions by=maps"), click_on("Regions by=exact")},
        {"help", press('H'), press(k_escape)},
        {"settings", click_on("settings"), press(k_escape)},
        {"export", press('E', true), press(k_escape)},
        {"picture", press(k_f12), press(k_escape)},
        {"files", press('O', true), press(k_escape)},
        {"step of the part", press('1'), [] {}},
        {"light theme", press('T'), press('T')},
        {"step of the undercuts", press('3'), [] {}},
        {"a side action", click_on("undercut 1"), [] {}},
        {"its pin", click_on("pin 1"), press(k_escape)},
        {"options of side actions", click_on("action options"),
         [this, click_on, press] {
           click_on("action options")();
           press(k_escape)();
           press('F')();
           window.settle();
         }},
        {"step of the parting line", press('4'), [this] { window.wait_until_measured(); }},
        {"a loop", click_on("loop 1"), press(k_escape)},
        {"step of the mold", press('6'), [this] { window.wait_until_measured(); }},
        {"options of the mold", click_on("mold options"), click_on("mold options")},
        {"export of the mold", click_on("export mold"), press(k_escape)},
        {"opened halves", press('O'),
         [this, press] {
           press('O')();
           press('F')();
           window.settle();
         }},
        {"step of the draft", press('D'), [this] { window.wait_until_measured(); }},
        {"a wall without draft", click_on("wall 1"),
         [this, press] {
           press(k_escape)();
           press('F')();
           window.settle();
         }},
        {"step of the report", press('7'), press('2')},
        {"batch",
         [this] {
           EXPECT_EQ(parts_.plan().exit_code, 0);
           EXPECT_EQ(parts_.batch("run").exit_code, 0);
           window.app().open(parts_.path("night"));
           window.wait_until_loaded();
           window.settle();
         },
         press(k_escape)},
        {"sweep options", click_on("options"), click_on("options")},
        {"sweep table",
         [this] {
           key({.key = 'W'});
           window.wait_until_swept();
         },
         [] {}},
        {"large ball", press('M'), press('M')},
        {"comparison", press('C'), press(k_escape)},
        {"a dropped part",
         [this] {
           window.drop(parts_.path("parts/part-0000.off"));
           window.frame();
           window.settle();
         },
         press(k_escape)},
        {"another revision",
         [this] {
           window.app().compare_with(parts_.path("parts/part-0001.off"));
           window.wait_until_measured();
         },
         [] {}},
        {"options of revisions", click_on("revision options"),
         [this, click_on, press] {
           click_on("revision options")();
           press('D', true)();
           window.settle();
         }},
    };
  }

  /// Calls `check` with the name of each. The window is as large as at first when one closes.
  template <typename Check>
  void in_all_sceneries(const Check& check) {
    window.wait_until_measured();
    for (const Scenery& scenery : sceneries()) {
      scenery.open();
      check(scenery.name);
      lay_out(k_size, 1.0F);
      scenery.close();
    }
  }

  /// Lays the panels out for a size in pixels and a scale, without a picture.
  void lay_out(const glm::ivec2& size, float scale) {
    window.resize(size);
    window.set_content_scale(scale);
    window.move_mouse(glm::vec2(size) * glm::vec2(0.5F, 0.72F));
    for (int k = 0; k < 6; ++k) window.lay_out();
  }

 private:
  moldlight::test::SmallParts parts_{3};
};

/// The part of the text that its clip rectangle shows.
[[nodiscard]] inline ScreenBox shown(const DrawnText& text) {
  return {glm::max(text.box.min, text.clip.min), glm::min(text.box.max, text.clip.max)};
}
/// Negative where they are apart.
[[nodiscard]] inline glm::vec2 overlap(const ScreenBox& a, const ScreenBox& b) {
  return glm::min(a.max, b.max) - glm::max(a.min, b.min);
}

/// The windows with a background that lie on the text.
[[nodiscard]] inline std::vector<const ImGuiWindow*> windows_on(const DrawnText& text) {
  std::vector<const ImGuiWindow*> windows;
  const ImGuiWindow* const owner = ImGui::FindWindowByName(text.window.c_str());
  bool above = owner == nullptr;  // in the scene
  for (const ImGuiWindow* const each : ImGui::GetCurrentContext()->Windows) {
    const bool own = owner != nullptr && each->RootWindow == owner->RootWindow;
    if (own) above = true;
    const bool on_top = (each->Flags & ImGuiWindowFlags_Tooltip) != 0;
    if ((!above && !on_top) || own || each->RootWindow != each || !each->Active || each->Hidden ||
        (each->Flags & ImGuiWindowFlags_NoBackground) != 0)
      continue;
    const glm::vec2 corner = each->Pos, size = each->Size;
    const glm::vec2 common = overlap(shown(text), {corner, corner + size});
    if (common.x > 1.0F && common.y > 1.0F) windows.push_back(each);
  }
  return windows;
}

}  // namespace moldlight::gui::test
