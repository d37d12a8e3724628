#include "sweep/candidates/candidate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"

namespace moldlight {
namespace {

bool more_exact(const Candidate& a, const Candidate& b) {
  const CandidateSource &first = a.sources.front(), &second = b.sources.front();
  return first.kind != second.kind ? first.kind < second.kind : first.share > second.share;
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
    std::stable_sort(candidate.sources.begin(), candidate.sources.end(),
                     [](const CandidateSource& a, const CandidateSource& b) { return a.kind < b.kind; });
    if (!candidate.from_user()) candidate.direction = half_sphere(candidate.direction);
  }
  std::stable_sort(candidates.begin(), candidates.end(), more_exact);

  // Members of the uniform set are far apart from one another, so they are compared with the others only.
  std::vector<Candidate> merged;
  std::size_t others = 0;
  for (Candidate& candidate : candidates) {
    const auto end = merged.begin() + static_cast<std::ptrdiff_t>(others);
    const auto same = std::find_if(merged.begin(), end, [&](const Candidate& kept) {
      return line_angle_deg(kept.direction, candidate.direction) <= tolerance_deg;
    });
    if (same != end) {
      same->sources.insert(same->sources.end(), candidate.sources.begin(), candidate.sources.end());
      continue;
    }
    const bool is_uniform = candidate.kind() == CandidateKind::uniform;
    merged.push_back(std::move(candidate));
    if (!is_uniform) others = merged.size();
  }
  return merged;
}

}  // namespace moldlight
