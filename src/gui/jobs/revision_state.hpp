// State of a second part beside the window's own, another revision of it: what is asked of their
// comparison, how far it is, what it found.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/job.hpp"
#include "compare/compare_picture.hpp"
#include "gui/jobs/loaded_part.hpp"
#include "render/part_view.hpp"

namespace moldlight::gui {

/// What the user does beside the settings; panels edit a copy of it.
struct RevisionChoices {
  std::optional<std::size_t> chosen;  // change that is looked at
};

/// B: as it was read, and as it is compared, in A's unit and where it lies.
struct PreparedRevision {
  std::shared_ptr<const PartModel> as_read;
  Comparison comparison;  // without what changed
  LoadedPart part;
};

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

/// The change of another comparison that is this one; nothing where there is none near it.
[[nodiscard]] std::optional<std::size_t> nearest_change(const Revisions& revisions,
                                                        const RevisionChange& change);

/// The surface of one of the two parts under the cursor.
struct RevisionHover {
  bool second = false;
  PickedPoint point;
  glm::dvec3 place{0.0};  // the point in the unit frame of the window's part
  double draft_deg = 0.0;
  std::optional<std::size_t> change;  // of the result
};

struct RevisionState {
  std::string path;  // of B, absolute; empty: nothing is compared
  std::shared_ptr<const PreparedRevision> prepared;
  std::shared_ptr<const Revisions> result;  // stays until another one is there
  bool stale = false;                       // the result is of other parts or settings
  bool awaited = false;                     // there will be another one
  bool given_up = false;                    // by the user, until something else is asked
  std::optional<JobStatus> running;
  std::string error;  // why there is none
  std::optional<RevisionHover> hover;

  [[nodiscard]] bool on() const { return !path.empty(); }
  /// Whether B is there to be seen.
  [[nodiscard]] bool seen() const { return prepared != nullptr; }
};

}  // namespace moldlight::gui
