#include "picture/direction_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "mold/direction_field.hpp"
#include "picture/design_space.hpp"
#include "picture/legend.hpp"

namespace moldlight {

namespace {

// Lengths at scale 1, on a picture of 1600 by 1000.
constexpr glm::dvec2 k_design(1600.0, 1000.0);
constexpr glm::dvec2 k_map_centre(496.0, 492.0);
constexpr double k_map_radius = 412.0;
constexpr double k_left = 968.0, k_right = 1552.0, k_top = 92.0, k_bottom = 924.0;
constexpr double k_bar_height = 14.0;
constexpr double k_row = 50.0, k_short_row = 26.0;
// Columns of the table: where figures end.
constexpr double k_number_right = k_left + 18.0, k_tie_left = k_left + 21.0, k_swatch = k_left + 46.0,
                 k_reason_left = k_left + 66.0;
constexpr std::array<double, 3> k_direction_right = {k_left + 120.0, k_left + 180.0, k_left + 240.0};
constexpr std::array<double, k_sphere_columns> k_figure_right = {k_left + 312.0, k_left + 390.0,
                                                                 k_left + 444.0, k_right};

/// Rows of the table, with and without the line that says why.
constexpr std::size_t k_tall_rows = 10, k_short_rows = 19;

std::string tick_text(double value) { return fmt::format("{:.6g}", value); }

Align tick_align(double x) {
  return x < k_left + 20.0 ? Align::left : x > k_right - 24.0 ? Align::right : Align::centre;
}

double draw_colour_bar(DesignSpace& at, double top, const UndercutField& field,
                       const SphereContent& content) {
  const double width = k_right - k_left;
  at.text({k_left, top}, fmt::format("undercut area, {}", content.unit), at.small(Align::left));
  if (content.total_area > 0.0) at.text({k_right, top}, "of the part’s surface", at.small(Align::right));
  const double bar_top = top + 34.0;
  constexpr int k_steps = 540;
  Image bar = empty_image(k_steps, 1);
  for (int x = 0; x < k_steps; ++x) {
    const Colour colour = undercut_scale_colour((x + 0.5) / k_steps);
    std::uint8_t* rgba = bar.at(x, 0);
    rgba[0] = colour.r;
    rgba[1] = colour.g;
    rgba[2] = colour.b;
    rgba[3] = 255;
  }
  const Box box = at.box({k_left, bar_top}, {width, k_bar_height});
  at.canvas().picture(bar, box);
  at.canvas().outline_box(box, at.inks().normal, 0.0, at.scale());
  for (const double area : scale_ticks(field.worst)) {
    const double x = k_left + width * undercut_scale(area, field.worst);
    at.line({x, bar_top + k_bar_height}, {x, bar_top + k_bar_height + 5.0}, at.inks().normal, 1.0);
    at.text({x, bar_top + k_bar_height + 20.0}, tick_text(area), at.figure(tick_align(x)));
  }
  if (content.total_area <= 0.0) return bar_top + k_bar_height + 32.0;
  const double worst_pct = 100.0 * field.worst / content.total_area;
  for (const double pct : scale_ticks(worst_pct)) {
    const double x = k_left + width * undercut_scale(pct, worst_pct);
    at.line({x, bar_top - 5.0}, {x, bar_top}, at.inks().normal, 1.0);
    at.text({x, bar_top - 9.0}, tick_text(pct) + " %", at.small(tick_align(x)));
  }
  return bar_top + k_bar_height + 32.0;
}

void draw_row(DesignSpace& at, double base, const SphereRow& row, const UndercutField& field) {
  const Colour colour = undercut_scale_colour(undercut_scale(row.undercut, field.worst));
  const FontWeight weight = row.mark.best ? FontWeight::semibold : FontWeight::medium;
  at.text({k_number_right, base}, row.number, at.figure(Align::right, weight));
  at.text({k_tie_left, base}, row.tie, at.figure(Align::left));
  const glm::dvec2 swatch = at.place({k_swatch, base - 5.0});
  at.canvas().disc(swatch, 7.0 * at.scale(), {colour});
  at.canvas().ring(swatch, 7.0 * at.scale(), at.inks().normal, 1.0 * at.scale());
  for (std::size_t axis = 0; axis < 3; ++axis)
    at.text({k_direction_right[axis], base}, row.direction[axis], at.figure(Align::right, weight));
  for (std::size_t k = 0; k < k_sphere_columns; ++k) {
    at.text({k_figure_right[k], base}, row.figures[k],
            k == 0 ? at.figure(Align::right, weight) : at.figure(Align::right));
  }
}

void draw_table(DesignSpace& at, double top, const UndercutField& field, const SphereContent& content) {
  const TextStyle head = at.small(Align::right);
  at.text({k_number_right, top}, "#", head);
  for (std::size_t axis = 0; axis < 3; ++axis)
    at.text({k_direction_right[axis], top}, std::string(1, "xyz"[axis]), head);
  for (std::size_t k = 0; k < k_sphere_columns; ++k)
    at.text({k_figure_right[k], top}, content.headings[k], head);
  const bool tall = content.rows.size() <= k_tall_rows;
  double y = top + 12.0;
  at.line({k_left, y}, {k_right, y}, at.inks().border, 1.0);
  y += 4.0;
  const std::size_t shown = std::min(content.rows.size(), tall ? k_tall_rows : k_short_rows);
  for (std::size_t k = 0; k < shown; ++k) {
    const SphereRow& row = content.rows[k];
    const double base = y + 17.0;
    draw_row(at, base, row, field);
    if (tall)
      at.fitting({k_reason_left, base + 18.0}, row.reasons, at.small(Align::left), k_right - k_reason_left);
    y += tall ? k_row : k_short_row;
  }
  if (shown < content.rows.size()) {
    at.text({k_reason_left, y + 17.0}, fmt::format("and {} more", content.rows.size() - shown),
            at.small(Align::left));
  }
}

/// The meaning of the marks, below the map.
void draw_key(DesignSpace& at, const SphereContent& content, bool dark) {
  const double base = k_bottom + 40.0;
  at.text({k_map_centre.x, base},
          "equal-area map of the directions about +z; a direction and its opposite are one",
          at.small(Align::centre));
  if (content.rows.empty()) return;
  double x = k_left + 8.0;
  const auto entry = [&](std::string_view text) {
    at.text({x + 16.0, base}, text, at.small(Align::left));
    x += 16.0 + at.canvas().text_width(text, at.small(Align::left)) / at.scale() + 34.0;
  };
  draw_mark(at.canvas(), at.place({x, base - 4.0}), true, at.scale());
  entry("best");
  draw_mark(at.canvas(), at.place({x, base - 4.0}), false, at.scale());
  entry("listed");
  at.canvas().ring(at.place({x, base - 4.0}), 8.0 * at.scale(), at.inks().normal, 1.3 * at.scale());
  entry("tilt of the best");
  draw_unknown(at.canvas(), at.box({x - 7.0, base - 11.0}, {14.0, 14.0}),
               {.dark = dark, .scale = at.scale()});
  entry("not looked at");
  if (content.open.empty()) return;
  draw_open_sample(at.canvas(), at.place({x, base - 4.0}), at.scale());
  entry("not proved");
}

// Lengths at scale 1.
constexpr double k_margin = 40.0, k_gap = 24.0, k_head = 76.0, k_text = 118.0;
constexpr double k_least_width = 2.0 * k_tile_width + k_gap;  // room for the title and the regions

glm::dvec2 sheet_size(std::size_t tiles) {
  const std::size_t columns = sheet_columns(tiles), rows = tiles == 0 ? 0 : (tiles + columns - 1) / columns;
  const double wide = static_cast<double>(columns), high = static_cast<double>(rows);
  return {std::max(wide * k_tile_width + (wide - 1.0) * k_gap, k_least_width) + 2.0 * k_margin,
          k_margin + k_head + high * (k_tile_height + k_text) + std::max(0.0, high - 1.0) * k_gap + 16.0};
}

/// The colours of the regions, at the sheet's upper right.
void draw_regions(DesignSpace& at, double right, Palette palette) {
  const TextStyle text = at.small(Align::right);
  for (auto at_region = k_regions.rbegin(); at_region != k_regions.rend(); ++at_region) {
    const Region region = *at_region;
    at.text({right, k_margin + 20.0}, region_name(region), text);
    right -= at.canvas().text_width(region_name(region), text) / at.scale() + 20.0;
    fill_region(at.canvas(), at.box({right, k_margin + 9.0}, {12.0, 12.0}), region,
                {.palette = palette, .scale = at.scale()});
    right -= 22.0;
  }
}

/// Where the columns of the tiles' figures start: as wide as their widest text, what is left between them.
std::vector<double> figure_columns(DesignSpace& at, std::span<const ContactTile> tiles) {
  std::vector<double> widths;
  const auto width = [&](const std::string& text, const TextStyle& style) {
    return at.canvas().text_width(text, style) / at.scale();
  };
  for (const ContactTile& tile : tiles) {
    widths.resize(std::max(widths.size(), tile.figures.size()));
    for (std::size_t k = 0; k < tile.figures.size(); ++k) {
      const auto& [name, value] = tile.figures[k];
      widths[k] = std::max({widths[k], width(name, at.small(Align::left)),
                            width(value, at.figure(Align::left, FontWeight::semibold))});
    }
  }
  const double free = k_tile_width - std::accumulate(widths.begin(), widths.end(), 0.0);
  const double gap = widths.size() < 2 ? 0.0 : free / static_cast<double>(widths.size() - 1);
  std::vector<double> columns;
  double x = 0.0;
  for (const double each : widths) {
    columns.push_back(x);
    x += each + gap;
  }
  return columns;
}

void draw_tile(DesignSpace& at, const glm::dvec2& corner, const ContactTile& tile,
               std::span<const double> columns) {
  const Box box = at.box(corner, {k_tile_width, k_tile_height});
  at.canvas().picture(tile.picture, box);
  at.canvas().outline_box({box.corner + 0.5, box.size - 1.0}, at.inks().border, 0.0,
                          std::max(1.0, at.scale()));

  double base = corner.y + k_tile_height + 28.0;
  const TextStyle heading = at.figure(Align::left, FontWeight::semibold);
  at.text({corner.x, base}, tile.number, heading);
  const double after = corner.x + at.canvas().text_width(tile.number, heading) / at.scale() + 12.0;
  at.text({after, base}, tile.heading, at.figure(Align::left));
  at.text({corner.x + k_tile_width, base}, tile.remark, at.small(Align::right));
  base += 24.0;
  for (std::size_t k = 0; k < tile.figures.size(); ++k) {
    const double x = corner.x + columns[k];
    at.text({x, base}, tile.figures[k].name, at.small(Align::left));
    at.text({x, base + 20.0}, tile.figures[k].value,
            at.figure(Align::left, k == 0 ? FontWeight::semibold : FontWeight::regular));
  }
  at.fitting({corner.x, base + 43.0}, tile.reasons, at.small(Align::left), k_tile_width);
}

}  // namespace

std::vector<double> scale_ticks(double worst) {
  std::vector<double> ticks = {0.0};
  if (!(worst > 0.0)) return ticks;
  constexpr double k_apart = 0.13;  // of the bar, which has the square root of the area
  std::vector<double> round;
  const double decade = std::pow(10.0, std::floor(std::log10(worst)));
  for (const double step : {5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01}) {
    // Written so that 0.2 of a decade is the number nearest to it.
    const double value = step >= 1.0 ? step * decade : decade / std::round(1.0 / step);
    if (value <= worst * (1.0 + 1e-12)) round.push_back(value);
  }
  std::vector<double> kept;
  for (const double value : round) {
    const double place = undercut_scale(value, worst);
    if (place < k_apart) break;
    if (kept.empty() || undercut_scale(kept.back(), worst) - place >= k_apart) kept.push_back(value);
  }
  ticks.insert(ticks.end(), kept.rbegin(), kept.rend());
  return ticks;
}

Image direction_sphere_picture(const glm::ivec2& size, const UndercutField& field,
                               const SphereContent& content, bool dark) {
  Canvas canvas(size.x, size.y);
  DesignSpace at(canvas, k_design, dark);
  canvas.fill({picture_ground(dark)});
  std::vector<SphereMark> marks;
  for (const SphereRow& row : content.rows) marks.push_back(row.mark);
  draw_sphere_map(canvas, {at.place(k_map_centre), k_map_radius * at.scale()}, field, marks,
                  {.dark = dark, .scale = at.scale()});
  draw_open_caps(canvas, {at.place(k_map_centre), k_map_radius * at.scale()}, content.open, at.scale());
  const TextStyle title = at.title();
  at.elided({k_left, k_top}, content.title, title, k_right - k_left);
  double y = k_top + 24.0;
  for (const std::string& line : content.lines) {
    at.elided({k_left, y}, line, at.small(Align::left), k_right - k_left);
    y += 19.0;
  }
  y = draw_colour_bar(at, y + 18.0, field, content) + 32.0;
  if (content.rows.empty()) {
    at.text({k_left, y}, content.note, at.figure(Align::left));
  } else {
    draw_table(at, y, field, content);
  }
  draw_key(at, content, dark);
  return canvas.image();
}

std::size_t sheet_columns(std::size_t tiles) {
  if (tiles <= 4) return std::max<std::size_t>(tiles, 1);
  std::size_t best = 3, fewest = tiles;
  for (const std::size_t columns : {5, 4, 3}) {
    const std::size_t empty = (columns - tiles % columns) % columns;
    if (empty >= fewest) continue;
    fewest = empty;
    best = columns;
  }
  return best;
}

Image contact_sheet_picture(const ContactSheet& sheet, double scale) {
  const glm::dvec2 size = sheet_size(sheet.tiles.size());
  Canvas canvas(static_cast<int>(std::lround(scale * size.x)), static_cast<int>(std::lround(scale * size.y)));
  DesignSpace at(canvas, size, sheet.dark);
  canvas.fill({picture_ground(sheet.dark)});
  draw_regions(at, size.x - k_margin, sheet.palette);
  at.elided({k_margin, k_margin + 20.0}, sheet.title, at.title(), 540.0);
  at.elided({k_margin, k_margin + 46.0}, sheet.line, at.small(Align::left), size.x - 2.0 * k_margin);
  const std::vector<double> figures = figure_columns(at, sheet.tiles);
  const std::size_t columns = sheet_columns(sheet.tiles.size());
  for (std::size_t k = 0; k < sheet.tiles.size(); ++k) {
    const auto column = static_cast<double>(k % columns), row = static_cast<double>(k / columns);
    draw_tile(at,
              {k_margin + column * (k_tile_width + k_gap),
               k_margin + k_head + row * (k_tile_height + k_text + k_gap)},
              sheet.tiles[k], figures);
  }
  return canvas.image();
}

}  // namespace moldlight
