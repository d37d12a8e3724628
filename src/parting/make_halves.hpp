// Makes the two halves of a mold around a part, with their certificate.
#pragma once

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "parting/loops.hpp"
#include "parting/mold_halves.hpp"
#include "parting/mold_settings.hpp"
#include "parting/planar_line.hpp"
#include "parting/slide_blank.hpp"

namespace moldlight {

/// Where the halves are to meet on walls that either could form.
struct MeetingPlace {
  double height = 0.0;                // along the direction, in the part's coordinates
  const PartingLine* line = nullptr;  // outweighs the height where it runs over such walls
  /// That the line divides: walls that lean back by a hair are left to the half that has them.
  const Assignment* sides = nullptr;
};

[[nodiscard]] inline MeetingPlace meeting_place(const MoldLine& line) {
  return {line.assignment.height, &line.line, &line.assignment};
}

/// A corner of an insert that a half is to have, too, in the mold's frame, in diagonals.
struct LiftedInsert {
  glm::dvec3 corner{0.0};
  bool core_side = true;
};

/// Bodies beside the part that slides are cut from, with the block whose sides they reach; and what lifters
/// are cut from.
struct Beside {
  std::vector<SlideBlank> blanks;
  std::vector<LiftedInsert> lifted = {};
  glm::dvec2 low{0.0}, high{0.0};  // in the mold's frame, in diagonals
  double margin = 0.0;             // what MoldHalves::margin says of that block
  bool divides = true;             // whether round walls may be divided
  double contact_area = 0.0;       // of the halves without them: no more is wanted with them
};

/// The halves for a unit direction, whatever the undercut. Faces given to a half by hand, as the settings
/// have them, outweigh the place. Throws UsageError for faces that the part has not and for a margin without
/// bounds, Cancelled. With `beside` they leave the room of its bodies, too, and there are halves with what
/// lifters form.
[[nodiscard]] MoldHalves make_halves(const PartModel& model, const glm::dvec3& direction,
                                     const MeetingPlace& place, const MoldSettings& settings,
                                     const Progress& progress, const Beside& beside = {});

}  // namespace moldlight
