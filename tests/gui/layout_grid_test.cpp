// In every state of the window, at many sizes and scales: no text is cut off, lies on another one, or shows
// half from beneath a panel.
#include <map>
#include <string>

#include <fmt/format.h>

#include "gui/quick_options.hpp"
#include "gui/sceneries.hpp"

namespace moldlight::gui::test {
namespace {

/// What is wrong with the texts of frames.
class TextOrder {
 public:
  void check(const std::vector<DrawnText>& texts, const std::string& where) {
    where_ = where;
    EXPECT_FALSE(texts.empty()) << where;
    for (std::size_t a = 0; a < texts.size(); ++a) {
      check_alone(texts[a]);
      for (std::size_t b = 0; b < a; ++b) {
        if (texts[a].window == texts[b].window) check_pair(texts[a], texts[b]);
      }
    }
  }
  void note() const {
    for (const auto& [complaint, where] : complaints_) ADD_FAILURE() << complaint << " (" << where << ")";
  }

 private:
  void complain(const DrawnText& text, const std::string& what) {
    complaints_.try_emplace(fmt::format("{}: '{}' {}", text.window, text.text, what), where_);
  }

  void check_alone(const DrawnText& text) {
    const ImGuiWindow* const owner = ImGui::FindWindowByName(text.window.c_str());
    const bool scrolls = owner != nullptr && owner->ScrollMax.y > 0.0F;
    const glm::vec2 out =
        glm::max(text.clip.min - text.box.min, text.box.max - text.clip.max) - glm::vec2(1.0F);
    if (out.x > 0.0F) complain(text, "is cut off at a side");
    if (out.y > 0.0F && !scrolls) complain(text, "is cut off above or below");
    for (const ImGuiWindow* const each : windows_on(text)) {
      if (!is_passing(*each) && owner != nullptr) complain(text, std::string("is beneath ") + each->Name);
    }
  }

  void check_pair(const DrawnText& a, const DrawnText& b) {
    if (a.window == "View cube") return;  // its names lie on its faces, as these are turned
    // A line's box has room above and below its letters.
    const glm::vec2 common = overlap(shown(a), shown(b));
    const float height = std::min(a.box.max.y - a.box.min.y, b.box.max.y - b.box.min.y);
    if (common.x > 1.0F && common.y > 0.3F * height) complain(a, "lies on '" + b.text + "'");
  }

  /// Whether it lies over all others for as long as its user wants it: dialogs, menus, tooltips.
  [[nodiscard]] static bool is_passing(const ImGuiWindow& each) {
    constexpr std::array<std::string_view, 11> k_names = {
        "Dropped", "Help",      "Window settings", "Open",  "Export", "Batch",
        "Picture", "Large map", "Scrim",           "Toast", "Popup"};
    const auto named = [&](std::string_view name) { return std::string_view(each.Name).starts_with(name); };
    return (each.Flags & ImGuiWindowFlags_Tooltip) != 0 || std::ranges::any_of(k_names, named);
  }

  std::map<std::string, std::string> complaints_;  // each once, with where it was seen first
  std::string where_;
};

constexpr std::array<glm::ivec2, 7> k_sizes = {
    {{1024, 640}, {1100, 700}, {1280, 800}, {1440, 900}, {1920, 1080}, {2560, 1440}, {3840, 2160}}};
constexpr std::array<float, 3> k_scales = {1.0F, 1.5F, 2.0F};

class LayoutGrid : public WindowSceneries {};

TEST_F(LayoutGrid, NoTextIsCutOffOrCovered) {
  TextOrder order;
  in_all_sceneries([&](const char* scenery) {
    for (const float scale : k_scales) {  // the outer one: the letters are made anew for it
      for (const glm::ivec2& size : k_sizes) {
        lay_out(size, scale);
        order.check(window.app().texts(), fmt::format("{}, {}x{} at {}", scenery, size.x, size.y, scale));
      }
    }
  });
  order.note();
}

TEST_F(LayoutGrid, StepsAreWholeInBothThemes) {
  TextOrder order;
  window.wait_until_measured();
  for (int theme = 0; theme < 2; ++theme) {
    for (int step = 0; step < 7; ++step) {
      enter(static_cast<Step>(step));
      window.wait_until_measured();
      for (const auto& [size, scale] : {std::pair(glm::ivec2(1100, 700), 1.0F),
                                        {glm::ivec2(1440, 900), 1.0F},
                                        {glm::ivec2(2560, 1440), 2.0F}}) {
        lay_out(size, scale);
        order.check(window.app().texts(),
                    fmt::format("step {}, {}x{} at {}, theme {}", step + 1, size.x, size.y, scale, theme));
      }
    }
    key({.key = 'T'});
  }
  order.note();
}

TEST(StartPage, NoTextIsCutOffOrCovered) {
  OffscreenOptions options = quick_options();
  options.shipped_parts = {"/a/first_part.stl", "/a/second_part.stl", "/a/third_part.stl", "/a/fourth.stl"};
  for (int k = 0; k < 12; ++k)
    options.user.recent.push_back(fmt::format("/a folder with a long name/{}/part with a long name.stl", k));
  OffscreenWindow window(options);
  TextOrder order;
  for (const float scale : k_scales) {
    for (const glm::ivec2& size : k_sizes) {
      window.resize(size);
      window.set_content_scale(scale);
      for (int k = 0; k < 6; ++k) window.lay_out();
      order.check(window.app().texts(), fmt::format("{}x{} at {}", size.x, size.y, scale));
    }
  }
  order.note();
}

}  // namespace
}  // namespace moldlight::gui::test
