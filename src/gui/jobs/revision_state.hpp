// State of a second part beside the window's own, another revision of it: what is asked of their
// comparison, how far it is, what it found.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/job.hpp"
#include "compare/revision_changes.hpp"
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
