#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "base/shown_text.hpp"
#include "io/atomic_file.hpp"
#include "picture/canvas.hpp"
#include "report/pdf/blocks.hpp"
#include "report/pdf/text.hpp"
#include "report/writers.hpp"

namespace moldlight::report {

namespace {

constexpr double k_margin_pt = 42.5, k_footer_pt = 22.0;  // 15 mm
constexpr double k_still_pt = 270.0;
constexpr std::array<glm::dvec2, 2> k_paper_pt = {glm::dvec2(595.276, 841.89), glm::dvec2(612.0, 792.0)};

using Pieces = std::vector<Piece>;

void add(Pieces& pieces, Pieces more) { std::ranges::move(more, std::back_inserter(pieces)); }

Pieces text_pieces(const Setting& setting, std::string_view text, const TextStyle& style, double gap,
                   double inset = 0.0) {
  return line_pieces(lines_of(setting.canvas, text, style, setting.room.x - inset), style, gap);
}

Ink tone_ink(Tone tone) { return tone == Tone::good ? k_good : tone == Tone::bad ? k_bad : k_attention; }

/// A sign beside the verdict that has its tone without colour, too.
void draw_tone(Canvas& canvas, Tone tone, const glm::dvec2& centre, double radius) {
  const Ink ink = tone_ink(tone);
  if (tone == Tone::good) canvas.disc(centre, radius, ink);
  if (tone == Tone::attention)
    canvas.fill_box({centre - radius, glm::dvec2(2.0 * radius)}, ink, 0.4 * radius);
  if (tone != Tone::bad) return;
  canvas.line(centre - 0.6 * radius, centre + 0.6 * radius, ink, radius);
  canvas.line(centre + glm::dvec2(-0.6, 0.6) * radius, centre + glm::dvec2(0.6, -0.6) * radius, ink, radius);
}

void add_head(const Setting& setting, const Report& report, Pieces& pieces) {
  add(pieces, text_pieces(setting, report.kind,
                          {.size_px = k_small_pt, .weight = FontWeight::medium, .ink = k_faint}, 0.0));
  add(pieces, text_pieces(setting, report.part,
                          {.size_px = 19.0, .weight = FontWeight::semibold, .ink = k_ink}, 1.0));
  if (!report.subject.empty())
    add(pieces, text_pieces(setting, report.subject, {.size_px = 12.0, .ink = k_faint}, 0.0));
  const TextStyle verdict{.size_px = 12.0, .weight = FontWeight::medium, .ink = k_ink};
  constexpr double k_inset_pt = 17.0;
  Pieces lines = text_pieces(setting, report.sentence, verdict, 7.0, k_inset_pt);
  for (Piece& piece : lines) {
    piece.draw = [line = piece.draw, tone = report.tone, first = &piece == &lines.front()](
                     Canvas& canvas, const glm::dvec2& corner) {
      if (first) draw_tone(canvas, tone, corner + glm::dvec2(5.5, 8.2), 4.6);
      line(canvas, corner + glm::dvec2(k_inset_pt, 0.0));
    };
  }
  add(pieces, std::move(lines));
  if (!report.lead.empty())
    add(pieces, text_pieces(setting, report.paragraph(), {.size_px = k_body_pt, .ink = k_soft}, 3.0));
}

/// One line of the legend: marks with their names and what stands beside them.
struct LegendItem {
  Mark mark;
  std::string name, aside;
  double left = 0.0;
};

std::vector<Piece> legend_pieces(const Setting& setting, const ModelView& view) {
  constexpr double k_item_gap_pt = 14.0, k_mark_pt = 11.0, k_line_height_pt = 12.5;
  const TextStyle name{.size_px = k_small_pt, .ink = k_ink}, aside{.size_px = k_small_pt, .ink = k_faint};
  std::vector<std::vector<LegendItem>> rows(1);
  double at = 0.0;
  for (const ViewGroup& group : view.groups) {
    if (group.name.empty() || group.hidden) continue;
    LegendItem item{{group.colour, group.hatched}, {}, {}};
    item.aside = setting.canvas.elided(one_line(group.aside), aside, 0.5 * setting.room.x);
    const double beside = item.aside.empty() ? 0.0 : setting.canvas.text_width(item.aside, aside) + 4.0;
    item.name = setting.canvas.elided(one_line(group.name), name, setting.room.x - k_mark_pt - beside);
    const double width = k_mark_pt + setting.canvas.text_width(item.name, name) + beside;
    if (at > 0.0 && at + width > setting.room.x) {
      rows.emplace_back();
      at = 0.0;
    }
    item.left = at;
    at += width + k_item_gap_pt;
    rows.back().push_back(std::move(item));
  }
  std::vector<Piece> pieces;
  for (const std::vector<LegendItem>& row : rows) {
    if (row.empty()) continue;
    pieces.push_back(
        {.height = k_line_height_pt, .draw = [row, name, aside](Canvas& canvas, const glm::dvec2& corner) {
           for (const LegendItem& item : row) {
             glm::dvec2 base = corner + glm::dvec2(item.left, k_baseline * k_small_pt);
             draw_mark(canvas, item.mark, base - glm::dvec2(0.0, 6.4), 7.0);
             base.x += k_mark_pt;
             canvas.text(base, item.name, name);
             base.x += canvas.text_width(item.name, name) + 4.0;
             canvas.text(base, item.aside, aside);
           }
         }});
  }
  return pieces;
}

/// The logo at the right, above the facts.
void add_title(const Setting& setting, const TitleBlock& title, Pieces& pieces) {
  constexpr glm::dvec2 k_most_logo_pt(140.0, 36.0);
  if (!title.logo.rgba.empty()) {
    const glm::dvec2 pixels(title.logo.width, title.logo.height);
    const glm::dvec2 size = pixels * std::min(k_most_logo_pt.x / pixels.x, k_most_logo_pt.y / pixels.y);
    pieces.push_back({.height = size.y,
                      .gap = 8.0,
                      .with_next = true,
                      .draw = [&title, size](Canvas& canvas, const glm::dvec2& corner) {
                        canvas.picture(title.logo, {corner, size});
                      }});
  }
  for (const Block& block : title.blocks) add(pieces, block_pieces(setting, block));
}

void add_view(const Setting& setting, const Report& report, Pieces& pieces) {
  if (report.still.light.rgba.empty()) return;
  // The caption says how the view is used that paper does not have.
  pieces.push_back(picture_piece(setting, report.still, report.still.text, k_still_pt));
  if (!report.view) return;
  std::vector<Piece> legend = legend_pieces(setting, *report.view);
  if (legend.empty()) return;
  pieces.back().with_next = true;
  legend.front().gap = 3.0;
  add(pieces, std::move(legend));
}

void add_section(const Setting& setting, const Section& section, Pieces& pieces) {
  const TextStyle style{.size_px = 12.5, .weight = FontWeight::semibold, .ink = k_ink};
  constexpr double k_above_pt = 9.0;
  Pieces heading = text_pieces(setting, section.title, style, 14.0);
  Piece& first = heading.front();
  first.height += k_above_pt;
  first.draw = [line = first.draw, width = setting.room.x](Canvas& canvas, const glm::dvec2& corner) {
    canvas.line(corner, corner + glm::dvec2(width, 0.0), k_line, 0.6);
    line(canvas, corner + glm::dvec2(0.0, k_above_pt));
  };
  first.outline = section.title;
  for (Piece& piece : heading) piece.with_next = true;
  add(pieces, std::move(heading));
  for (const Block& block : section.blocks) add(pieces, block_pieces(setting, block));
}

std::vector<Piece> report_pieces(const Setting& setting, const Report& report) {
  Pieces pieces;
  add_head(setting, report, pieces);
  if (report.title) add_title(setting, *report.title, pieces);
  add_view(setting, report, pieces);
  for (const Section& section : report.sections) add_section(setting, section, pieces);
  return pieces;
}

void draw_footer(Canvas& canvas, const glm::dvec2& size, const Report& report, const std::string& number) {
  const TextStyle style{.size_px = 7.5, .ink = k_faint},
      right{.size_px = 7.5, .ink = k_faint, .align = Align::right};
  const double base = size.y - k_margin_pt - 2.0, width = size.x - 2.0 * k_margin_pt;
  const std::string name =
      one_line(report.part + " · " + report.kind + (report.subject.empty() ? "" : " ") + report.subject);
  const double room = width - canvas.text_width(number, right) - 12.0;
  canvas.text({k_margin_pt, base}, canvas.elided(name, style, room), style);
  canvas.text({size.x - k_margin_pt, base}, number, right);
}

/// Height of the pieces with the gaps above them. Gap and height are added before they go to the sum:
/// GCC 12.2 with -O3 counts the first piece twice where the sum takes one after the other.
double sum_of(std::span<const Piece> chain) {
  double sum = 0.0;
  for (const Piece& piece : chain) sum += piece.gap + piece.height;
  return sum;
}

class Pager {
 public:
  explicit Pager(double height) : height_(height) {}

  /// Puts the pieces below each other, on the next page if this one has no room for all of them.
  void place(std::span<const Piece> chain) {
    const double total = sum_of(chain);
    if (!pages_.back().empty() && at_ + total > height_) begin_page(chain.front());
    for (const Piece& piece : chain) put(piece);
  }
  [[nodiscard]] std::vector<PlacedPage> pages() && { return std::move(pages_); }

 private:
  void begin_page(const Piece& first) {
    pages_.emplace_back();
    at_ = 0.0;
    if (first.repeated) put(*first.repeated);
  }
  void put(const Piece& piece) {
    if (!pages_.back().empty()) at_ += piece.gap;
    pages_.back().push_back({&piece, at_});
    at_ += piece.height;
  }

  double height_, at_ = 0.0;
  std::vector<PlacedPage> pages_{1};
};

/// What the pieces take where they begin a page.
double height_of(std::span<const Piece> chain) {
  const Piece& first = chain.front();
  return sum_of(chain) + (first.repeated ? first.repeated->height : -first.gap);
}

}  // namespace

std::string pdf_document(const Report& report, Paper paper) {
  const glm::dvec2 size = k_paper_pt[static_cast<std::size_t>(paper)];
  PdfPages document(size, report.part + " · " + report.kind);
  const Setting setting{document.page(), size - 2.0 * k_margin_pt - glm::dvec2(0.0, k_footer_pt)};
  const std::vector<Piece> pieces = report_pieces(setting, report);
  const std::vector<PlacedPage> pages = paginated(pieces, setting.room.y);
  for (std::size_t k = 0; k < pages.size(); ++k) {
    if (k > 0) document.next_page();
    for (const auto& [piece, top] : pages[k]) {
      if (!piece->outline.empty()) document.outline(piece->outline, k_margin_pt + top);
      piece->draw(document.page(), glm::dvec2(k_margin_pt, k_margin_pt + top));
    }
    draw_footer(document.page(), size, report, fmt::format("Page {} of {}", k + 1, pages.size()));
  }
  return document.finish();
}

void write_pdf(const std::string& path, const Report& report, Paper paper) {
  write_file(path, pdf_document(report, paper));
}

std::vector<PlacedPage> paginated(std::span<const Piece> pieces, double height) {
  Pager pager(height);
  for (std::size_t begin = 0; begin < pieces.size();) {
    std::size_t end = begin + 1;
    while (end < pieces.size() && pieces[end - 1].with_next) ++end;
    const auto chain = pieces.subspan(begin, end - begin);
    if (height_of(chain) <= height) {
      pager.place(chain);
    } else {
      for (std::size_t k = 0; k < chain.size(); ++k) pager.place(chain.subspan(k, 1));
    }
    begin = end;
  }
  return std::move(pager).pages();
}

}  // namespace moldlight::report
