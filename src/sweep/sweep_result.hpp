// The result of a sweep. Lengths and areas are in the part's unit.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/classification.hpp"
#include "parting/line_figures.hpp"
#include "sweep/candidates/candidate.hpp"
#include "sweep/direction_actions.hpp"
#include "sweep/mold_rank.hpp"
#include "sweep/sweep_proof.hpp"
#include "sweep/sweep_settings.hpp"

namespace moldlight {

/// One scored direction, for the direction sphere and the CSV.
struct EvaluatedDirection {
  glm::dvec3 direction{0, 0, 1};
  CandidateKind kind = CandidateKind::uniform;
  double undercut = 0.0;
  double undercut_error = 0.0;  // 95 % level
  bool given_up = false;        // scored only until it was certain not to be listed: the figures are rough
};

struct SweepResult;

/// What a sweep shows while it runs, from its own threads, one call at a time.
struct SweepListener {
  std::function<void(const EvaluatedDirection&)> evaluated;
  /// By rank as molds go, once: the best of those that the part's shape names, before others are looked at.
  std::function<void(SweepResult)> named = {};
};

/// How far the pull may lean before the undercut grows by more than the settings' share of the part's area.
inline constexpr double k_widest_tilt_deg = 30.0;
struct TiltMargin {
  double deg = 0.0;            // towards the least tolerant side, [0, k_widest_tilt_deg]
  glm::dvec3 toward{0, 0, 1};  // unit direction at that lean, just past the margin
  /// Nothing wider was looked at: `toward` is the direction itself.
  [[nodiscard]] bool at_least() const { return deg >= k_widest_tilt_deg; }
};

/// An axis of the part within the required draft of a direction, with the figures that it would have.
struct AxisBeside {
  glm::dvec3 direction{0, 0, 1};  // unit, on the side of the direction listed
  std::string reason;             // as a candidate's
  double angle_deg = 0.0;
  Classification classification;  // facet fractions are dropped
};

/// The direction that a listed one stands for, or that stands for it where it is not worth it: within 10
/// degrees of each other, one canonical and one found by search.
struct BesideDirection {
  glm::dvec3 direction{0, 0, 1};  // unit, on the side of the direction listed
  std::string name = {};
  double angle_deg = 0.0;
  double undercut = 0.0;                         // area
  std::optional<DirectionActions> actions = {};  // where they were found
  std::optional<double> climb = {};              // of the outer parting line, where it was found
};

struct SweepCandidate {
  std::size_t rank = 0;       // 1 is best
  std::size_t tie_group = 0;  // 1 is the best direction's
  std::string tie;            // a letter for every group of more than one direction
  Candidate candidate;
  /// False where the sweep was cancelled before: areas and their uncertainty are the scoring's, and
  /// undercuts, the projected undercut and the parts of the uncertainty are not known.
  bool measured = true;
  Classification classification;               // exactly what classify gives; facet fractions are dropped
  std::vector<std::optional<double>> figures;  // a value a row of direction_figures(); none: not known
  std::optional<UndercutTotals> undercuts;     // empty where it was not measured, or the sweep ended before
  std::optional<DirectionActions> actions;     // empty where they were not looked for
  std::optional<LineFigures> line;             // of the parting line; empty where it was not looked for
  std::optional<TiltMargin> tilt;              // empty where the sweep ended before
  std::optional<AxisBeside> axis;              // where there is one beside it, and time was left
  bool pareto = false;
  std::optional<MoldCost> cost;           // where its side actions and line were found, by rank as molds go
  std::vector<std::string> rank_reasons;  // what speaks against it beside the one before, by rank as molds go
  std::optional<BesideDirection> beside;
};

/// What a mold maker would take.
struct Recommendation {
  glm::dvec3 direction{0, 0, 1};  // unit; the core is on its side
  std::string name = {};          // the canonical one, else in words
  std::string why = {};
  std::optional<BesideDirection> beside = {};
  bool provisional = false;  // made before all was found
};

struct SweepResult {
  SweepSettings settings;
  std::string engine;  // the one that scored, and why it was taken
  int jobs = 1;
  std::vector<EvaluatedDirection> evaluated;  // in order of evaluation, the same for every number of jobs
  std::size_t with_actions = 0;               // directions whose side actions were found
  std::size_t skipped = 0;  // candidates that could not get into the list and were not looked at closer
  bool complete = true;
  double elapsed_s = 0.0;
  std::vector<SweepCandidate> candidates;     // best first
  std::optional<Recommendation> recommended;  // where directions are ranked as molds go
  std::optional<SweepProof> proof;            // that nothing is better than the best, where it was asked for
  std::optional<SweepProof> all_free;         // of all directions that are as good as was asked for
  std::vector<std::string> remarks;           // for the user
};

}  // namespace moldlight
