// Facts about an undercut beside its size: the facets that hide it, and those formed with it.
#pragma once

#include <vector>

#include "actions/side_action.hpp"
#include "mesh/faces.hpp"

namespace moldlight {

/// Facets that hide it from both sides along `direction` (unit), the most frequent first, four at most.
[[nodiscard]] std::vector<FacetIndex> blockers(const PartModel& model, const SplitMesh& split,
                                               const Undercut& undercut, const glm::dvec3& direction);

struct FormedContext {
  const PartModel& model;
  const SplitMesh& split;
  const Faces& faces;
  const Release& release;
};
/// Fills in `formed` and `formed_area`: the undercut, and what the same straight pull frees of the faces that
/// it lies on; the undercut alone for null and for what turns.
void add_formed_surface(const FormedContext& context, const SideAction* action, UndercutReport& noted);

}  // namespace moldlight
