#include "actions/pins.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/error.hpp"
#include "classify/option.hpp"

namespace moldlight {

namespace {

constexpr std::string_view k_what = "pins";

/// Takes what stands before the mark, or all of it, from the front of the text.
std::string_view take_until(std::string_view& text, char mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

ActionPin parse_pin(std::string_view text) {
  ActionPin pin;
  for (int axis = 0; axis < 3; ++axis) pin.point[axis] = parse_real({take_until(text, ','), k_what});
  pin.area = parse_positive({take_until(text, ','), k_what}, std::numeric_limits<double>::infinity());
  Words words = {k_no_action};
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind)
    words.push_back(facts(static_cast<ActionKind>(kind)).name);
  if (const int word = parse_word({text, k_what}, words); word > 0)
    pin.kind = static_cast<ActionKind>(word - 1);
  return pin;
}

}  // namespace

std::string_view pin_name(const ActionPin& pin) { return pin.kind ? facts(*pin.kind).name : k_no_action; }

std::string pins_text(std::span<const ActionPin> pins) {
  std::string text;
  for (const ActionPin& pin : pins) {
    const auto& [x, y, z] = std::array{pin.point.x, pin.point.y, pin.point.z};
    text += fmt::format("{}{},{},{},{},{}", text.empty() ? "" : ";", x, y, z, pin.area, pin_name(pin));
  }
  return text;
}

std::vector<ActionPin> parse_pins(std::string_view text) {
  std::vector<ActionPin> pins;
  while (!text.empty()) pins.push_back(parse_pin(take_until(text, ';')));
  return pins;
}

const ActionPin* pin_of(std::span<const ActionPin> pins, const PinnedPlace& place, const UnitFrame& frame,
                        double reach) {
  for (auto pin = pins.rbegin(); pin != pins.rend(); ++pin) {
    if (place.area > 2.0 * pin->area || pin->area > 2.0 * place.area) continue;
    const glm::vec3 point = frame.to_unit(pin->point);
    const bool near = std::ranges::any_of(place.samples, [&](const UndercutSample& sample) {
      return glm::distance(glm::dvec3(point), glm::dvec3(sample.position)) * frame.diagonal <= reach;
    });
    if (near) return &*pin;
  }
  return nullptr;
}

}  // namespace moldlight
