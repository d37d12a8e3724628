// The halves without slides, from which those with slides and lifters are made: in the mold's frame about the
// part's centre, in diagonals of the part.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/part_model.hpp"
#include "parting/insert_actions.hpp"
#include "parting/mold_halves.hpp"
#include "parting/mold_settings.hpp"
#include "parting/sheet_frame.hpp"

namespace moldlight {

/// The lateral tolerance, in diagonals: what moves out may come so near to what stands still.
inline constexpr double k_way_slack = 1.0 / 2048.0;
/// So much thicker than a speck may be what slides leave of the bodies that they form: the plastic fills it.
inline constexpr double k_left_to_plastic = 4.0;
inline constexpr double k_most_gap_of_pieces = 1e-9;  // of the block's volume, between all pieces
/// A way that leaves the plane across the direction by more, as a sine, is inclined.
inline constexpr double k_inclined = 1e-3;

struct MeetingPlace;

/// An action that is no solid of the mold.
struct UnmadeAction {
  std::size_t action = 0;  // number in the plan
  std::string why;         // a clause
};

struct PiecesWish {
  const PartModel& model;
  const MoldHalves& plain;  // without slides
  const ActionPlan& plan;
  const SplitMesh& split;  // of the classification that the plan was found for
  const MeetingPlace& place;
  const MoldSettings& settings;
};

struct PlainMold {
  explicit PlainMold(const PiecesWish& wish);  // which must outlive it

  [[nodiscard]] TriangleMesh as_in_part(const TriangleMesh& body) const;
  /// Unit, across z, along x or y where it nearly is.
  [[nodiscard]] glm::dvec3 way_of(std::size_t action) const;
  /// Corners of what an action releases.
  [[nodiscard]] std::vector<glm::dvec3> released_by(std::size_t action) const;
  /// "the part stands in its way, near …"; `place` in this frame.
  [[nodiscard]] std::string stands_text(std::string_view what, const glm::dvec3& place) const;

  const PiecesWish& wish;
  SheetFrame frame;
  TriangleMesh part;
  std::vector<TriangleMesh> inserts;
  std::vector<InsertActions> of_inserts;
};

}  // namespace moldlight
