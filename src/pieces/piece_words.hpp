// What pieces of a mold and the ways that they move are called.
#pragma once

#include <cstddef>
#include <string>

#include <glm/vec3.hpp>

namespace moldlight {

/// As direction_words(); "45° off z (towards +x)" where it lies between two axes at whole degrees.
[[nodiscard]] std::string pull_words(const glm::dvec3& direction);
/// "piece_1", in the order of removal.
[[nodiscard]] std::string piece_name(std::size_t direction);

}  // namespace moldlight
