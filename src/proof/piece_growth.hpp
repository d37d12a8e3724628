// Which pieces of the surface are undercut for a whole cell of directions, found by growing from those that
// points on them speak for.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "proof/certain_undercut.hpp"
#include "proof/surface_elements.hpp"

namespace moldlight {

/// What is known of the pieces for a cell, and so for its quarters.
struct KnownPieces {
  double certain = 0.0;                     // area, model units squared
  std::vector<std::uint32_t> seeds;         // pieces on which a point is certain, as long as not settled
  std::vector<bool> settled;                // a piece each: certain, or cut
  std::vector<const SurfaceElement*> open;  // what is left of those that have been cut
};

/// One thread's room: which pieces were asked for already.
class PieceMarks {
 public:
  explicit PieceMarks(std::size_t pieces) : round_of_(pieces, 0) {}

  void begin() { ++round_; }
  /// True the first time since begin().
  [[nodiscard]] bool mark(std::uint32_t piece) { return std::exchange(round_of_[piece], round_) != round_; }

 private:
  std::vector<std::uint32_t> round_of_;
  std::uint32_t round_ = 0;
};

struct PieceGrowth {
  const ProofPart& part;
  const SurfacePieces& surface;
  CertainUndercut& tester;
  const SphereCell& cell;
  double wanted = 0.0;         // area at which it is enough
  double finest_length = 0.0;  // see ProofTask
  std::function<bool()> stop;  // asked now and then
};

/// Asks for what is left of cut pieces, for the seeds, and on from what is certain to its neighbours; pieces
/// of which the middle is hidden are cut where that is worth it. `cut` keeps what comes from cuts, and must
/// outlive what is known.
void grow(const PieceGrowth& growth, PieceMarks& marks, KnownPieces& known, std::deque<SurfaceElement>& cut);

}  // namespace moldlight
