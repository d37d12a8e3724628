// How what a sweep found is written for people: in remarks, in the table and on pictures.
#pragma once

#include <string>
#include <vector>

#include "classify/part_model.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// What speaks for a candidate, the strongest of each kind, so many at most, and how many more there are.
[[nodiscard]] std::string reasons_text(const Candidate& candidate, std::size_t most = 3);
/// The same in ever fewer words, for where there is little room.
[[nodiscard]] std::vector<std::string> shorter_reasons(const Candidate& candidate);

/// "2 slides, 1 lifter; 12.3 mm² unreleased"; empty where side actions were not looked for.
[[nodiscard]] std::string side_actions_text(const PartModel& model, const SweepCandidate& candidate);

/// "1 slide, planar parting line", "two-plate, parting line climbs 14 mm": what a mold along it is like,
/// as far as it is known.
[[nodiscard]] std::string mold_text(const PartModel& model, const SweepCandidate& candidate);

/// Remarks on a sweep: by how much the best is better, ties, the directions that the user gave. Sentences on
/// the ranked candidates; none without a candidate.
[[nodiscard]] std::vector<std::string> sweep_remarks(const PartModel& model, const SweepResult& result);

[[nodiscard]] double undercut_area(const SweepCandidate& candidate);

/// "proved: at least 12.3 mm²": of a proof for a unit direction.
[[nodiscard]] std::string proof_text(const PartModel& model, const SweepProof& proof,
                                     const glm::dvec3& direction);
/// What a proof leaves proved of all directions, in a sentence or two.
[[nodiscard]] std::string proved_text(const PartModel& model, const SweepProof& proof);

}  // namespace moldlight
