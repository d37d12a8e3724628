// The blocks of a report as pieces of pages.
#pragma once

#include <vector>

#include "report/pdf/flow.hpp"
#include "report/report.hpp"

namespace moldlight::report {

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

}  // namespace moldlight::report
