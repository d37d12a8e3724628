// How figures of a comparison are written for people.
#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "classify/figures.hpp"

namespace moldlight {

/// With its sign; "0" for what is less than the column shows.
[[nodiscard]] std::string change_text(const FigureColumn& column, double change);
/// "x, y, z"; what is less than the column shows is written without a sign.
[[nodiscard]] std::string point_text(const FigureColumn& column, const glm::dvec3& point);

}  // namespace moldlight
