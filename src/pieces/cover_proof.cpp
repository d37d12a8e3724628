#include "pieces/cover_proof.hpp"

#include <algorithm>
#include <numeric>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "mesh/orient.hpp"
#include "pieces/direction_cover.hpp"

namespace moldlight {

namespace {

constexpr int k_first_divisions = 2;  // of the octants
constexpr std::size_t k_covers = 6;   // that are divided before the table of a search is made anew
constexpr std::size_t k_nodes_of_others = 100;
constexpr std::size_t k_proof_nodes = 25'000;  // of all searches for one number of directions

class CellCover {
 public:
  CellCover(const ProofPart& part, std::span<const SurfaceElement> elements, const CoverProofTask& task,
            const Progress& progress)
      : elements_(elements),
        task_(task),
        progress_(progress),
        testers_([&part, query = task.query] { return CertainUndercut(part, query); }) {
    BitSet all(elements.size());
    for (std::size_t k = 0; k < elements.size(); ++k) all.set(k);
    for (const SphereCell& cell : half_sphere_cells()) {
      const auto& [a, b, c] = cell.corners();
      for (const SphereCell& half : {cell, SphereCell({-c, -b, -a})}) add(half, all);
    }
    for (int k = 0; k < k_first_divisions; ++k) {
      std::vector<std::size_t> every(cells_.size());
      std::iota(every.begin(), every.end(), std::size_t{0});
      divide(every);
    }
  }

  CoverProof run();

 private:
  void add(const SphereCell& cell, const BitSet& parent) {
    cells_.push_back(cell);
    possible_.push_back(parent);
  }
  void divide(const std::vector<std::size_t>& divided);
  [[nodiscard]] bool excludes(std::size_t most, std::vector<OpenCell>& open);

  std::span<const SurfaceElement> elements_;
  const CoverProofTask& task_;
  const Progress& progress_;
  tbb::enumerable_thread_specific<CertainUndercut> testers_;
  std::vector<SphereCell> cells_;  // tile the sphere
  std::vector<BitSet> possible_;   // elements that some direction of the cell may release
};

/// Puts quarters in the places of these cells; they test what their cells may release.
void CellCover::divide(const std::vector<std::size_t>& divided) {
  std::vector<std::size_t> made;
  for (const std::size_t c : divided) {
    const auto quarters = cells_[c].quarters();
    const BitSet parent = possible_[c];
    cells_[c] = quarters[0];
    made.push_back(c);
    for (std::size_t k = 1; k < quarters.size(); ++k) {
      made.push_back(cells_.size());
      add(quarters[k], parent);
    }
  }
  tbb::parallel_for(std::size_t{0}, made.size(), [&](std::size_t k) {
    CertainUndercut& tester = testers_.local();
    BitSet& possible = possible_[made[k]];
    const BitSet parent = possible;
    parent.for_each([&](std::size_t element) {
      if (!progress_.cancelled() && tester.blocked_along(elements_[element], cells_[made[k]]))
        possible.reset(element);
    });
  });
  if (progress_.cancelled()) throw Cancelled();
}

bool CellCover::excludes(std::size_t most, std::vector<OpenCell>& open) {
  const std::vector<SampleGroup> groups = {{.first = 0, .count = elements_.size(), .spare = task_.spare}};
  for (std::size_t nodes_left = k_proof_nodes; nodes_left > 0;) {
    std::vector<std::size_t> all(cells_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    CoverSearch search({groups, possible_}, all, progress_);
    CoverChoice choice = {.most = most, .most_nodes = nodes_left};
    std::vector<std::size_t> divided;
    for (std::size_t k = 0; k < k_covers; ++k) {
      const DirectionCover cover = search.find(choice);
      if (!cover.found && k == 0) return cover.complete;
      if (!cover.found) break;
      nodes_left -= std::min(nodes_left, cover.nodes);
      double widest = 0.0;
      for (const std::size_t c : cover.columns) widest = std::max(widest, cells_[c].radius_deg());
      if (k == 0) open.clear();
      for (const std::size_t c : cover.columns) {
        if (k == 0) open.push_back({cells_[c].centre(), cells_[c].radius_deg()});
        if (cells_[c].radius_deg() > 0.6 * widest) divided.push_back(c);
      }
      if (k == 0 &&
          (widest < 2.0 * task_.finest_deg || cells_.size() + 3 * divided.size() > task_.most_cells))
        return false;
      // Others beside it, which have to be divided as well, cost no new table.
      choice.without.insert(choice.without.end(), cover.columns.begin(), cover.columns.end());
      choice.most_nodes = std::min(nodes_left, k_nodes_of_others);
    }
    divide(divided);
    progress_.report("proving", static_cast<double>(cells_.size()) / static_cast<double>(task_.most_cells));
  }
  return false;
}

CoverProof CellCover::run() {
  CoverProof proof;
  for (std::size_t most = task_.most; most > 0; --most) {
    std::vector<OpenCell> open;
    if (excludes(most, open)) {
      proof.excluded = most;
      break;
    }
    proof.open = std::move(open);
  }
  proof.cells = cells_.size();
  return proof;
}

}  // namespace

CoverProof prove_cover(const ProofPart& part, std::span<const SurfaceElement> elements,
                       const CoverProofTask& task, const Progress& progress) {
  // A ray that enters the solid leaves it again, unless the ray began inside of a body that is inside out.
  TriangleMesh outward = part.mesh;
  if (elements.empty() || task.most == 0 || turn_if_inside_out(outward).facets != 0) return {};
  return CellCover(part, elements, task, progress).run();
}

}  // namespace moldlight
