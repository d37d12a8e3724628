// Every text stands out from what it is drawn on, in both themes: WCAG's contrast of 4.5 at least, by the
// picture itself.
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "gui/quick_options.hpp"
#include "gui/sceneries.hpp"

namespace moldlight::gui::test {
namespace {

constexpr double k_least_contrast = 4.5;

using Pixel = glm::dvec3;  // [0, 255]

double luminance(const Pixel& pixel) {
  const auto linear = [](double channel) {
    channel /= 255.0;
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(pixel.r) + 0.7152 * linear(pixel.g) + 0.0722 * linear(pixel.b);
}

double contrast(const Pixel& a, const Pixel& b) {
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

/// The letters' colour where they cover the ground wholly.
Pixel on_ground(ImU32 colour, const Pixel& ground) {
  const double alpha = ((colour >> IM_COL32_A_SHIFT) & 0xFF) / 255.0;
  const Pixel own((colour >> IM_COL32_R_SHIFT) & 0xFF, (colour >> IM_COL32_G_SHIFT) & 0xFF,
                  (colour >> IM_COL32_B_SHIFT) & 0xFF);
  return glm::mix(ground, own, alpha);
}

/// On the ground along the upper edge of the text's box, which letters hardly reach; nothing for a text that
/// is covered or scrolled away.
std::optional<double> contrast_of(const DrawnText& text, const OffscreenWindow& window,
                                  const std::vector<std::uint8_t>& pixels) {
  const ScreenBox box = shown(text);
  const glm::ivec2 min = glm::max(glm::ivec2(box.min), glm::ivec2(0)),
                   max = glm::min(glm::ivec2(box.max), window.size());
  const bool cut_off = box.min.y != text.box.min.y || box.max.y != text.box.max.y;
  const bool turned = text.window == "View cube";  // as its faces are: the box's edge is not that of the text
  if (turned || cut_off || min.x >= max.x || min.y >= max.y || !windows_on(text).empty()) return std::nullopt;
  std::vector<double> found;
  for (int x = min.x; x < max.x; ++x) {
    const std::uint8_t* const at = &pixels[4 * static_cast<std::size_t>(min.y * window.size().x + x)];
    const Pixel ground(at[0], at[1], at[2]);
    found.push_back(contrast(on_ground(text.colour, ground), ground));
  }
  std::ranges::sort(found);
  return found[found.size() / 8];  // of the worst parts
}

/// The texts with too little contrast, each once.
class FaintTexts {
 public:
  void check(const OffscreenWindow& window, const std::string& where) {
    const std::vector<std::uint8_t> pixels = window.pixels();
    std::size_t seen = 0;
    for (const DrawnText& text : window.app().texts()) {
      const auto found = contrast_of(text, window, pixels);
      seen += found ? 1 : 0;
      if (found && *found < k_least_contrast)
        faint_.try_emplace(fmt::format("{}: '{}'", text.window, text.text),
                           fmt::format("{:.2f} in {}", *found, where));
    }
    EXPECT_GT(seen, 3U) << where;
  }
  void note() const {
    for (const auto& [text, where] : faint_) ADD_FAILURE() << text << " has a contrast of " << where;
  }

 private:
  std::map<std::string, std::string> faint_;
};

class Contrast : public WindowSceneries {};

TEST_F(Contrast, OfEveryTextIsEnoughInBothThemes) {
  FaintTexts faint;
  in_all_sceneries([&](const char* scenery) {
    for (int theme = 0; theme < 2; ++theme) {
      key({.key = 'T'});
      window.move_mouse({640, 690});
      window.settle();
      const bool dark = state().window.theme == Theme::dark;
      faint.check(window, fmt::format("{}, {}", scenery, dark ? "dark" : "light"));
    }
  });
  faint.note();
}

TEST(StartPageContrast, IsEnoughInBothThemes) {
  FaintTexts faint;
  for (const Theme theme : {Theme::dark, Theme::light}) {
    OffscreenOptions options = quick_options();
    options.user.window.theme = theme;
    options.user.recent = {"/a folder/part.stl"};
    OffscreenWindow window(options);
    window.settle();
    faint.check(window, theme == Theme::dark ? "dark" : "light");
  }
  faint.note();
}

}  // namespace
}  // namespace moldlight::gui::test
