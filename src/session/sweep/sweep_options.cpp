#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "session/sweep/sweep_settings.hpp"

namespace moldlight {

std::vector<CandidateKind> all_candidate_kinds() {
  return {CandidateKind::axis, CandidateKind::revolution, CandidateKind::plane,  CandidateKind::perpendicular,
          CandidateKind::hull, CandidateKind::principal,  CandidateKind::uniform};
}

std::vector<CandidateKind> parse_candidate_kinds(std::string_view text) {
  const std::vector<CandidateKind> all = all_candidate_kinds();
  if (text == "all") return all;
  if (text == "none") return {};
  std::vector<CandidateKind> kinds;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    const std::string_view name = rest.substr(0, comma);
    const auto kind =
        std::find_if(all.begin(), all.end(), [&](auto k) { return candidate_kind_name(k) == name; });
    if (kind == all.end()) {
      std::string names = "all, none";
      for (const CandidateKind k : all) names += fmt::format(", {}", candidate_kind_name(k));
      throw UsageError(fmt::format("--candidates: '{}' is none of {}", name, names));
    }
    if (std::find(kinds.begin(), kinds.end(), *kind) == kinds.end()) kinds.push_back(*kind);
    if (comma == std::string_view::npos) return kinds;
    rest.remove_prefix(comma + 1);
  }
}

std::span<const Option<SweepSettings>> sweep_options() {
  using S = SweepSettings;
  static const std::vector<Option<S>> k_options = {
      {"directions", "--directions", "Uniform directions", "",
       "Number of directions spread evenly over the half-sphere.",
       IntegerKind<S>{&S::directions, 0, 100'000}},
      {"refine", "--refine", "Basins to refine", "",
       "The best so many separate directions are followed downhill; of what is measured then, the first "
       "three "
       "at most once more, by exact figures.",
       IntegerKind<S>{&S::refine, 0, 100}},
      {"top", "--top", "Directions listed", "", "The best so many directions get final figures.",
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
      {"jobs", "--jobs", "Threads", "", "Threads that score directions; 0 takes all cores.",
       IntegerKind<S>{&S::jobs, 0, 256}},
      {"time_limit_s", "--time-limit", "Time limit", "s",
       "End after so many seconds with what is done; 0 for none.",
       RealKind<S>{&S::time_limit_s, 0.0, 1e9, 1.0}},
  };
  return k_options;
}

}  // namespace moldlight
