#include "actions/action_groups.hpp"

#include "actions/actions_files.hpp"

namespace moldlight {

ActionGroups action_groups(const ActionsReport& report, Palette palette) {
  const SplitMesh& split = *report.result.split;
  ActionGroups found;
  std::vector<MeshGroup>& groups = found.groups;
  for (const Region region : k_regions)
    groups.push_back({std::string(region_name(region)), region_colour(region, palette)});
  const auto first = static_cast<std::uint32_t>(groups.size());
  for (std::size_t k = 0; k < report.plan.actions.size(); ++k)
    groups.push_back({action_name(report.plan, k), action_colour(k)});
  const auto unreleased = static_cast<std::uint32_t>(groups.size());
  groups.push_back({"unreleased", {110, 0, 30}});
  for (std::size_t k = 0; k < split.pieces.size(); ++k) {
    const std::int32_t action = report.plan.action_of_piece[k];
    found.of_piece.push_back(action >= 0 ? first + static_cast<std::uint32_t>(action)
                             : action == k_unreleased_piece
                                 ? unreleased
                                 : static_cast<std::uint32_t>(split.pieces[k].region));
  }
  return found;
}

}  // namespace moldlight
