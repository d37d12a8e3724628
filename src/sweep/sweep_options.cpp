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
       "How many of the best scored directions, apart from each other, are followed downhill; of what is "
       "measured then, three at most are followed once more, by exact figures.",
       IntegerKind<S>{&S::refine, 0, 100}},
      {"top", "--top", "Directions listed", "", "How many directions get final figures.",
       IntegerKind<S>{&S::top, 1, 1000}},
      {"apart_deg", "--apart", "Apart", "deg",
       "A direction that is nearer than this to a better one is not listed, unless it ties with it and comes "
       "from a feature of the part.",
       RealKind<S>{&S::apart_deg, 0.0, 45.0, 0.5}},
      {"engine", "--engine", "Engine", "",
       "How directions are scored before the best are measured: by exact rays from surface samples, or by "
       "shadow maps on the GL, many directions at a time.",
       choice<&S::engine>({"rays", "gl"})},
      {"scoring_samples", "--scoring-samples", "Scoring samples", "",
       "Surface samples by which a direction is scored.",
       IntegerKind<S>{&S::scoring_samples, 1000, 10'000'000}},
      {"scoring_resolution", "--scoring-resolution", "Scoring resolution", "texel",
       "Width and height of the shadow maps by which a direction is scored.",
       IntegerKind<S>{&S::scoring_resolution, 64, 8192}},
      {"thorough", "--thorough", "Score all to the end", "",
       "Score every direction to the end, also one that is certain not to be listed.",
       SwitchKind<S>{&S::thorough}},
      {"tilt_growth_pct", "--tilt-growth", "Tilt growth", "% of the part's area",
       "Growth of the undercut area that ends the tilt margin.",
       RealKind<S>{&S::tilt_growth_pct, 1e-4, 100.0, 0.1}},
      {"pressure", "--pressure", "Pressure", "force per area",
       "Cavity pressure; times the projected area it gives the clamp force.",
       RealKind<S>{&S::pressure, 0.0, 1e12, 1.0}},
      {"actions", "--actions", "Side actions", "",
       "Find the side actions of the directions listed, which takes longer than the rest of a sweep; of "
       "directions that tie, those of the least weight come first.",
       SwitchKind<S>{&S::actions}},
      {"prove", "--prove", "Prove the best", "",
       "Prove that no direction, tried or not, has less undercut than the best by more than EPS per cent of "
       "the part's area (0.1% if EPS is left out).",
       share_or_off<&S::prove_pct>("--prove", "0.1%")},
      {"all_free", "--all-free", "All nearly free", "",
       "Find caps that hold every direction of at most EPS per cent undercut (0.5% if EPS is left out).",
       share_or_off<&S::all_free_pct>("--all-free", "0.5%")},
      {"proof", "--proof", "Proof by", "",
       "What is proved: for the scoring samples, in about the time of a sweep and with their sampling error, "
       "or by area for the surface itself, which takes a few times as long.",
       choice<&S::proof_grade>({"samples", "area"})},
      {"proof_limit_s", "--proof-limit", "Proof limit", "s",
       "End what is proved after this time, all of it together; what is open by then stays open. 0 for none.",
       RealKind<S>{&S::proof_limit_s, 0.0, 1e9, 1.0}},
      {"jobs", "--jobs", "Threads", "", "Threads that score directions; 0 takes all cores.",
       IntegerKind<S>{&S::jobs, 0, 256}},
      {"time_limit_s", "--time-limit", "Time limit", "s",
       "End after this time with what is done; 0 for none.", RealKind<S>{&S::time_limit_s, 0.0, 1e9, 1.0}},
      {"objective", "--objective", "Best is the least", "",
       "What to rank by, smallest first: one of these, or a weighted sum of shares of the part, as "
       "undercut:1,draw-depth:0.1. Side actions and their travel are found for twice as many directions as "
       "are listed, those of the least undercut.",
       TextKind<S>{"LIST", [](const S& s) { return s.objective.text; },
                   [](S& s, std::string_view text) {
                     s.objective = parse_objective(text);
                     s.rank = SweepRank::objective;
                   },
                   objective_names()}},
      {"rank", "--rank", "Rank", "",
       "Rank as a mold maker does, by what nothing releases, side actions, parting line, draft, undercut and "
       "depth, in this order, or by the objective alone, which is what naming one or a proof asks for.",
       choice<&S::rank>({"mold", "objective"})},
      {"worth_pct", "--worth", "Worth leaving an axis", "% of the part's area",
       "A direction found by search within 10 degrees of one that the part's shape names must save so much "
       "undercut, or side actions, to be listed in its place.",
       RealKind<S>{&S::worth_pct, 0.0, 100.0, 0.1}},
      {"candidates", "--candidates", "Candidates", "",
       "Sources of candidate directions, separated by commas, or all or none.",
       SetKind<S>{names_of(all_candidate_kinds()), [](const S& s) { return names_of(s.kinds); },
                  [](S& s, const Words& names) { s.kinds = kinds_named(names); }}},
      {"user_directions", "--direction", "Directions given", "",
       "A direction to look at and list beside the others; may be given several times.",
       DirectionsKind<S>{&S::user_directions}},
  };
  return k_options;
}

}  // namespace moldlight
