// All candidate directions of a part, from all sources, near duplicates merged.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "sweep/candidates/candidate.hpp"

namespace moldlight {

struct CandidateOptions {
  /// The sources that are asked. Directions of the user count whether `user` is listed or not.
  std::vector<CandidateKind> kinds = all_candidate_kinds();
  std::size_t uniform_count = 500;
  std::size_t most_per_kind = 40;     // of revolution, plane, perpendicular and hull each
  std::vector<glm::dvec3> user = {};  // any length but zero
  double merge_deg = 0.02;
};

/// Reports the stage "candidates" between sources. The result depends on the part and the options alone; see
/// merge_candidates for its order. Empty only if nothing was asked for.
[[nodiscard]] std::vector<Candidate> find_candidates(const PartModel& model, const CandidateOptions& options,
                                                     const Progress& progress);

}  // namespace moldlight
