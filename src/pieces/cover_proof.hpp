// That fewer directions cannot do, whatever they are: covers by whole cells of the sphere of directions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "proof/certain_undercut.hpp"
#include "proof/surface_elements.hpp"

namespace moldlight {

struct CoverProofTask {
  ProofQuery query;
  std::size_t most = 1;           // so many directions are to be excluded
  std::size_t spare = 0;          // so many elements may be left
  double finest_deg = 0.3;        // cells of less than twice this radius are not divided any more
  std::size_t most_cells = 6000;  // then what is open stays open
};

/// A cap of directions that the proof could not exclude.
struct OpenCell {
  glm::dvec3 direction{0, 0, 1};
  double radius_deg = 0.0;
};

struct CoverProof {
  std::size_t excluded = 0;         // so many directions do not release all but `spare` of the elements
  std::size_t cells = 0;            // that tile the sphere in the end
  std::vector<OpenCell> open = {};  // one more than `excluded` of them might; empty where `most` is excluded
};

/// A cell of directions cannot release what is blocked for all of them (CertainUndercut::blocked_along).
/// Where no `most` cells together can release enough, no `most` directions can; else the cells that might are
/// divided. Where that does not come to an end, fewer are tried. Holds for the elements; the same for any
/// number of threads. Throws Cancelled.
[[nodiscard]] CoverProof prove_cover(const ProofPart& part, std::span<const SurfaceElement> elements,
                                     const CoverProofTask& task, const Progress& progress);

}  // namespace moldlight
