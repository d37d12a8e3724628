// Undercuts and side actions of two revisions, matched by place.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "actions/side_action.hpp"
#include "compare/surface_change.hpp"

namespace moldlight {

/// Changed: of a side action, another kind, direction or travel.
enum class ChangeKind : std::uint8_t { same, added, gone, grown, shrunk, changed };
[[nodiscard]] std::string_view change_name(ChangeKind kind);

/// One of A and one of B, numbers among the undercuts or actions of their plans; none
/// where it is new or gone.
struct MatchedChange {
  ChangeKind kind = ChangeKind::same;
  std::optional<std::size_t> a, b;
};

/// A side of the comparison with its plan.
struct PlannedSide {
  const OverlaySide& side;
  const ActionPlan& plan;
};

/// Undercuts with the most surface in common are one; then those whose centres are within half their size.
/// Grown and shrunk are reported only where surface or regions changed on them, beyond the tolerance. All of
/// A's, in its order, then what is new.
[[nodiscard]] std::vector<MatchedChange> match_undercuts(const PlannedSide& a, const PlannedSide& b,
                                                         const SurfaceChange& surface);

/// Actions that release the same undercuts are one; the same if their kind is, directions are within 2
/// degrees, and travels within the tolerance and what the tessellations may be off, or 1 %.
[[nodiscard]] std::vector<MatchedChange> match_actions(const PlannedSide& a, const PlannedSide& b,
                                                       const std::vector<MatchedChange>& undercuts,
                                                       const SurfaceChange& surface);

}  // namespace moldlight
