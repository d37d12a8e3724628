// The surface of which a verdict speaks: undercuts of a kind, a region, faults of the mesh.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "actions/side_action.hpp"
#include "classify/part_model.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// What a sentence of a verdict, or a line of its legend, speaks of.
struct Subject {
  /// All of a region; of undercuts those that count, what no action releases, what is ignored; faults of the
  /// mesh: open edges, those across which facets face opposite ways, facets that cross others.
  enum class Of : std::uint8_t { region, undercuts, unreleased, tiny, open_edges, turned_edges, crossings };
  Of of = Of::region;
  Region region = Region::undercut;

  bool operator==(const Subject&) const = default;
};

struct SubjectSurface {
  /// Lengths are the part's. Regions and undercuts are of pieces of a split mesh, faults of whole facets,
  /// those of the longest fault first. All pieces count as undercut, so that the best view of them can be
  /// looked for.
  SplitMesh mesh;
  std::vector<std::pair<VertexIndex, VertexIndex>> edges;  // at fault, of the part's vertices
};
/// `split` and `plan` are of one direction and may be null. Empty where it is not known without them, or
/// where they do not belong together.
[[nodiscard]] SubjectSurface surface_of(const Subject& subject, const PartModel& model,
                                        const SplitMesh* split, const ActionPlan* plan);

/// The undercut of which most is not released; none where all is.
[[nodiscard]] std::optional<std::size_t> least_released(const ActionPlan& plan);

}  // namespace moldlight
