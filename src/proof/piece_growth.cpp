#include "proof/piece_growth.hpp"

#include <algorithm>

namespace moldlight {

namespace {

/// Of the half width of a cell's cone where something hides an element: for shorter elements the quarters of
/// the cell do more than a cut.
constexpr double k_worth_cutting = 2.0;
constexpr std::size_t k_pieces_between_looks = 64;  // elements between two looks whether to stop
/// Of a facet in more pieces each is likely to have points of its own.
constexpr std::uint32_t k_most_pieces_of_neighbour = 2;

class Growing {
 public:
  Growing(const PieceGrowth& growth, PieceMarks& marks, KnownPieces& known, std::deque<SurfaceElement>& cut)
      : growth_(growth), marks_(marks), known_(known), cut_(cut), open_(std::exchange(known.open, {})) {
    marks_.begin();
    for (const std::uint32_t seed : known_.seeds) add(seed);
  }

  void run() {
    std::size_t asked = 0;
    while (known_.certain < growth_.wanted && (asked++ % k_pieces_between_looks != 0 || !growth_.stop())) {
      if (next_open_ < open_.size()) {
        sort_in(open_[next_open_++]);
      } else if (next_piece_ < pieces_.size()) {
        try_piece(pieces_[next_piece_++]);
      } else if (next_hidden_ < hidden_.size()) {
        try_halves(hidden_[next_hidden_++]);
      } else {
        break;
      }
    }
  }

  /// What is hidden in the middle of the cell comes first in its quarters.
  void hand_on() {
    std::erase_if(known_.seeds, [this](std::uint32_t seed) { return known_.settled[seed]; });
    for (; next_hidden_ < hidden_.size(); ++next_hidden_)
      known_.open.push_back(hidden_[next_hidden_].element);
    known_.open.insert(known_.open.end(), open_.begin() + static_cast<std::ptrdiff_t>(next_open_),
                       open_.end());
    known_.open.insert(known_.open.end(), free_.begin(), free_.end());
  }

 private:
  struct Hidden {
    const SurfaceElement* element;
    double distance;  // of what hides it
  };

  void add(std::uint32_t piece) {
    if (!known_.settled[piece] && marks_.mark(piece)) pieces_.push_back(piece);
  }

  void count(const ElementAnswer& answer, FacetIndex facet) {
    known_.certain += answer.certain_area;
    for (const FacetIndex other : growth_.part.adjacency.across[facet]) {
      if (other == k_no_facet || growth_.surface.count_of(other) > k_most_pieces_of_neighbour) continue;
      for (std::uint32_t k = growth_.surface.first[other]; k < growth_.surface.first[other + 1]; ++k) add(k);
    }
  }

  [[nodiscard]] bool worth_cutting(const SurfaceElement& element, double distance) const {
    return element.length >
           std::max(growth_.finest_length, k_worth_cutting * distance * growth_.cell.radius_rad());
  }

  void try_piece(std::uint32_t piece) {
    const SurfaceElement& element = growth_.surface.pieces[piece];
    const ElementAnswer answer = growth_.tester.ask(element, growth_.cell);
    if (answer.certain_area > 0.0) {
      known_.settled[piece] = true;
      count(answer, element.facet);
    } else if (answer.hidden_at_centre && worth_cutting(element, answer.distance)) {
      known_.settled[piece] = true;
      hidden_.push_back({&element, answer.distance});
    }
  }

  /// What is left of a piece that has been cut; says whether it is still needed.
  bool sort_in(const SurfaceElement* element) {
    const ElementAnswer answer = growth_.tester.ask(*element, growth_.cell);
    if (answer.certain_area > 0.0) {
      count(answer, element->facet);
      return false;
    }
    if (answer.hidden_at_centre) {
      hidden_.push_back({element, answer.distance});
    } else {
      free_.push_back(element);
    }
    return true;
  }

  void try_halves(const Hidden& hidden) {
    if (!worth_cutting(*hidden.element, hidden.distance)) {
      known_.open.push_back(hidden.element);
      return;
    }
    for (const SurfaceElement& half : halves(*hidden.element)) {
      cut_.push_back(half);
      if (!sort_in(&cut_.back())) cut_.pop_back();
    }
  }

  const PieceGrowth& growth_;
  PieceMarks& marks_;
  KnownPieces& known_;
  std::deque<SurfaceElement>& cut_;
  // Each is asked for from its front on.
  std::vector<const SurfaceElement*> open_;
  std::vector<std::uint32_t> pieces_;
  std::vector<Hidden> hidden_;
  std::size_t next_open_ = 0, next_piece_ = 0, next_hidden_ = 0;
  std::vector<const SurfaceElement*> free_;
};

}  // namespace

void grow(const PieceGrowth& growth, PieceMarks& marks, KnownPieces& known, std::deque<SurfaceElement>& cut) {
  Growing growing(growth, marks, known, cut);
  growing.run();
  growing.hand_on();
}

}  // namespace moldlight
