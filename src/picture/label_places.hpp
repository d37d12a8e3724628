// Where the labels of marks on a picture go, so that none covers another or a mark.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "picture/canvas.hpp"

namespace moldlight {

/// A round mark and the room that its label takes; pixels.
struct LabelledMark {
  glm::dvec2 centre{0.0};
  double radius = 0.0;
  glm::dvec2 label{0.0};
};

/// A box for each label, as near to its mark as there is room, the first marks first; none where there is no
/// room within a few label heights. `taken` are boxes that labels keep clear of; `room` holds all labels.
[[nodiscard]] std::vector<std::optional<Box>> place_labels(std::span<const LabelledMark> marks,
                                                           std::span<const Box> taken, const Box& room);

}  // namespace moldlight
