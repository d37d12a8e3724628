// How figures are written for people: as many digits as the eye wants, the unit beside them.
#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "base/numbers.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// Digits before the point in groups of three: "1 234.5" with thin gaps.
[[nodiscard]] std::string grouped(std::string_view number);

/// What part of `whole` a value is; 0 of nothing.
[[nodiscard]] double share(double value, double whole);
/// The same as "2.03 %".
[[nodiscard]] std::string share_text(double value, double whole);
/// rounded() of an area of a surface: what is less than a millionth of it is not distinguished.
[[nodiscard]] std::string rounded_area(double area, double whole);
/// How far a figure may be off, in two digits.
[[nodiscard]] std::string error_text(double error, double least = 0.0);

/// Six digits: where near values differ, for criteria and programs.
[[nodiscard]] std::string figure(double value);

/// "0.00000, 0.60000, 0.80000".
[[nodiscard]] std::string direction_text(const glm::dvec3& direction, int decimals = 5);
/// A component of a direction with so many decimals; no sign where they all are 0.
[[nodiscard]] std::string component_text(double value, int decimals);

/// With a capital and a full stop; nothing of nothing.
[[nodiscard]] std::string sentence_of(std::string text);

/// With true minuses in place of the hyphens that a terminal gets, but for hyphens between letters.
[[nodiscard]] std::string with_minus(std::string text);

/// "mm"; "unit" where the file names none.
[[nodiscard]] std::string length_unit(const Part& part);
/// "mm²", "mm³": the length's unit to the power 2 or 3.
[[nodiscard]] std::string powered_unit(const Part& part, int power);

/// "7 tiny, ignored": the one row of what is below a tolerance; empty for none.
[[nodiscard]] std::string tiny_text(std::size_t count);

/// The part's file name without its folders, fit for one line of text.
[[nodiscard]] std::string part_name(const Part& part);

}  // namespace moldlight
