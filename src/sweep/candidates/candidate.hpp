// A parting direction worth trying, and why.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "mold/direction.hpp"

namespace moldlight {

/// Where a candidate comes from, the most exact first: of near duplicates the direction of the lowest kind is
/// kept.
enum class CandidateKind : std::uint8_t {
  user,           // given
  axis,           // coordinate axis of the file
  revolution,     // axis of a cylinder, a cone or a hole
  plane,          // normal of the largest planes
  perpendicular,  // perpendicular to much facet area: the walls of a drawn part
  hull,           // normal of a large facet of the convex hull
  principal,      // principal axis of the surface
  refined,        // found downhill from another candidate
  uniform,        // one of a set that covers the half-sphere
};
inline constexpr std::size_t k_candidate_kind_count = 9;

/// "user", "axis", "revolution", "plane", "perpendicular", "hull", "principal", "refined", "uniform".
[[nodiscard]] std::string_view candidate_kind_name(CandidateKind kind);

/// Every source of candidates but the user and what was found from others.
[[nodiscard]] std::vector<CandidateKind> all_candidate_kinds();

struct CandidateSource {
  CandidateKind kind = CandidateKind::uniform;
  std::string reason;  // for the user: "axis of 4 cylinders or cones, 3.1 % of the surface"
  double share = 0.0;  // of the surface that speaks for the direction, [0, 1]; 0 where that means nothing
};

/// What makes a direction canonical: one that the shape of the part names.
struct Canonical {
  std::string name;    // "z", "normal of the largest plane, 38 % of the surface"
  double share = 0.0;  // of the surface that speaks for it, [0, 1]
};

struct Candidate {
  /// Unit. On the half-sphere of half_sphere(); only directions given by the user keep the sense they came
  /// in.
  glm::dvec3 direction{0, 0, 1};
  std::vector<CandidateSource> sources;  // at least one, by kind
  std::optional<Canonical> canonical = {};

  [[nodiscard]] CandidateKind kind() const { return sources.front().kind; }
  [[nodiscard]] bool from_user() const { return kind() == CandidateKind::user; }
  /// Given by the user or by a feature of the part, not by search.
  [[nodiscard]] bool exact() const { return kind() < CandidateKind::refined; }
};

/// One candidate for each set of directions within `tolerance_deg` of the most exact of them, counting d and
/// -d once; it has all their sources. Ordered by kind, then by share, then as they came. The user's comes
/// first, then what is canonical; a canonical one is merged with the user's only where they are the same.
[[nodiscard]] std::vector<Candidate> merge_candidates(std::vector<Candidate> candidates,
                                                      double tolerance_deg);

}  // namespace moldlight
