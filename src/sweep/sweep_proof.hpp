// The proof of a sweep: what all directions have, those that were not tried included.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "mold/direction.hpp"
#include "proof/direction_proof.hpp"
#include "sweep/sweep_settings.hpp"

namespace moldlight {

/// A cap of directions that the proof left open; `undercut` by exact regions at its middle, where it was
/// measured.
struct OpenCap {
  DirectionCap cap;
  std::optional<double> undercut = {};
};

/// Every direction outside of the open caps has an undercut of at least `bound`; model units squared. For
/// the grade of samples the bound is one for the scoring samples: the surface may differ by the error.
struct SweepProof {
  ProofGrade grade = ProofGrade::samples;
  double epsilon = 0.0;                   // area that was asked for
  double bound = 0.0, bound_error = 0.0;  // error: 95 % level
  double proved_share = 0.0;              // of the half-sphere
  std::vector<OpenCap> open;              // largest first
  std::size_t looked_at = 0;              // cells
  double elapsed_s = 0.0;
  bool complete = true;  // no limit ended it
  /// Complete, and what is open lies around directions that are listed, as near as the list's own spacing.
  bool holds = false;
  std::vector<ProofCell> cells;

  /// The bound that was proved for a unit direction or its opposite; none where it is open.
  [[nodiscard]] std::optional<double> bound_at(const glm::dvec3& direction) const {
    const glm::dvec3 turned = half_sphere(direction);
    const auto cell = std::ranges::find_if(
        cells, [&](const ProofCell& each) { return each.proved && each.cell.contains(turned); });
    return cell == cells.end() ? std::nullopt : std::optional(std::max(cell->bound, bound));
  }
};

}  // namespace moldlight
