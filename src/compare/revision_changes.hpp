// What differs between two revisions, one thing after the other, as somebody looks at them: undercuts,
// actions, changed surface; and where each lies.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "compare/compare_picture.hpp"
#include "render/part_view.hpp"

namespace moldlight {

/// What can be looked at.
struct RevisionChange {
  enum class Of : std::uint8_t { place, region, undercut, action } of = Of::place;
  ChangeKind kind = ChangeKind::changed;
  std::size_t number = 0;  // among the comparison's places, changed regions, undercuts, actions
  Bounds bounds;           // A's unit

  [[nodiscard]] bool changed() const { return kind != ChangeKind::same; }
};

/// What became of a comparison. It does not move: the lit surface points into it.
struct Revisions {
  Comparison comparison;
  // What becomes of undercuts and actions, changed surface, changed regions, then what is the same.
  std::vector<RevisionChange> changes;
  std::array<std::vector<LitPolygon>, 2> lit;  // of A, of B; by facet

  explicit Revisions(Comparison compared);
  Revisions(const Revisions&) = delete;

  [[nodiscard]] const ComparedPart& part(bool second) const { return second ? comparison.b : comparison.a; }
  /// The change that a point of the part's surface lies on, unit frame of the part.
  [[nodiscard]] std::optional<std::size_t> change_at(bool second, const PickedPoint& point) const;
  /// The polygons of a change on A or B.
  [[nodiscard]] std::vector<LitPolygon> lit_of(bool second, std::size_t change) const;
  /// The pieces of the split mesh that an undercut or an action has there; none of another change.
  [[nodiscard]] std::vector<PieceIndex> pieces_of(bool second, std::size_t change) const;
};

/// The lit surface of A or B as bodies to be drawn over the picture, in this order: gone or new,
/// another region, what is chosen. What the plane cuts away is left out.
[[nodiscard]] std::vector<ViewBody> lit_bodies(const Revisions& revisions, bool second,
                                               const std::optional<std::size_t>& chosen,
                                               const std::optional<CutPlane>& cut);

/// The change of another comparison that is this one; nothing where there is none near it.
[[nodiscard]] std::optional<std::size_t> nearest_change(const Revisions& revisions,
                                                        const RevisionChange& change);

}  // namespace moldlight
