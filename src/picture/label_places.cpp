#include "picture/label_places.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vector_relational.hpp>

namespace moldlight {

namespace {

constexpr double k_air_px = 2.0;  // between labels
constexpr int k_turns = 16;
constexpr double k_first_gap = 0.2, k_gap_step = 0.5, k_last_gap = 5.0;  // in label heights

bool overlap(const Box& a, const Box& b) {
  return glm::all(glm::lessThan(a.corner, b.far_corner() + k_air_px)) &&
         glm::all(glm::lessThan(b.corner, a.far_corner() + k_air_px));
}

bool within(const Box& inner, const Box& outer) {
  return glm::all(glm::greaterThanEqual(inner.corner, outer.corner)) &&
         glm::all(glm::lessThanEqual(inner.far_corner(), outer.far_corner()));
}

bool covers(const Box& box, const LabelledMark& mark) {
  const glm::dvec2 nearest = glm::clamp(mark.centre, box.corner, box.far_corner());
  return glm::distance(nearest, mark.centre) < mark.radius + 0.5 * k_air_px;
}

/// A box whose edge is `gap` away from the mark, in direction `turn` of k_turns from the right,
/// counter-clockwise.
Box box_beside(const LabelledMark& mark, double gap, int turn) {
  const double angle = glm::two_pi<double>() * turn / k_turns;
  const glm::dvec2 along(std::cos(angle), -std::sin(angle));
  // How far from the centre a box of this size must stand so that its edge is at the mark.
  const glm::dvec2 half = 0.5 * mark.label;
  const glm::dvec2 steep = glm::max(glm::abs(along), glm::dvec2(1e-9));
  const double inside = std::min(half.x / steep.x, half.y / steep.y);
  return {mark.centre + along * (mark.radius + gap + inside) - half, mark.label};
}

}  // namespace

std::vector<std::optional<Box>> place_labels(std::span<const LabelledMark> marks, std::span<const Box> taken,
                                             const Box& room) {
  std::vector<Box> filled(taken.begin(), taken.end());
  std::vector<std::optional<Box>> places;
  for (const LabelledMark& mark : marks) {
    const auto free = [&](const Box& box) {
      return within(box, room) &&
             std::none_of(filled.begin(), filled.end(),
                          [&](const Box& other) { return overlap(box, other); }) &&
             std::none_of(marks.begin(), marks.end(), [&](const auto& other) { return covers(box, other); });
    };
    std::optional<Box> place;
    for (double gap = k_first_gap; !place && gap <= k_last_gap; gap += k_gap_step) {
      for (int turn = 0; !place && turn < k_turns; ++turn) {
        const Box box = box_beside(mark, gap * mark.label.y, turn);
        if (free(box)) place = box;
      }
    }
    if (place) filled.push_back(*place);
    places.push_back(place);
  }
  return places;
}

}  // namespace moldlight
