#include "sweep/direction_figures.hpp"

namespace moldlight {

namespace {

Words names_of(const std::vector<CandidateKind>& kinds) {
  Words names;
  for (const CandidateKind kind : kinds) names.push_back(candidate_kind_name(kind));
  return names;
}

std::vector<CandidateKind> kinds_named(const Words& names) {
  std::vector<CandidateKind> kinds;
  for (const std::string_view name : names) {
    for (const CandidateKind kind : all_candidate_kinds()) {
      if (candidate_kind_name(kind) == name) kinds.push_back(kind);
    }
  }
  return kinds;
}

/// "off", or per cent of the part's area as "0.5%" or "0.5".
template <std::optional<double> SweepSettings::*k_member>
TextKind<SweepSettings> share_or_off(std::string_view flag, std::string_view bare) {
  const auto get = [](const SweepSettings& s) {
    return s.*k_member ? real_text(*(s.*k_member)) + "%" : std::string("off");
  };
  static const std::string_view k_flag = flag;
  const auto set = [](SweepSettings& s, std::string_view text) {
    if (text == "off") {
      s.*k_member = std::nullopt;
      return;
    }
    if (text.ends_with('%')) text.remove_suffix(1);
    s.*k_member = parse_real({text, k_flag}, 0.0, 100.0);
  };
  return {.name = "[EPS%]", .get = get, .set = set, .words = {"off", "0.1%", "0.5%", "2%"}, .bare = bare};
}

}  // namespace

std::span<const Option<SweepSettings>> sweep_options() {
  using S = SweepSettings;
  static const std::vector<Option<S>> k_options = {
      {"directions", "--directions", "Uniform directions", "",
       "Number of directions spread evenly over the half-sphere.",
       IntegerKind<S>{&S::directions, 0, 100'000}},
      {"refine", "--refine", "Directions to refine", "",
       "Number of scored directions that are refined. At most three of these are refined once more, by exact "
       "figures.",
       IntegerKind<S>{&S::refine, 0, 100}},
      {"top", "--top", "Directions listed", "", "Number of listed directions, with exact figures.",
       IntegerKind<S>{&S::top, 1, 1000}},
      {"apart_deg", "--apart", "Apart", "deg",
       "Least angle between listed directions. A tied direction along a feature of the part may be closer.",
       RealKind<S>{&S::apart_deg, 0.0, 45.0, 0.5}},
      {"engine", "--engine", "Engine", "",
       "Score directions by exact rays from surface samples, or by shadow maps on the GPU, many directions "
       "at a time.",
       choice<&S::engine>({"rays", "gl"})},
      {"scoring_samples", "--scoring-samples", "Scoring samples", "",
       "Number of surface samples that score a direction.",
       IntegerKind<S>{&S::scoring_samples, 1000, 10'000'000}},
      {"scoring_resolution", "--scoring-resolution", "Scoring resolution", "texel",
       "Width and height of the shadow maps that score a direction.",
       IntegerKind<S>{&S::scoring_resolution, 64, 8192}},
      {"thorough", "--thorough", "Score all to the end", "",
       "Score every direction with all samples, even if it cannot be listed.", SwitchKind<S>{&S::thorough}},
      {"tilt_growth_pct", "--tilt-growth", "Tilt growth", "% of the part's area",
       "Growth of the undercut area that ends the tilt margin.",
       RealKind<S>{&S::tilt_growth_pct, 1e-4, 100.0, 0.1}},
      {"pressure", "--pressure", "Pressure", "force per area",
       "Cavity pressure, in force per square of the part's unit: MPa for a part in mm, which gives the clamp "
       "force in N.",
       RealKind<S>{&S::pressure, 0.0, 1e12, 1.0}},
      {"actions", "--actions", "Side actions", "",
       "Find the side actions of all listed directions. This takes longer than the rest of the sweep. Ties "
       "are ranked by their weight.",
       SwitchKind<S>{&S::actions}},
      {"prove", "--prove", "Prove the best", "",
       "Prove that no direction is better than the best by more than EPS per cent of the part's area in "
       "undercut. The default of EPS is 0.1%.",
       share_or_off<&S::prove_pct>("--prove", "0.1%")},
      {"all_free", "--all-free", "All nearly free", "",
       "Find all directions with at most EPS per cent undercut, as caps around their centres. The default of "
       "EPS is 0.5%.",
       share_or_off<&S::all_free_pct>("--all-free", "0.5%")},
      {"proof", "--proof", "Proof by", "",
       "Prove for the scoring samples, with their sampling error, or for the surface itself. By area takes a "
       "few times as long.",
       choice<&S::proof_grade>({"samples", "area"})},
      {"proof_limit_s", "--proof-limit", "Proof limit", "s",
       "Time limit for all proofs together. What is open by then stays open. 0: no limit.",
       RealKind<S>{&S::proof_limit_s, 0.0, 1e9, 1.0}},
      {"jobs", "--jobs", "Threads", "", "Number of threads. 0: all cores.", IntegerKind<S>{&S::jobs, 0, 256}},
      {"time_limit_s", "--time-limit", "Time limit", "s",
       "Time limit. The sweep ends with the results it has by then. 0: no limit.",
       RealKind<S>{&S::time_limit_s, 0.0, 1e9, 1.0}},
      {"objective", "--objective", "Rank by", "",
       "Rank by one of these figures, smallest first, or by a weighted sum such as "
       "undercut:1,draw-depth:0.1. Side actions are found for twice as many directions as are listed.",
       TextKind<S>{"LIST", [](const S& s) { return s.objective.text; },
                   [](S& s, std::string_view text) {
                     s.objective = parse_objective(text);
                     s.rank = SweepRank::objective;
                   },
                   objective_names()}},
      {"rank", "--rank", "Rank", "",
       "Mold ranks by unreleased surface, side actions, parting line, draft, undercut and depth, in this "
       "order. Objective ranks by --objective alone, and is the default with --objective or a proof.",
       choice<&S::rank>({"mold", "objective"})},
      {"worth_pct", "--worth", "Least gain over an axis", "% of the part's area",
       "A direction found by search within 10° of an axis or face normal of the part replaces it only if it "
       "saves this much undercut, or side actions.",
       RealKind<S>{&S::worth_pct, 0.0, 100.0, 0.1}},
      {"candidates", "--candidates", "Candidates", "",
       "Sources of candidate directions, separated by commas; or all, or none.",
       SetKind<S>{names_of(all_candidate_kinds()), [](const S& s) { return names_of(s.kinds); },
                  [](S& s, const Words& names) { s.kinds = kinds_named(names); }}},
      {"user_directions", "--direction", "Directions given", "",
       "An extra direction to list with the others. May be given several times.",
       DirectionsKind<S>{&S::user_directions}},
  };
  return k_options;
}

}  // namespace moldlight
