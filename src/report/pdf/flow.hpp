// What fills the pages of a document from above: pieces that a page break never cuts.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "picture/canvas.hpp"

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

}  // namespace moldlight::report
