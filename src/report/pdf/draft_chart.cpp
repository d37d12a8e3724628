// The histogram of areas by draft on the pages of a document.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/pdf/blocks.hpp"
#include "report/pdf/text.hpp"

namespace moldlight::report {

namespace {

constexpr double k_top_pt = 18.0, k_foot_pt = 116.0, k_chart_height_pt = 132.0, k_between_pt = 0.5,
                 k_tick_deg = 5.0;

/// Where an angle stands, from the chart's left end.
struct Scale {
  double from_deg = 0.0, to_deg = 1.0, width = 0.0;

  [[nodiscard]] double place(double deg) const { return (deg - from_deg) / (to_deg - from_deg) * width; }
};

void draw_bars(Canvas& canvas, const DraftBars& bars, const Scale& scale, const glm::dvec2& corner) {
  double tallest = 0.0;
  for (const DraftBars::Bar& bar : bars.bars) tallest = std::max(tallest, bar.core + bar.cavity);
  if (tallest <= 0.0) return;
  for (const DraftBars::Bar& bar : bars.bars) {
    double foot = k_foot_pt;
    const double left = scale.place(bar.from_deg) + k_between_pt,
                 width = scale.place(bar.to_deg) - left - k_between_pt;
    for (const auto& [area, mark] : {std::pair(bar.core, bars.core), std::pair(bar.cavity, bars.cavity)}) {
      const double height = (k_foot_pt - k_top_pt) * area / tallest;
      foot -= height;
      draw_box(canvas, mark, {corner + glm::dvec2(left, foot), {width, height}});
    }
  }
}

void draw_limit(Canvas& canvas, double deg, const Scale& scale, const glm::dvec2& corner) {
  const double x = scale.place(deg);
  canvas.line(corner + glm::dvec2(x, 2.0), corner + glm::dvec2(x, k_foot_pt), k_ink, 1.0);
  const bool right = x > 0.7 * scale.width;
  canvas.text(corner + glm::dvec2(right ? x - 4.0 : x + 4.0, 9.0), fmt::format("{:g}° asked for", deg),
              {.size_px = k_small_pt, .ink = k_soft, .align = right ? Align::right : Align::left});
}

void draw_axis(Canvas& canvas, const Scale& scale, const glm::dvec2& corner) {
  const glm::dvec2 foot = corner + glm::dvec2(0.0, k_foot_pt);
  canvas.line(foot, foot + glm::dvec2(scale.width, 0.0), k_faint, 0.6);
  for (double deg = std::ceil(scale.from_deg / k_tick_deg) * k_tick_deg; deg <= scale.to_deg;
       deg += k_tick_deg) {
    const double x = scale.place(deg);
    const Align align = x < 8.0 ? Align::left : x > scale.width - 8.0 ? Align::right : Align::centre;
    canvas.text(foot + glm::dvec2(x, 11.0), fmt::format("{:g}°", deg + 0.0),
                {.size_px = k_small_pt, .ink = k_faint, .align = align});
  }
}

}  // namespace

Piece draft_chart_piece(const DraftBars& bars, double width_pt) {
  const Scale scale{bars.bars.front().from_deg, bars.bars.back().to_deg, width_pt};
  return {
      .height = k_chart_height_pt,
      .gap = 6.0,
      .draw = [&bars, scale](Canvas& canvas, const glm::dvec2& corner) {
        draw_bars(canvas, bars, scale, corner);
        if (bars.required_deg && *bars.required_deg >= scale.from_deg && *bars.required_deg <= scale.to_deg)
          draw_limit(canvas, *bars.required_deg, scale, corner);
        draw_axis(canvas, scale, corner);
      }};
}

}  // namespace moldlight::report
