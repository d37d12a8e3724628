// Side actions as meshes and pictures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "actions/actions_report.hpp"
#include "classify/still_picture.hpp"
#include "io/mesh_writer.hpp"

namespace moldlight {

/// "slide_1": the kind and the number that the report gives it, from 1.
[[nodiscard]] std::string action_name(const ActionPlan& plan, std::size_t action);
/// Distinguished by hue, over and over for many; undercuts' red is left out.
[[nodiscard]] Colour action_colour(std::size_t action);

/// What forms each piece of the split part, once its side actions are known.
struct ActionGroups {
  std::vector<MeshGroup> groups;
  std::vector<std::uint32_t> of_piece;  // of the split mesh
};
/// Core, cavity, both, undercut that was left out, each action under its name, and what is unreleased.
[[nodiscard]] ActionGroups action_groups(const ActionsReport& report, Palette palette);

/// Writes the split part with its facets grouped by what forms them, in the formats of write_grouped_mesh():
/// core, cavity, both, each action under its name, what is unreleased, and undercut that was left out. The
/// bodies of the actions go with it where the format has solids that move.
void write_action_mesh(const std::string& path, const ActionsReport& report, Palette palette);

/// Writes the body of each action that has one to <folder>/<stem>_<name>.stl, making the folder; a former
/// file of such a name that is not written again goes. With `as_step` all of them to
/// <folder>/<stem>_actions.step, too. Returns the path of each action's, empty without one.
std::vector<std::string> write_action_bodies(const std::string& folder, const std::string& stem,
                                             const ActionsReport& report, bool as_step);

/// The bodies pulled out of the part by their travel.
[[nodiscard]] std::vector<StillBody> pulled_bodies(const ActionsReport& report);

}  // namespace moldlight
