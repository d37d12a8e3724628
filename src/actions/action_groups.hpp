// What forms each piece of the split part, once its side actions are known.
#pragma once

#include <cstdint>
#include <vector>

#include "actions/actions_report.hpp"
#include "io/mesh_writer.hpp"

namespace moldlight {

struct ActionGroups {
  std::vector<MeshGroup> groups;
  std::vector<std::uint32_t> of_piece;  // of the split mesh
};
/// Core, cavity, both, undercut that was left out, each action under its name, and what is unreleased.
[[nodiscard]] ActionGroups action_groups(const ActionsReport& report, Palette palette);

}  // namespace moldlight
