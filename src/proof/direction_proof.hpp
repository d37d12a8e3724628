// A proof by branch and bound over the half-sphere of directions: which of them surely have at least so much
// undercut, and where that is open, in caps.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "proof/blocked_cone.hpp"
#include "proof/certain_undercut.hpp"
#include "proof/surface_elements.hpp"

namespace moldlight {

struct ProofTask {
  ProofQuery query;
  double bound = 0.0;  // undercut area to be proved, model units squared
  /// Cells of less than twice this radius are not divided any more; in a neighbourhood with far less undercut
  /// than the bound, cells of less than 2.5 degrees.
  double finest_deg = 0.15;
  /// A triangle is not cut any more when it is smaller (unit frame), or much smaller than the
  /// cell's cone is wide where something hides it.
  double finest_length = 1e-3;
  /// Asked between cells, from any thread; once it says true what is open stays open.
  std::function<bool()> stop = {};
  /// Called with the share of the half-sphere that is not decided yet, [0, 1], one call at a time.
  std::function<void(double open_share)> progress = {};
};

/// A cell that was not divided any more.
struct ProofCell {
  SphereCell cell;
  /// Undercut area that every direction of it has at the least, model units squared; a little more than was
  /// asked for where it is proved.
  double bound = 0.0;
  bool proved = false;
};

struct DirectionProof {
  double bound = 0.0;                 // of all cells that are proved
  std::vector<ProofCell> cells = {};  // tile the half-sphere
  std::size_t looked_at = 0;          // cells, divided ones included
  double proved_share = 0.0;          // of the half-sphere
  bool complete = true;               // not stopped
};

/// Proves it for points, with the sampling error that they have. Exact regions with the same tau and lateral
/// tolerance never have less undercut in a proved cell, but for that error. Uses all cores of the calling
/// thread's TBB arena; the result is the same to the bit for any number of threads, unless it was stopped.
/// For a part that has bodies which are inside out nothing is certain.
[[nodiscard]] DirectionProof prove_directions(const ProofPart& part, std::span<const SurfaceElement> points,
                                              const ProofTask& task);

/// Proves it for the surface itself, in the same way but without sampling error: pieces count, and the guides
/// only show where to look at them.
[[nodiscard]] DirectionProof prove_directions(const ProofPart& part, const SurfacePieces& surface,
                                              const ProofTask& task);

/// All directions within `radius_deg` of `direction` (unit, z >= 0) or of its opposite.
struct DirectionCap {
  glm::dvec3 direction{0, 0, 1};
  double radius_deg = 0.0;
  double share = 0.0;  // of the half-sphere: the cells in it
  double bound = 0.0;  // the least of its cells, model units squared
};

/// Caps that contain all cells which are not proved, largest share first. Cells that touch are in one cap,
/// across the equator, too, unless a few smaller caps hold them much more tightly.
[[nodiscard]] std::vector<DirectionCap> open_caps(std::span<const ProofCell> cells);

}  // namespace moldlight
