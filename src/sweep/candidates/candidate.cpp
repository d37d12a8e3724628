#include "sweep/candidates/candidate.hpp"

#include <algorithm>
#include <array>

#include "base/check.hpp"
#include "mold/direction.hpp"

namespace moldlight {
namespace {

bool more_exact(const Candidate& a, const Candidate& b) {
  const CandidateSource &first = a.sources.front(), &second = b.sources.front();
  if (a.from_user() != b.from_user()) return a.from_user();
  if (a.canonical.has_value() != b.canonical.has_value()) return a.canonical.has_value();
  return first.kind != second.kind ? first.kind < second.kind : first.share > second.share;
}

bool are_one(const Candidate& kept, const Candidate& candidate, double tolerance_deg) {
  const bool given = kept.from_user() && candidate.canonical;
  return line_angle_deg(kept.direction, candidate.direction) <= (given ? k_on_axis_deg : tolerance_deg);
}

}  // namespace

std::string_view candidate_kind_name(CandidateKind kind) {
  static constexpr std::array<std::string_view, k_candidate_kind_count> k_names = {
      "user", "axis", "revolution", "plane", "perpendicular", "hull", "principal", "refined", "uniform"};
  return k_names[static_cast<std::size_t>(kind)];
}

std::vector<CandidateKind> all_candidate_kinds() {
  return {CandidateKind::axis, CandidateKind::revolution, CandidateKind::plane,  CandidateKind::perpendicular,
          CandidateKind::hull, CandidateKind::principal,  CandidateKind::uniform};
}

std::vector<Candidate> merge_candidates(std::vector<Candidate> candidates, double tolerance_deg) {
  for (Candidate& candidate : candidates) {
    CHECK(!candidate.sources.empty());
    std::ranges::stable_sort(candidate.sources, {}, &CandidateSource::kind);
    if (!candidate.from_user()) candidate.direction = half_sphere(candidate.direction);
  }
  std::stable_sort(candidates.begin(), candidates.end(), more_exact);

  // Members of the uniform set are far apart from one another, so they are compared with the others only.
  std::vector<Candidate> merged;
  std::size_t others = 0;
  for (Candidate& candidate : candidates) {
    const auto end = merged.begin() + static_cast<std::ptrdiff_t>(others);
    const auto same = std::find_if(
        merged.begin(), end, [&](const Candidate& kept) { return are_one(kept, candidate, tolerance_deg); });
    if (same != end) {
      if (!same->canonical) same->canonical = candidate.canonical;
      for (CandidateSource& source : candidate.sources) {
        const bool noted = std::ranges::any_of(same->sources, [&](const CandidateSource& other) {
          return other.kind == source.kind && other.reason == source.reason;
        });
        if (!noted) same->sources.push_back(std::move(source));
      }
      continue;
    }
    const bool is_uniform = candidate.kind() == CandidateKind::uniform;
    merged.push_back(std::move(candidate));
    if (!is_uniform) others = merged.size();
  }
  return merged;
}

}  // namespace moldlight
