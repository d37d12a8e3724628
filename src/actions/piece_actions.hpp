// Which action forms which piece of the split mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "actions/chosen_action.hpp"

namespace moldlight {

/// For every piece of the split mesh that belongs to an undercut of several undercut parts the one with the
/// sample that is nearest to its middle; 0 for others.
[[nodiscard]] std::vector<std::size_t> nearest_parts(const ChosenContext& context,
                                                     const std::vector<UndercutPart>& undercut_parts);

/// For every piece of the split mesh an action, or k_no_action_of_piece or k_unreleased_piece; `of_atom` has
/// such a number for each undercut part. Pieces of an undercut that was split go with the undercut part that
/// is `nearest`, but rather with an action that frees their middles and corners, if there is one.
[[nodiscard]] std::vector<std::int32_t> actions_of_pieces(const ChosenContext& context,
                                                          const std::vector<UndercutPart>& undercut_parts,
                                                          std::span<const std::size_t> nearest,
                                                          std::span<const std::int32_t> of_atom,
                                                          const std::vector<SideAction>& actions);

}  // namespace moldlight
