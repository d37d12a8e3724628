// The blocks of a report as pieces of pages, which a page break never cuts.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "picture/canvas.hpp"
#include "report/report.hpp"

namespace moldlight::report {

/// Lengths are in points.
struct Piece {
  double height = 0.0;
  double gap = 0.0;        // above it, where it is not the first of its page
  bool with_next = false;  // never the last of its page
  std::function<void(Canvas&, const glm::dvec2&)> draw = {};  // its upper left corner
  std::shared_ptr<const Piece> repeated = {};  // stands above it where it begins a page: a table's headings
  std::string outline = {};                    // its line in the document's outline
};

struct PlacedPiece {
  const Piece* piece = nullptr;
  double top = 0.0;  // from the upper end of the page's room
};
using PlacedPage = std::vector<PlacedPiece>;

/// Places pieces on pages with room for `height`, which must be that of the highest at least; what is to stay
/// together and is higher than a page comes apart. Always a page or more, and none empty if there are pieces.
[[nodiscard]] std::vector<PlacedPage> paginated(std::span<const Piece> pieces, double height);

/// What pieces are made with. They keep pointers into the report.
struct Setting {
  Canvas& canvas;        // measures
  glm::dvec2 room{0.0};  // of a page, in points
};

[[nodiscard]] std::vector<Piece> block_pieces(const Setting& setting, const Block& block);

/// Lines below each other, each a piece. `gap` is above the first.
[[nodiscard]] std::vector<Piece> line_pieces(const std::vector<std::string>& lines, const TextStyle& style,
                                             double gap);
/// A picture with its caption, in one piece.
[[nodiscard]] Piece picture_piece(const Setting& setting, const Picture& picture, const std::string& caption,
                                  double most_height_pt);

/// `bars` must not be empty; the piece keeps a pointer to it.
[[nodiscard]] Piece draft_chart_piece(const DraftBars& bars, double width_pt);

/// Rows with their headings, which stand above the first row of every page. `canvas` measures; the pieces
/// keep pointers into the table.
[[nodiscard]] std::vector<Piece> table_pieces(Canvas& canvas, const Table& table, double width_pt);

}  // namespace moldlight::report
