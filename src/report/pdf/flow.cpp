// Pieces that fill the pages of a document from above; a page break never cuts one.
#include "report/pdf/blocks.hpp"

namespace moldlight::report {

namespace {

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
