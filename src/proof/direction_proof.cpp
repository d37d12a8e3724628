#include "proof/direction_proof.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <deque>
#include <mutex>
#include <numeric>
#include <utility>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "mesh/orient.hpp"
#include "proof/piece_growth.hpp"

namespace moldlight {

namespace {

/// A cell is left open at once below this radius where so much less than the bound is hidden in its middle,
/// in those of the two that it came from, and at its corners: it is likely to be free as a whole.
constexpr double k_little = 0.5, k_calm_deg = 2.5;
constexpr int k_calm_generations = 3;

/// Points between two looks whether to stop.
constexpr std::size_t k_between_looks = 64;

/// By area: pieces are looked at where points come near the bound, less so many standard errors, and points
/// are looked at until they have so much more than the bound.
constexpr double k_standard_errors = 3.0, k_points_wanted = 1.3;

using Points = std::vector<std::uint32_t>;

/// What a cell hands on to its quarters.
struct Inherited {
  double certain = 0.0;  // area that points stand for
  Points open;           // not certain yet
  int calm = 0;          // cells on the way here, the last ones, in which little was hidden
  KnownPieces pieces;    // by area alone
};

/// What is known of a cell.
struct CellState {
  Inherited to_hand_on;
  double hidden = 0.0;             // area of points that are hidden in the cell's middle, but not certain
  std::deque<SurfaceElement> cut;  // what came from cuts here
};

class Search {
 public:
  /// `pieces` is null for a proof by points alone.
  Search(const ProofPart& part, const ProofTask& task, std::span<const SurfaceElement> points,
         const SurfacePieces* pieces)
      : part_(part),
        task_(task),
        points_(points),
        pieces_(pieces),
        point_area_(points.empty() ? 0.0 : points.front().area),
        testers_([&part, query = task.query] { return CertainUndercut(part, query); }),
        marks_([pieces] { return PieceMarks(pieces ? pieces->pieces.size() : 0); }) {}

  std::vector<ProofCell> run(const SphereCell& cell, const Inherited& inherited);

  [[nodiscard]] std::size_t looked_at() const { return looked_at_; }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  /// Asks, and stays so.
  bool is_stopped() {
    if (task_.stop && task_.stop()) stopped_ = true;
    return stopped_;
  }
  [[nodiscard]] double proved_area(const Inherited& known) const {
    return pieces_ ? known.pieces.certain : known.certain;
  }
  void find_certain(const SphereCell& cell, const Inherited& inherited, CellState& state);
  void find_certain_pieces(const SphereCell& cell, CellState& state);
  [[nodiscard]] bool little_at_corners(const SphereCell& cell, const Inherited& known);
  [[nodiscard]] std::vector<ProofCell> end(const SphereCell& cell, double certain, bool proved);

  const ProofPart& part_;
  const ProofTask& task_;
  std::span<const SurfaceElement> points_;
  const SurfacePieces* pieces_;
  double point_area_;
  tbb::enumerable_thread_specific<CertainUndercut> testers_;
  tbb::enumerable_thread_specific<PieceMarks> marks_;
  std::atomic<std::size_t> looked_at_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  double decided_ = 0.0;  // share of the half-sphere
};

std::vector<ProofCell> Search::end(const SphereCell& cell, double certain, bool proved) {
  if (task_.progress) {
    const std::lock_guard lock(mutex_);
    decided_ += cell.share();
    task_.progress(std::clamp(1.0 - decided_, 0.0, 1.0));
  }
  return {{cell, certain, proved}};
}

std::vector<ProofCell> Search::run(const SphereCell& cell, const Inherited& inherited) {
  const double known = proved_area(inherited);
  if (is_stopped() || known >= task_.bound) return end(cell, known, known >= task_.bound);
  ++looked_at_;
  CellState state;
  Inherited& next = state.to_hand_on;
  find_certain(cell, inherited, state);
  if (pieces_) find_certain_pieces(cell, state);
  const double certain = proved_area(next);
  if (certain >= task_.bound) return end(cell, certain, true);
  if (stopped_) return end(cell, certain, false);  // some were left out
  const bool little = next.certain + state.hidden < k_little * task_.bound;
  next.calm = little ? inherited.calm + 1 : 0;
  const bool calm =
      next.calm >= k_calm_generations && cell.radius_deg() < k_calm_deg && little_at_corners(cell, next);
  if (calm || cell.radius_deg() < 2.0 * task_.finest_deg) return end(cell, certain, false);
  const auto quarters = cell.quarters();
  std::array<std::vector<ProofCell>, 4> found;
  tbb::parallel_for(std::size_t{0}, quarters.size(),
                    [&](std::size_t k) { found[k] = run(quarters[k], next); });
  std::vector<ProofCell> all = std::move(found[0]);
  for (std::size_t k = 1; k < found.size(); ++k) all.insert(all.end(), found[k].begin(), found[k].end());
  return all;
}

bool Search::little_at_corners(const SphereCell& cell, const Inherited& known) {
  constexpr int k_generations = 5;  // from a cell to one at its corner
  CertainUndercut& tester = testers_.local();
  for (std::size_t corner = 0; corner < 3; ++corner) {
    SphereCell small = cell;
    for (int k = 0; k < k_generations; ++k) small = small.quarters()[corner];
    double hidden = known.certain;
    for (const std::uint32_t point : known.open) {
      if (tester.ask(points_[point], small).hidden_at_centre) hidden += points_[point].area;
      if (hidden >= k_little * task_.bound) return false;
    }
  }
  return true;
}

/// Until there are enough points; what is hidden in the middle of the cell comes first in its quarters.
void Search::find_certain(const SphereCell& cell, const Inherited& inherited, CellState& state) {
  CertainUndercut& tester = testers_.local();
  Inherited& next = state.to_hand_on;
  next.certain = inherited.certain;
  next.pieces = inherited.pieces;
  const double wanted = pieces_ ? k_points_wanted * task_.bound : task_.bound;
  Points free;
  for (std::size_t k = 0; k < inherited.open.size(); ++k) {
    if (next.certain >= wanted) {
      next.open.insert(next.open.end(), inherited.open.begin() + static_cast<std::ptrdiff_t>(k),
                       inherited.open.end());
      break;
    }
    if (k % k_between_looks == 0 && is_stopped()) return;
    const std::uint32_t point = inherited.open[k];
    const ElementAnswer answer = tester.ask(points_[point], cell);
    if (answer.certain_area > 0.0) {
      next.certain += answer.certain_area;
      if (pieces_) next.pieces.seeds.push_back(pieces_->piece_of_guide[point]);
    } else if (answer.hidden_at_centre) {
      state.hidden += points_[point].area;
      next.open.push_back(point);
    } else {
      free.push_back(point);
    }
  }
  next.open.insert(next.open.end(), free.begin(), free.end());
}

void Search::find_certain_pieces(const SphereCell& cell, CellState& state) {
  const double error = k_standard_errors * std::sqrt(task_.bound * point_area_);
  if (stopped_ || state.to_hand_on.certain + error < task_.bound) return;
  const PieceGrowth growth{.part = part_,
                           .surface = *pieces_,
                           .tester = testers_.local(),
                           .cell = cell,
                           .wanted = task_.bound,
                           .finest_length = task_.finest_length,
                           .stop = [this] { return is_stopped(); }};
  grow(growth, marks_.local(), state.to_hand_on.pieces, state.cut);
}

DirectionProof prove(const ProofPart& part, const ProofTask& task, std::span<const SurfaceElement> points,
                     const SurfacePieces* pieces) {
  DirectionProof proof;
  proof.bound = task.bound;
  // A ray that enters the solid leaves it again, unless the ray began inside of a body that is inside out.
  TriangleMesh outward = part.mesh;
  Inherited all;
  if (turn_if_inside_out(outward).facets == 0) {
    all.open.resize(points.size());
    std::iota(all.open.begin(), all.open.end(), 0U);
  }
  if (pieces) all.pieces.settled.resize(pieces->pieces.size());
  Search search(part, task, points, pieces);
  const auto octants = half_sphere_cells();
  std::array<std::vector<ProofCell>, 4> found;
  tbb::parallel_for(std::size_t{0}, octants.size(),
                    [&](std::size_t k) { found[k] = search.run(octants[k], all); });
  for (const auto& cells : found) proof.cells.insert(proof.cells.end(), cells.begin(), cells.end());
  for (const ProofCell& cell : proof.cells) {
    if (cell.proved) proof.proved_share += cell.cell.share();
  }
  proof.looked_at = search.looked_at();
  proof.complete = !search.stopped();
  return proof;
}

}  // namespace

DirectionProof prove_directions(const ProofPart& part, std::span<const SurfaceElement> points,
                                const ProofTask& task) {
  return prove(part, task, points, nullptr);
}

DirectionProof prove_directions(const ProofPart& part, const SurfacePieces& surface, const ProofTask& task) {
  return prove(part, task, surface.guides, &surface);
}

}  // namespace moldlight
