#include "picture/contact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "picture/design_space.hpp"
#include "picture/legend.hpp"

namespace moldlight {

namespace {

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
