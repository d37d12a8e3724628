// The figures of an action and of an undercut, a row each.
#pragma once

#include "actions/side_action.hpp"
#include "classify/figure_table.hpp"

namespace moldlight {

/// Keys are relative to "/actions/k" and "/undercuts/k".
[[nodiscard]] std::span<const FigureRow<SideAction>> action_figures();
/// Of the solid that it moves.
[[nodiscard]] std::span<const FigureRow<SideAction>> body_figures();
[[nodiscard]] std::span<const FigureRow<Undercut>> undercut_sizes();
/// Beside its size.
[[nodiscard]] std::span<const FigureRow<UndercutReport>> undercut_figures();

}  // namespace moldlight
