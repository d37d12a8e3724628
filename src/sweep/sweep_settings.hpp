// Everything a user can set about a sweep of directions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/action_settings.hpp"
#include "classify/option.hpp"
#include "classify/settings.hpp"
#include "sweep/candidates/candidate.hpp"

namespace moldlight {

/// How directions are scored before the best are measured: by exact rays from surface samples on the
/// processor, or by shadow maps on the GL, in batches.
enum class SweepEngine : std::uint8_t { rays, gl };

/// What directions are listed by: as a mold maker weighs them (sweep/mold_rank), or by the objective.
enum class SweepRank : std::uint8_t { mold, objective };

/// What a proof counts: the samples that score directions, or the surface itself, in pieces of facets.
enum class ProofGrade : std::uint8_t { samples, area };

struct DirectionFigure;

/// What directions are ranked by, smallest first: a weighted sum of figures, each divided by the part's own
/// measure of it (area for areas, diagonal for lengths).
struct Objective {
  struct Term {
    const DirectionFigure* figure;
    double weight;  // greater than 0

    bool operator==(const Term&) const = default;
  };
  std::string text;  // as it was written
  std::vector<Term> terms;

  bool operator==(const Objective&) const = default;
};
/// Parses "undercut", "draw-depth" or "undercut:1,draw-depth:0.1"; throws UsageError.
[[nodiscard]] Objective parse_objective(std::string_view text);

struct SweepSettings {
  MethodSettings method;  // of the final figures
  int directions = 500;   // uniform directions over the half-sphere, [0, 100000]
  std::vector<CandidateKind> kinds = all_candidate_kinds();  // sources of candidates
  std::vector<glm::dvec3> user_directions;                   // any length but zero
  int refine = 8;                                            // best basins to refine, [0, 100]
  double apart_deg = 3.0;  // a direction so near to a better one is not listed, save exact ties, [0, 45]
  int top = 10;            // directions that get final figures, [1, 1000]
  SweepEngine engine = SweepEngine::rays;
  int scoring_samples = 10'000;  // surface samples for scoring, [1000, 10000000]
  int scoring_resolution = 512;  // map resolution for scoring, [64, 8192]
  bool thorough = false;         // score every direction to the end, also one that cannot be listed
  double tilt_growth_pct =
      0.1;  // growth of the undercut that ends a tilt margin, per cent of the part's area, (0, 100]
  bool actions = false;  // find the side actions of what is listed, also where the objective needs none
  ActionSettings action_settings = {};
  double pressure = 0.0;  // cavity pressure for the clamp force, force per area unit of the part; 0: none
  SweepRank rank = SweepRank::mold;
  /// By which a direction found by search must beat a canonical one beside it, per cent of the part's area in
  /// undercut, [0, 100].
  double worth_pct = 0.5;
  Objective objective = parse_objective("undercut");
  /// Prove that no direction has less than the best by more than this, per cent of the part's area, [0, 100].
  std::optional<double> prove_pct = {};
  /// Find all directions of at most so much undercut, per cent of the part's area, [0, 100].
  std::optional<double> all_free_pct = {};
  ProofGrade proof_grade = ProofGrade::samples;
  double proof_limit_s = 0.0;  // for all that is proved; 0: none
  int jobs = 0;                // threads, 0: all cores, [0, 256]
  double time_limit_s = 0.0;   // 0: none

  bool operator==(const SweepSettings&) const = default;
};

/// The options of a sweep that are not options of the method.
[[nodiscard]] std::span<const Option<SweepSettings>> sweep_options();

}  // namespace moldlight
