// What the window knows of the mold: the parting line, the two halves, and which loop of the line is looked
// at.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/job.hpp"
#include "classify/settings.hpp"
#include "parting/draft/draft_check.hpp"
#include "parting/insert_actions.hpp"
#include "parting/loops.hpp"
#include "parting/mold_files.hpp"
#include "parting/mold_halves.hpp"
#include "render/view_body.hpp"
#include "render/view_geometry.hpp"

namespace moldlight::gui {

/// What the user does beside the settings; panels edit a copy of it.
struct MoldChoices {
  std::optional<std::size_t> loop;  // of the line, that is looked at
  bool moves_faces = false;         // a click moves a face to the other half
};

/// The parting line, and what it was found for.
struct MoldLine {
  Query query;
  MoldSettings settings;
  Assignment assignment;
  PartingLine line;
  std::string verdict;
  std::vector<std::vector<ViewSegment>> loops;  // each of the line, unit frame
  std::optional<DraftCheck> draft;              // at the required draft, if there is one
};

/// The halves with their certificate, as they are written and as they are drawn.
struct MoldSolids {
  MoldHalves halves;
  WrittenMold written;
  std::vector<ViewSolid> shown;  // core, cavity, each insert; none where there are no halves
};

/// A line outlives changes of the mold's settings until another one is there, but not those of the direction;
/// so do halves.
struct MoldState {
  std::shared_ptr<const MoldLine> line;
  std::shared_ptr<const MoldSolids> solids;
  // What forms each insert of the solids, for the plan of side actions; none where it is not known.
  std::shared_ptr<const std::vector<InsertActions>> by_action;
  bool line_awaited = false, solids_awaited = false;  // there will be others
  std::optional<JobStatus> running;                   // the search for one of them
  std::string error;                                  // why there is none
};

/// Whether both are of the present settings.
[[nodiscard]] inline bool is_settled(const MoldState& mold) {
  return mold.line && mold.solids && !mold.line_awaited && !mold.solids_awaited;
}

}  // namespace moldlight::gui
