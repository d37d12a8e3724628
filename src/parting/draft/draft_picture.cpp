#include "parting/draft/draft_picture.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "classify/number_format.hpp"
#include "picture/design_space.hpp"
#include "picture/legend.hpp"

namespace moldlight {

namespace {

// Lengths at scale 1.
constexpr double k_width = 372.0, k_height = 224.0, k_margin = 24.0, k_padding = 20.0, k_radius = 12.0;
constexpr double k_title_at = 14.0, k_line_at = 34.0;  // baselines
constexpr double k_chart_top = 56.0, k_chart_bottom = 158.0, k_axis_at = 174.0;
constexpr double k_from_deg = -5.0, k_to_deg = 10.0;
constexpr double k_least_scale = 0.5;
constexpr glm::dvec2 k_design(1600.0, 1000.0);

double place_of(double draft_deg) {
  return k_padding + (draft_deg - k_from_deg) / (k_to_deg - k_from_deg) * (k_width - 2.0 * k_padding);
}

void draw_bars(DesignSpace& at, const DraftCheck& check, const LegendStyle& style) {
  double tallest = 0.0;
  const auto is_shown = [](const DraftBin& bin) {
    return bin.from_deg >= k_from_deg && bin.to_deg <= k_to_deg;
  };
  for (const DraftBin& bin : check.histogram) {
    if (is_shown(bin)) tallest = std::max(tallest, bin.area[0] + bin.area[1]);
  }
  for (const DraftBin& bin : check.histogram) {
    if (!is_shown(bin) || tallest <= 0.0) continue;
    double foot = k_padding + k_chart_bottom;
    const double left = place_of(bin.from_deg) + 0.5, width = place_of(bin.to_deg) - left - 0.5;
    for (const Region region : {Region::core, Region::cavity}) {
      const double height =
          (k_chart_bottom - k_chart_top) * bin.area[region == Region::core ? 0 : 1] / tallest;
      foot -= height;
      if (height > 0.0) fill_region(at.canvas(), at.box({left, foot}, {width, height}), region, style);
    }
  }
}

}  // namespace

Image with_draft_histogram(const Image& picture, const PartModel& model, const DraftCheck& check,
                           const StillSettings& settings) {
  const glm::dvec2 size(picture.width, picture.height);
  const double scale = std::min(size.x / k_design.x, size.y / k_design.y);
  if (!settings.legend || scale < k_least_scale) return picture;
  const LegendStyle style{
      .dark = settings.theme == Theme::dark, .palette = settings.look.palette, .scale = scale};
  const PictureInks inks = picture_inks(style.dark);
  Canvas canvas(picture);
  const Box card{size - scale * glm::dvec2(k_width + k_margin, k_height + k_margin),
                 scale * glm::dvec2(k_width, k_height)};
  canvas.fill_box(card, inks.card, k_radius * scale);
  canvas.outline_box({card.corner + 0.5, card.size - 1.0}, inks.border, k_radius * scale, 1.0);

  DesignSpace at(canvas, card.corner, scale, style.dark);
  const double inner = k_width - 2.0 * k_padding;
  at.elided({k_padding, k_padding + k_title_at}, "Draft by area", at.title(), inner);
  const std::string unit = powered_unit(model.part, 2);
  const FigureColumn areas(check.below[0] + check.below[1]);
  at.elided({k_padding, k_padding + k_line_at},
            fmt::format("below {}°: core {}, cavity {} {}", figure(check.required_deg),
                        areas.text(check.below[0]), areas.text(check.below[1]), unit),
            at.small(Align::left), inner);
  draw_bars(at, check, style);
  at.line({k_padding, k_padding + k_chart_bottom}, {k_width - k_padding, k_padding + k_chart_bottom},
          inks.faint, 1.0);
  if (check.required_deg <= k_to_deg) {
    const double x = place_of(check.required_deg);
    at.line({x, k_padding + k_chart_top - 4.0}, {x, k_padding + k_chart_bottom}, inks.strong, 1.5);
  }
  for (const int degrees : {-5, 0, 5, 10})
    at.text({place_of(degrees), k_padding + k_axis_at}, fmt::format("{}°", degrees), at.small(Align::centre));
  return canvas.image();
}

}  // namespace moldlight
