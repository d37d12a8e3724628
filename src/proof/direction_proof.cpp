#include "proof/direction_proof.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <deque>
#include <mutex>
#include <queue>
#include <utility>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "mesh/orient.hpp"

namespace moldlight {

namespace {

/// Of the half width of a cell's cone where something hides an element: for shorter elements the quarters of
/// the cell do more than a cut.
constexpr double k_worth_cutting = 2.0;

/// A cell is left open at once below this radius where so much less than the bound is hidden in its middle,
/// in those of the two that it came from, and at its corners: it is likely to be free as a whole.
constexpr double k_little = 0.5, k_calm_deg = 2.5;
constexpr int k_calm_generations = 3;

/// Elements between two looks whether to stop.
constexpr std::size_t k_between_looks = 64;

using Elements = std::vector<const SurfaceElement*>;

/// What a cell hands on to its quarters.
struct Inherited {
  double certain = 0.0;  // area
  Elements open;         // not certain yet
  int calm = 0;          // cells on the way here, the last ones, in which little was hidden
};

/// What is known of a cell.
struct CellState {
  Inherited to_hand_on;
  double hidden = 0.0;             // area that is hidden in the cell's middle, but not certain
  std::deque<SurfaceElement> cut;  // what came from cuts here
};

class Search {
 public:
  Search(const ProofPart& part, const ProofTask& task)
      : task_(task), testers_([&part, query = task.query] { return CertainUndercut(part, query); }) {}

  std::vector<ProofCell> run(const SphereCell& cell, const Inherited& inherited);

  [[nodiscard]] std::size_t looked_at() const { return looked_at_; }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  /// Asks, and stays so.
  bool is_stopped() {
    if (task_.stop && task_.stop()) stopped_ = true;
    return stopped_;
  }
  [[nodiscard]] bool enough(const CellState& state) const { return state.to_hand_on.certain >= task_.bound; }
  void find_certain(const SphereCell& cell, const Elements& open, CellState& state);
  [[nodiscard]] bool little_at_corners(const SphereCell& cell, const Inherited& known);
  void cut_elements(const SphereCell& cell, std::vector<std::pair<const SurfaceElement*, double>> hidden,
                    CellState& state);
  [[nodiscard]] std::vector<ProofCell> end(const SphereCell& cell, double certain, bool proved);

  const ProofTask& task_;
  tbb::enumerable_thread_specific<CertainUndercut> testers_;
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
  if (is_stopped()) return end(cell, inherited.certain, inherited.certain >= task_.bound);
  ++looked_at_;
  CellState state;
  Inherited& next = state.to_hand_on;
  next.certain = inherited.certain;
  find_certain(cell, inherited.open, state);
  if (enough(state)) return end(cell, next.certain, true);
  if (stopped_) return end(cell, next.certain, false);  // elements were left out
  const bool little = next.certain + state.hidden < k_little * task_.bound;
  next.calm = little ? inherited.calm + 1 : 0;
  const bool calm =
      next.calm >= k_calm_generations && cell.radius_deg() < k_calm_deg && little_at_corners(cell, next);
  if (calm || cell.radius_deg() < 2.0 * task_.finest_deg) return end(cell, next.certain, false);
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
    for (const SurfaceElement* element : known.open) {
      if (tester.ask(*element, small).hidden_at_centre) hidden += element->area;
      if (hidden >= k_little * task_.bound) return false;
    }
  }
  return true;
}

/// Until there are enough; what is hidden in the middle of the cell comes first in its quarters.
void Search::find_certain(const SphereCell& cell, const Elements& open, CellState& state) {
  CertainUndercut& tester = testers_.local();
  std::vector<std::pair<const SurfaceElement*, double>> hidden;
  Elements free;
  for (std::size_t k = 0; k < open.size(); ++k) {
    if (enough(state) || (k % k_between_looks == 0 && is_stopped())) return;
    const ElementAnswer answer = tester.ask(*open[k], cell);
    if (answer.certain_area > 0.0) {
      state.to_hand_on.certain += answer.certain_area;
    } else if (answer.hidden_at_centre) {
      state.hidden += open[k]->area;
      hidden.emplace_back(open[k], answer.distance);
    } else {
      free.push_back(open[k]);
    }
  }
  cut_elements(cell, std::move(hidden), state);
  state.to_hand_on.open.insert(state.to_hand_on.open.end(), free.begin(), free.end());
}

/// Large ones first.
void Search::cut_elements(const SphereCell& cell,
                          std::vector<std::pair<const SurfaceElement*, double>> hidden, CellState& state) {
  CertainUndercut& tester = testers_.local();
  for (std::size_t k = 0; k < hidden.size(); ++k) {
    if (k % k_between_looks == 0 && is_stopped()) return;
    const auto [element, distance] = hidden[k];
    const double least = std::max(task_.finest_length, k_worth_cutting * distance * cell.radius_rad());
    if (element->is_point || element->length <= least || enough(state)) {
      state.to_hand_on.open.push_back(element);
      continue;
    }
    for (const SurfaceElement& half : halves(*element)) {
      const ElementAnswer answer = tester.ask(half, cell);
      if (answer.certain_area > 0.0) {
        state.to_hand_on.certain += answer.certain_area;
        continue;
      }
      state.cut.push_back(half);
      if (answer.hidden_at_centre) {
        hidden.emplace_back(&state.cut.back(), answer.distance);
      } else {
        state.to_hand_on.open.push_back(&state.cut.back());
      }
    }
  }
}

}  // namespace

DirectionProof prove_directions(const ProofPart& part, std::span<const SurfaceElement> elements,
                                const ProofTask& task) {
  DirectionProof proof;
  proof.bound = task.bound;
  // A ray that enters the solid leaves it again, unless the ray began inside of a body that is inside out.
  TriangleMesh outward = part.mesh;
  Inherited all;
  if (turn_if_inside_out(outward).facets == 0) {
    for (const SurfaceElement& element : elements) all.open.push_back(&element);
  }
  Search search(part, task);
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

}  // namespace moldlight
