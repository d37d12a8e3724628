// What a verdict on a part and a direction comes to.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace moldlight {

/// From what a mold maker likes best to what he likes least.
enum class VerdictState : std::uint8_t {
  two_plate,       // no undercut, and the mesh is in order
  side_actions,    // undercuts, and the side actions that were found release all of them
  undercuts,       // there are some, and side actions were not asked for
  not_releasable,  // some undercut is released by nothing that was tried
  unknown,         // the mesh does not decide
};
inline constexpr std::array<std::string_view, 5> k_verdict_states = {"two-plate", "side-actions", "undercuts",
                                                                     "not-releasable", "unknown"};

[[nodiscard]] constexpr std::string_view state_name(VerdictState state) {
  return k_verdict_states[static_cast<std::size_t>(state)];
}

}  // namespace moldlight
