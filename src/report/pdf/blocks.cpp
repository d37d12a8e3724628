#include "report/pdf/blocks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/shown_text.hpp"
#include "report/pdf/text.hpp"

namespace moldlight::report {

namespace {

constexpr double k_between_columns_pt = 18.0;  // between columns
/// No picture is drawn larger; several of them beside each other are lower.
constexpr double k_most_pt_a_pixel = 0.4, k_small_picture_pt = 170.0;

/// As many columns of at least this width as there is room for.
struct Columns {
  Columns(double room, double least, std::size_t most)
      : count(std::clamp<std::size_t>(
            static_cast<std::size_t>((room + k_between_columns_pt) / (least + k_between_columns_pt)), 1,
            most)),
        width((room + k_between_columns_pt) / static_cast<double>(count) - k_between_columns_pt) {}

  [[nodiscard]] double left(std::size_t column) const {
    return static_cast<double>(column) * (width + k_between_columns_pt);
  }

  std::size_t count;
  double width;
};

/// Pieces beside each other, `count` to a row.
std::vector<Piece> side_by_side(const std::vector<Piece>& pieces, const Columns& columns, double gap) {
  std::vector<Piece> rows;
  const auto count = static_cast<std::ptrdiff_t>(columns.count);
  for (std::size_t k = 0; k < pieces.size(); k += columns.count) {
    const auto first = pieces.begin() + static_cast<std::ptrdiff_t>(k);
    const std::vector<Piece> row(first, first + std::min<std::ptrdiff_t>(pieces.end() - first, count));
    const double height = std::ranges::max_element(row, {}, &Piece::height)->height;
    rows.push_back(
        {.height = height, .gap = gap, .draw = [row, columns](Canvas& canvas, const glm::dvec2& corner) {
           for (std::size_t i = 0; i < row.size(); ++i)
             row[i].draw(canvas, corner + glm::dvec2(columns.left(i), 0.0));
         }});
  }
  return rows;
}

/// A line of parts in different looks: a figure with its unit.
struct Line {
  std::vector<std::pair<std::string, TextStyle>> parts;
  double height = 0.0, width = 0.0;
};

/// Sets parts one after the other, on a new line where one finds no room.
std::vector<Line> set_parts(Canvas& canvas, const std::vector<std::pair<std::string, TextStyle>>& parts,
                            double width) {
  constexpr double k_space_pt = 3.0;
  std::vector<Line> lines(1);
  for (const auto& [text, style] : parts) {
    if (text.empty()) continue;
    for (const std::string& line : few_lines_of(canvas, text, style, width)) {
      const double needed = canvas.text_width(line, style) + k_space_pt;
      if (!lines.back().parts.empty() && lines.back().width + needed > width + k_space_pt)
        lines.emplace_back();
      lines.back().parts.emplace_back(line, style);
      lines.back().width += needed;
      lines.back().height = std::max(lines.back().height, line_pt(style));
    }
  }
  return lines;
}

void draw_parts(Canvas& canvas, const glm::dvec2& at, const Line& line) {
  glm::dvec2 base(at.x, at.y + line.height * k_baseline / k_line_height);
  for (const auto& [text, style] : line.parts) {
    canvas.text(base, text, style);
    base.x += canvas.text_width(text, style) + 3.0;
  }
}

Piece figure_piece(Canvas& canvas, const Figure& figure, double width) {
  const TextStyle name_style{.size_px = 7.5, .ink = k_faint}, note_style{.size_px = 7.0, .ink = k_faint};
  const std::vector<std::string> name = few_lines_of(canvas, figure.name, name_style, width);
  const std::vector<Line> value =
      set_parts(canvas,
                {{figure.value.text, {.size_px = 11.0, .weight = FontWeight::semibold, .ink = k_ink}},
                 {figure.unit, {.size_px = k_body_pt, .ink = k_soft}},
                 {figure.error.empty() ? "" : "± " + figure.error, {.size_px = k_small_pt, .ink = k_faint}}},
                width);
  const std::vector<std::string> note =
      figure.note.empty() ? std::vector<std::string>{} : few_lines_of(canvas, figure.note, note_style, width);
  double height = static_cast<double>(name.size()) * line_pt(name_style) +
                  static_cast<double>(note.size()) * line_pt(note_style);
  for (const Line& line : value) height += line.height;
  return {.height = height, .draw = [=](Canvas& page, const glm::dvec2& corner) {
            glm::dvec2 at = corner;
            draw_lines(page, at, name, name_style);
            at.y += static_cast<double>(name.size()) * line_pt(name_style);
            for (const Line& line : value) {
              draw_parts(page, at, line);
              at.y += line.height;
            }
            draw_lines(page, at, note, note_style);
          }};
}

std::vector<Piece> to_pieces(const Setting& setting, const FigureGrid& grid) {
  const Columns columns(setting.room.x, 112.0, 4);
  std::vector<Piece> pieces;
  for (const Figure& figure : grid.figures)
    pieces.push_back(figure_piece(setting.canvas, figure, columns.width));
  return side_by_side(pieces, columns, 9.0);
}

std::vector<Piece> to_pieces(const Setting& setting, const ShareBar& bar) {
  constexpr double k_bar_height_pt = 9.0;
  return {{.height = k_bar_height_pt,
           .gap = 6.0,
           .with_next = true,  // the table that names the shares
           .draw = [&bar, width = setting.room.x](Canvas& canvas, const glm::dvec2& corner) {
             double at = 0.0;
             for (const ShareBar::Share& share : bar.shares) {
               const double part = std::clamp(share.share, 0.0, 1.0) * width;
               draw_box(canvas, share.mark, {corner + glm::dvec2(at, 0.0), {part, k_bar_height_pt}});
               at += part;
             }
           }}};
}

std::vector<Piece> to_pieces(const Setting& setting, const Text& text);

std::vector<Piece> to_pieces(const Setting& setting, const Table& table) {
  std::vector<Piece> pieces = table_pieces(setting.canvas, table, setting.room.x);
  for (const std::string& below : {table.rest, table.tiny})
    if (!below.empty())
      for (Piece& piece : to_pieces(setting, Text{below, TextLook::quiet}))
        pieces.push_back(std::move(piece));
  return pieces;
}

std::vector<Piece> to_pieces(const Setting& setting, const Pictures& pictures) {
  const Columns columns(setting.room.x, 200.0, std::min<std::size_t>(2, pictures.pictures.size()));
  std::vector<Piece> pieces;
  for (const Picture& picture : pictures.pictures) {
    pieces.push_back(picture_piece({setting.canvas, {columns.width, setting.room.y}}, picture,
                                   picture.caption,
                                   columns.count == 1 ? setting.room.y : k_small_picture_pt));
  }
  return side_by_side(pieces, columns, 9.0);
}

std::vector<Piece> to_pieces(const Setting& setting, const DraftBars& bars) {
  if (bars.bars.empty()) return {};
  return {draft_chart_piece(bars, setting.room.x)};
}

TextStyle style_of(TextLook look) {
  const bool small = look == TextLook::quiet || look == TextLook::command;
  return {.size_px = small ? k_small_pt : k_body_pt,
          .ink = look == TextLook::quiet    ? k_faint
                 : look == TextLook::notice ? k_soft
                                            : k_ink};
}

std::vector<Piece> to_pieces(const Setting& setting, const Text& text) {
  const TextStyle style = style_of(text.look);
  const bool command = text.look == TextLook::command, notice = text.look == TextLook::notice;
  const double inset = command || notice ? 8.0 : 0.0, width = setting.room.x;
  std::vector<Piece> pieces =
      line_pieces(lines_of(setting.canvas, text.text, style, width - 2.0 * inset), style, 6.0);
  for (Piece& piece : pieces) {
    const double above = command && &piece == &pieces.front() ? 5.0 : 0.0,
                 below = command && &piece == &pieces.back() ? 5.0 : 0.0;
    piece.height += above + below;
    if (!command && !notice) continue;
    piece.draw = [line = piece.draw, command, inset, above, width, height = piece.height](
                     Canvas& canvas, const glm::dvec2& corner) {
      // A hair more, so that no seam shows between lines.
      const glm::dvec2 size(command ? width : 2.0, height + 0.2);
      canvas.fill_box({corner, size}, command ? k_field : k_attention);
      line(canvas, corner + glm::dvec2(inset, above));
    };
  }
  return pieces;
}

Piece fact_piece(Canvas& canvas, const std::pair<std::string, std::string>& fact, double width) {
  const TextStyle name_style{.size_px = k_small_pt, .ink = k_faint};
  const TextStyle value_style{.size_px = k_small_pt, .ink = k_ink, .align = Align::right};
  // A short name leaves the rest to the value.
  const double name_width = std::min(canvas.text_width(one_line(fact.first), name_style) + 0.01, 0.6 * width);
  const std::vector<std::string> name = few_lines_of(canvas, fact.first, name_style, name_width);
  const std::vector<std::string> value =
      few_lines_of(canvas, fact.second, value_style, width - name_width - 8.0);
  const double height = static_cast<double>(std::max(name.size(), value.size())) * line_pt(name_style) + 4.0;
  return {.height = height, .draw = [=](Canvas& page, const glm::dvec2& corner) {
            draw_lines(page, corner + glm::dvec2(0.0, 2.0), name, name_style);
            draw_lines(page, corner + glm::dvec2(width, 2.0), value, value_style);
            const glm::dvec2 foot = corner + glm::dvec2(0.0, height);
            page.line(foot, foot + glm::dvec2(width, 0.0), k_line, 0.5);
          }};
}

std::vector<Piece> to_pieces(const Setting& setting, const Facts& facts) {
  const Columns columns(setting.room.x, 180.0, 2);
  std::vector<Piece> pieces;
  for (const auto& fact : facts.facts) pieces.push_back(fact_piece(setting.canvas, fact, columns.width));
  pieces = side_by_side(pieces, columns, 0.0);
  if (!pieces.empty()) pieces.front().gap = 6.0;
  return pieces;
}

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

std::vector<Piece> line_pieces(const std::vector<std::string>& lines, const TextStyle& style, double gap) {
  std::vector<Piece> pieces;
  for (const std::string& line : lines) {
    pieces.push_back(
        {.height = line_pt(style), .draw = [line, style](Canvas& canvas, const glm::dvec2& corner) {
           draw_lines(canvas, corner, {line}, style);
         }});
  }
  pieces.front().gap = gap;
  // No line of a paragraph stands alone.
  pieces.front().with_next = pieces.size() > 1;
  if (pieces.size() > 1) pieces[pieces.size() - 2].with_next = true;
  return pieces;
}

Piece picture_piece(const Setting& setting, const Picture& picture, const std::string& caption,
                    double most_height_pt) {
  const TextStyle style{.size_px = k_small_pt, .ink = k_faint};
  const std::vector<std::string> lines = caption.empty()
                                             ? std::vector<std::string>{}
                                             : few_lines_of(setting.canvas, caption, style, setting.room.x);
  const double caption_pt = lines.empty() ? 0.0 : 4.0 + static_cast<double>(lines.size()) * line_pt(style);
  const glm::dvec2 pixels(std::max(1, picture.light.width), std::max(1, picture.light.height));
  const double most = std::min(most_height_pt, setting.room.y - caption_pt);
  const double scale = std::min({setting.room.x / pixels.x, most / pixels.y, k_most_pt_a_pixel});
  const Box box{{0.5 * (setting.room.x - scale * pixels.x), 0.0}, scale * pixels};
  return {.height = box.size.y + caption_pt,
          .gap = 8.0,
          .draw = [&picture, box, lines, style](Canvas& canvas, const glm::dvec2& corner) {
            canvas.picture(picture.light, {corner + box.corner, box.size});
            if (!lines.empty()) draw_lines(canvas, corner + glm::dvec2(0.0, box.size.y + 4.0), lines, style);
          }};
}

std::vector<Piece> block_pieces(const Setting& setting, const Block& block) {
  return std::visit([&](const auto& each) { return to_pieces(setting, each); }, block);
}

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
