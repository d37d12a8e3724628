// What a split mesh and the borders in it have to be, measured against the part and piece by piece.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mold/exact/exact_regions.hpp"
#include "support/exact_model.hpp"

namespace moldlight::test {

/// How far a split mesh is from what it should be. Shares of the part's diagonal, area or volume.
struct SplitFaults {
  std::vector<std::string> sentences;  // what is wrong as such, at most a few
  std::size_t unmatched_edges = 0;     // directed edges over those that run the other way
  double unmatched_length = 0.0;       // of these, less that of the part itself
  double area = 0.0, volume = 0.0;     // part less pieces
  double facet_area = 0.0;             // of the facet where it is worst, wound pieces counting less
  double region_area = 0.0;            // pieces less areas, of the region where it is worst
  double fractions = 0.0;              // the same of a facet's regions
  double outside = 0.0;                // of a corner of a piece from its source facet
  double turned = 0.0;                 // height of a piece that is wound the other way
};
[[nodiscard]] SplitFaults split_faults(const ExactModel& model, const ExactSplit& split);

/// Expects all of that to be none: 1e-10, edges unmatched only where the part's are.
void expect_sound_split(const ExactModel& model, const ExactSplit& split, const std::string& name);

/// Expects the borders to be exactly the edges between two pieces of different regions, in chains that run
/// on through every vertex where just two of them meet.
void expect_whole_borders(const SplitMesh& mesh, const std::string& name);

/// Rays from inside pieces, half of them chosen by area, half at random among those that are no slivers.
struct RayVerdicts {
  std::size_t pieces = 0, unclear = 0;
  std::vector<std::string> wrong;
};
[[nodiscard]] RayVerdicts ray_verdicts(const ExactModel& model, const SplitMesh& mesh,
                                       const glm::dvec3& direction, const ShapeSettings& settings,
                                       std::size_t pieces, std::uint32_t seed);

}  // namespace moldlight::test
