// A table on the pages of a document: its columns as wide as what they hold, as far as there is room.
#include <algorithm>
#include <numeric>

#include <glm/common.hpp>

#include "base/shown_text.hpp"
#include "report/pdf/blocks.hpp"
#include "report/pdf/text.hpp"

namespace moldlight::report {

namespace {

constexpr double k_usual_gap_pt = 12.0, k_least_gap_pt = 7.0, k_most_gap_pt = 30.0, k_row_pad_pt = 3.0,
                 k_mark_room_pt = 12.0;
constexpr double k_largest_pt = 8.5, k_smallest_pt = 6.5, k_size_step_pt = 0.5, k_heading_share = 0.9;
/// Pictures of rows are drawn at twice as many pixels as they take.
constexpr double k_pt_a_pixel = 0.3;
/// Text is given as much before it is broken more often.
constexpr double k_easy_text_pt = 110.0;
constexpr std::size_t k_many_columns = 8;

/// What one column asks for: all in one line, or its longest word.
struct Wish {
  double natural = 0.0, least = 0.0;
};

class TableSetter {
 public:
  TableSetter(Canvas& canvas, const Table& table, double width_pt)
      : canvas_(&canvas),
        table_(&table),
        width_(width_pt),
        widths_(table.columns.size()),
        least_gap_(table.columns.size() > k_many_columns ? k_least_gap_pt : k_usual_gap_pt) {
    for (const Row& row : table.rows)
      picture_ = glm::max(picture_, k_pt_a_pixel * glm::dvec2(row.picture.width, row.picture.height));
    const double room = width_ - (picture_.x > 0.0 ? picture_.x + k_usual_gap_pt : 0.0) -
                        least_gap_ * static_cast<double>(widths_.empty() ? 0 : widths_.size() - 1);
    for (size_ = k_largest_pt; !fits(room) && size_ > k_smallest_pt; size_ -= k_size_step_pt) continue;
  }

  [[nodiscard]] std::vector<Piece> pieces() {
    std::vector<Piece> pieces;
    const auto heading = std::make_shared<const Piece>(heading_piece());
    pieces.push_back(*heading);
    for (const Row& row : table_->rows) {
      pieces.push_back(row_piece(row));
      pieces.back().repeated = heading;
    }
    return pieces;
  }

 private:
  /// Not tabular: what is between spread digits reads as spaces where text is searched and copied.
  [[nodiscard]] TextStyle cell_style(std::size_t column) const {
    return {
        .size_px = size_, .ink = k_ink, .align = table_->columns[column].text ? Align::left : Align::right};
  }
  [[nodiscard]] TextStyle heading_style(std::size_t column) const {
    return {.size_px = k_heading_share * size_,
            .weight = FontWeight::medium,
            .ink = k_faint,
            .align = table_->columns[column].text ? Align::left : Align::right};
  }
  [[nodiscard]] double mark_room(std::size_t column) const {
    return column == 0 &&
                   std::ranges::any_of(table_->rows, [](const Row& row) { return row.mark.has_value(); })
               ? k_mark_room_pt
               : 0.0;
  }

  [[nodiscard]] Wish wish(std::size_t column) const {
    const TextStyle style = cell_style(column), heading = heading_style(column);
    // As long as smaller letters help, figures are not broken and text not much.
    const bool smaller = size_ > k_smallest_pt;
    const double easy = !smaller ? 0.0 : table_->columns[column].text ? k_easy_text_pt : width_;
    Wish wish{word_width(*canvas_, table_->columns[column].heading, heading),
              word_width(*canvas_, table_->columns[column].heading, heading)};
    for (const Row& row : table_->rows) {
      if (column >= row.cells.size()) continue;
      const std::string text = one_line(row.cells[column].text);
      const double natural = canvas_->text_width(text, style) + mark_room(column);
      wish.natural = std::max(wish.natural, natural);
      const double word = word_width(*canvas_, text, style) + mark_room(column);
      wish.least = std::max({wish.least, std::min(natural, easy), word});
    }
    return wish;
  }

  /// Sets the widths of columns; false where words are broken.
  bool fits(double room) {
    std::vector<Wish> wishes;
    Wish sum;
    for (std::size_t k = 0; k < widths_.size(); ++k) {
      wishes.push_back(wish(k));
      sum.natural += wishes.back().natural;
      sum.least += wishes.back().least;
    }
    gap_ = least_gap_;
    if (sum.natural <= room) {
      for (std::size_t k = 0; k < widths_.size(); ++k) widths_[k] = wishes[k].natural;
      const double gaps = static_cast<double>(std::max<std::size_t>(widths_.size(), 2) - 1);
      gap_ = std::min(k_most_gap_pt, least_gap_ + (room - sum.natural) / gaps);
      return true;
    }
    const bool words = sum.least <= room;
    for (std::size_t k = 0; k < widths_.size(); ++k) {
      const auto& [natural, least] = wishes[k];
      widths_[k] = words ? least + (room - sum.least) * (natural - least) / (sum.natural - sum.least)
                         : room * least / sum.least;
    }
    return words;
  }

  /// Where a column's text is aligned to, from the table's left end.
  [[nodiscard]] double place(std::size_t column) const {
    double at = picture_.x > 0.0 ? picture_.x + k_usual_gap_pt : 0.0;
    for (std::size_t k = 0; k < column; ++k) at += widths_[k] + gap_;
    return table_->columns[column].text ? at : at + widths_[column];
  }
  [[nodiscard]] double table_width() const {
    const double used = (picture_.x > 0.0 ? picture_.x + k_usual_gap_pt : 0.0) +
                        std::accumulate(widths_.begin(), widths_.end(), 0.0) +
                        gap_ * static_cast<double>(widths_.empty() ? 0 : widths_.size() - 1);
    return std::min(used, width_);
  }

  struct Cell {
    std::vector<std::string> lines;
    TextStyle style;
    double x = 0.0;  // where it is aligned to
  };
  [[nodiscard]] Cell cell(std::size_t column, const std::string& text, const TextStyle& style) const {
    const double indent = &text == &table_->columns[column].heading ? 0.0 : mark_room(column);
    Cell cell{few_lines_of(*canvas_, text, style, widths_[column] - indent + 0.01), style, place(column)};
    if (table_->columns[column].text) cell.x += indent;
    return cell;
  }
  static double height_of(const std::vector<Cell>& cells) {
    double height = 0.0;
    for (const Cell& cell : cells)
      height = std::max(height, static_cast<double>(cell.lines.size()) * line_pt(cell.style));
    return height;
  }

  [[nodiscard]] Piece heading_piece() const {
    std::vector<Cell> cells;
    for (std::size_t k = 0; k < widths_.size(); ++k)
      cells.push_back(cell(k, table_->columns[k].heading, heading_style(k)));
    const double height = height_of(cells) + k_row_pad_pt;
    return {.height = height,
            .gap = 8.0,
            .with_next = true,
            .draw = [cells, height](Canvas& canvas, const glm::dvec2& corner) {
              for (const Cell& each : cells) {
                const double lines = static_cast<double>(each.lines.size()) * line_pt(each.style);
                draw_lines(canvas, corner + glm::dvec2(each.x, height - k_row_pad_pt - lines), each.lines,
                           each.style);
              }
            }};
  }

  [[nodiscard]] Piece row_piece(const Row& row) const {
    std::vector<Cell> cells;
    for (std::size_t k = 0; k < std::min(widths_.size(), row.cells.size()); ++k)
      cells.push_back(cell(k, row.cells[k].text, cell_style(k)));
    const double height = std::max(height_of(cells), row.picture.height * k_pt_a_pixel) + 2.0 * k_row_pad_pt;
    const double mark_at = place(0) - (table_->columns.front().text ? 0.0 : widths_.front());
    return {.height = height,
            .draw = [cells, height, mark_at, size = size_, row = &row, width = table_width()](
                        Canvas& canvas, const glm::dvec2& corner) {
              canvas.line(corner, corner + glm::dvec2(width, 0.0), k_line, 0.5);
              const glm::dvec2 shown = glm::dvec2(row->picture.width, row->picture.height) * k_pt_a_pixel;
              canvas.picture(row->picture, {corner + glm::dvec2(0.0, k_row_pad_pt), shown});
              for (const Cell& each : cells) {
                const double lines = static_cast<double>(each.lines.size()) * line_pt(each.style);
                const double top = shown.y > 0.0 ? 0.5 * (height - lines) : k_row_pad_pt;
                draw_lines(canvas, corner + glm::dvec2(each.x, top), each.lines, each.style);
                if (&each == &cells.front() && row->mark)
                  draw_mark(canvas, *row->mark, corner + glm::dvec2(mark_at, top + 0.28 * size), 0.85 * size);
              }
            }};
  }

  Canvas* canvas_;
  const Table* table_;
  double width_;
  std::vector<double> widths_;
  glm::dvec2 picture_{0.0};  // the largest
  double least_gap_, gap_ = k_usual_gap_pt;
  double size_ = k_largest_pt;
};

}  // namespace

std::vector<Piece> table_pieces(Canvas& canvas, const Table& table, double width_pt) {
  return TableSetter(canvas, table, width_pt).pieces();
}

}  // namespace moldlight::report
