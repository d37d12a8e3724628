// Undercuts that the user leaves to one kind of action, whatever would be cheaper.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/action_kind.hpp"
#include "actions/undercut.hpp"

namespace moldlight {

/// Found again by its place: undercuts have no names, and their numbers change with the direction.
struct ActionPin {
  glm::dvec3 point{0.0};           // on the undercut, in the part's unit
  double area = 0.0;               // of the undercut, > 0, the part's unit squared
  std::optional<ActionKind> kind;  // nothing: it is left as it is

  /// Whether an action of this kind may release the undercut.
  [[nodiscard]] bool allows(ActionKind other) const { return kind == other; }
  bool operator==(const ActionPin&) const = default;
};

/// The word for an undercut that is to be left as it is.
inline constexpr std::string_view k_no_action = "none";

/// "slide", or k_no_action.
[[nodiscard]] std::string_view pin_name(const ActionPin& pin);

/// "X,Y,Z,AREA,KIND;…": KIND is the name of a kind of action, or k_no_action.
[[nodiscard]] std::string pins_text(std::span<const ActionPin> pins);
/// Throws UsageError that says what is wrong.
[[nodiscard]] std::vector<ActionPin> parse_pins(std::string_view text);

/// An undercut as pins find it.
struct PinnedPlace {
  std::span<const UndercutSample> samples;
  double area = 0.0;  // the part's unit squared
};
/// The pin of this undercut: the last one whose area is within a factor of two of its own and whose point is
/// within `reach` (part's unit) of a sample; null for none.
[[nodiscard]] const ActionPin* pin_of(std::span<const ActionPin> pins, const PinnedPlace& place,
                                      const UnitFrame& frame, double reach);

}  // namespace moldlight
