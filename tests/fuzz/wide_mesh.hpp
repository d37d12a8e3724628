// Parts whose coordinates differ by up to forty orders of magnitude, made of a few bytes, and what is asked
// of them: nothing may crash, hang or give a number that is none.
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "mesh/part.hpp"

namespace moldlight::fuzz {

struct WidePart {
  Part part;  // of up to 35 facets; maybe of none
  glm::dvec3 direction{0, 0, 1};
};

/// Any bytes make one: a number of changes, for each a coordinate and what becomes of it (a flipped bit of
/// its exponent or sign, or a factor of 1e-20 to 1e20), then a small_mesh(). Only what a reader would take.
[[nodiscard]] WidePart wide_part(std::span<const std::uint8_t> bytes);

/// End the program where something is wrong; return false for a part that was refused in words.
bool try_split_mesh(const WidePart& wide);
bool try_actions(const WidePart& wide);
bool try_mold(const WidePart& wide);
/// With the same part before the last half of its changes.
bool try_compare(std::span<const std::uint8_t> bytes);

}  // namespace moldlight::fuzz
