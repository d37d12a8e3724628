// The legend of a classified part: what each colour means and how much of it there is.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "mold/region.hpp"
#include "picture/canvas.hpp"

namespace moldlight {

/// The texts and shares of a legend; all texts are ready to be shown.
struct LegendContent {
  std::string title = {};
  std::vector<std::string> lines = {};                 // below the title
  std::array<double, k_region_count> shares{};         // of the whole area, [0, 1]
  std::array<std::string, k_region_count> percents{};  // "41.20"
  std::array<std::string, k_region_count> areas{};     // "1234.5"
  std::string unit = {};                               // of the areas
  std::string note = {};                               // a last line; empty for none
};

struct LegendStyle {
  bool dark = true;
  Palette palette = Palette::paper;
  double scale = 1.0;  // 1: text of 14 pixels
};

/// A box in the region's colour, hatched as undercuts are.
void fill_region(Canvas& canvas, const Box& box, Region region, const LegendStyle& style);
/// Room that the legend takes, in pixels.
[[nodiscard]] glm::dvec2 legend_size(const LegendContent& content, const LegendStyle& style);
/// Room that a tag takes: a word in a small box of its own.
[[nodiscard]] glm::dvec2 tag_size(Canvas& canvas, std::string_view word, const LegendStyle& style);
void draw_tag(Canvas& canvas, const glm::dvec2& centre, std::string_view word, const LegendStyle& style);

void draw_legend(Canvas& canvas, const glm::dvec2& corner, const LegendContent& content,
                 const LegendStyle& style);

}  // namespace moldlight
