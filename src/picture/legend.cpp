#include "picture/legend.hpp"

#include <algorithm>

#include "picture/design_space.hpp"

namespace moldlight {

namespace {

// Lengths at scale 1, on a grid of four pixels.
constexpr double k_width = 324.0, k_padding = 20.0, k_radius = 12.0;
constexpr double k_legend_title_px = 17.0, k_text_px = 14.0, k_small_line_px = 12.0;
constexpr double k_title_line = 24.0, k_small_line = 18.0, k_region_row = 26.0;
constexpr double k_share_bar_height = 8.0, k_bar_gap = 16.0;
constexpr double k_region_swatch = 12.0, k_name_left = 22.0, k_percent_right = 160.0;

/// A place given at scale 1 from the legend's inner corner.
glm::dvec2 inner(double x, double y) { return {k_padding + x, k_padding + y}; }

double inner_width() { return k_width - 2.0 * k_padding; }

double inner_height(const LegendContent& content) {
  double height = k_title_line + k_small_line * static_cast<double>(content.lines.size());
  height += k_bar_gap + k_share_bar_height + 12.0 + k_region_row * k_region_count;
  if (!content.note.empty()) height += 8.0 + k_small_line;
  return height - 6.0;
}

void draw_bar(DesignSpace& at, double top, const LegendContent& content, const LegendStyle& style) {
  const double gap = 2.0, least = 3.0;
  double shown = 0.0;
  for (const double share : content.shares) shown += share > 0.0 ? 1.0 : 0.0;
  const double room = inner_width() - gap * std::max(0.0, shown - 1.0) - least * shown;
  double left = 0.0;
  for (const Region region : k_regions) {
    const double share = content.shares[static_cast<std::size_t>(region)];
    if (share <= 0.0) continue;
    const double width = least + room * share;
    fill_region(at.canvas(), at.box(inner(left, top), {width, k_share_bar_height}), region, style);
    left += width + gap;
  }
}

TextStyle tag_text(const LegendStyle& style) {
  return {.size_px = k_small_line_px * style.scale,
          .weight = FontWeight::medium,
          .ink = picture_inks(style.dark).normal,
          .align = Align::centre};
}

}  // namespace

void fill_region(Canvas& canvas, const Box& box, Region region, const LegendStyle& style) {
  const double radius = 0.25 * box.size.y;
  canvas.fill_box(box, {region_colour(region, style.palette)}, radius);
  if (region == Region::undercut) canvas.hatch_box(box, {{0, 0, 0}, 0.28}, radius, 5.0 * style.scale);
}

glm::dvec2 tag_size(Canvas& canvas, std::string_view word, const LegendStyle& style) {
  const TextStyle text = tag_text(style);
  return {canvas.text_width(word, text) + 1.3 * text.size_px, 1.75 * text.size_px};
}

void draw_tag(Canvas& canvas, const glm::dvec2& centre, std::string_view word, const LegendStyle& style) {
  const TextStyle text = tag_text(style);
  const glm::dvec2 size = tag_size(canvas, word, style);
  Ink card = picture_inks(style.dark).card;
  card.opacity *= 0.85;
  canvas.fill_box({centre - 0.5 * size, size}, card, 0.5 * size.y);
  canvas.text(centre + glm::dvec2(0.0, 0.36 * text.size_px), word, text);
}

glm::dvec2 legend_size(const LegendContent& content, const LegendStyle& style) {
  return style.scale * glm::dvec2(k_width, inner_height(content) + 2.0 * k_padding);
}

void draw_legend(Canvas& canvas, const glm::dvec2& corner, const LegendContent& content,
                 const LegendStyle& style) {
  const PictureInks inks = picture_inks(style.dark);
  const Box card{corner, legend_size(content, style)};
  canvas.fill_box(card, inks.card, k_radius * style.scale);
  const Box border{card.corner + 0.5, card.size - 1.0};
  canvas.outline_box(border, inks.border, k_radius * style.scale, 1.0);

  DesignSpace at(canvas, corner, style.scale, style.dark);
  const auto text = [&](double size, const Ink& ink, Align align, FontWeight weight = FontWeight::regular) {
    return TextStyle{
        .size_px = style.scale * size, .weight = weight, .ink = ink, .align = align, .tabular = true};
  };
  at.elided(inner(0.0, 14.0), content.title,
            text(k_legend_title_px, inks.strong, Align::left, FontWeight::semibold), inner_width());
  double y = k_title_line;
  const TextStyle small = text(k_small_line_px, inks.faint, Align::left);
  for (const std::string& line : content.lines) {
    at.elided(inner(0.0, y + 11.0), line, small, inner_width());
    y += k_small_line;
  }
  y += k_bar_gap - 4.0;
  draw_bar(at, y, content, style);
  y += k_share_bar_height + 12.0;

  for (const Region region : k_regions) {
    const auto index = static_cast<std::size_t>(region);
    const bool undercut = region == Region::undercut;
    fill_region(canvas, at.box(inner(0.0, y + 5.0), {k_region_swatch, k_region_swatch}), region, style);
    const FontWeight weight = undercut ? FontWeight::semibold : FontWeight::regular;
    const Ink& ink = undercut ? inks.strong : inks.normal;
    const TextStyle figure = text(k_text_px, ink, Align::right, weight);
    at.text(inner(k_name_left, y + 16.0), region_name(region), text(k_text_px, ink, Align::left, weight));
    at.text(inner(k_percent_right - 14.0, y + 16.0), content.percents[index], figure);
    at.text(inner(k_percent_right - 10.0, y + 16.0), "%", small);
    at.text(inner(inner_width() - 30.0, y + 16.0), content.areas[index], figure);
    at.text(inner(inner_width(), y + 16.0), content.unit, text(k_small_line_px, inks.faint, Align::right));
    y += k_region_row;
  }
  if (!content.note.empty()) at.elided(inner(0.0, y + 8.0 + 9.0), content.note, small, inner_width());
}

}  // namespace moldlight
