// The kinds of side action.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string_view>

namespace moldlight {

/// Slide: pulled sideways. Inclined: the same, at an angle to the plane across d. Lifter: moves sideways
/// relative to the part while both rise. Unscrew: leaves along its helix. Strip: the part is stretched over
/// it. Insert: a loose piece that is ejected with the part and taken off by hand, in any direction.
enum class ActionKind : std::uint8_t { slide, inclined, lifter, unscrew, strip, insert };
inline constexpr std::size_t k_action_kinds = 6;

/// More actions than a toolmaker builds for one direction: the part is changed, or turned.
inline constexpr std::size_t k_most_actions = 8;

/// Of all kinds.
using ActionCounts = std::array<std::size_t, k_action_kinds>;
[[nodiscard]] constexpr std::size_t number_of(const ActionCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// Pulled straight away from the part, before the halves open.
[[nodiscard]] constexpr bool is_slide(ActionKind kind) {
  return kind == ActionKind::slide || kind == ActionKind::inclined;
}

/// When it moves: 1 before the mold opens, 2 the halves, 3 with the ejection, 4 by hand.
[[nodiscard]] constexpr int sequence_of(ActionKind kind) {
  return kind == ActionKind::insert ? 4 : kind == ActionKind::lifter || kind == ActionKind::strip ? 3 : 1;
}

/// What else is said of a kind: the one place for it.
struct ActionFacts {
  std::string_view name;              // in reports
  std::string_view singular, plural;  // in sentences
  double weight;                      // in the choice of the least set: what a mold maker minds, no money
};
[[nodiscard]] const ActionFacts& facts(ActionKind kind);

}  // namespace moldlight
