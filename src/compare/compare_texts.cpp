#include "compare/compare_texts.hpp"

#include <cmath>

#include <fmt/format.h>

namespace moldlight {

std::string change_text(const FigureColumn& column, double change) {
  const std::string text = column.text(std::abs(change));
  const bool none = text.find_first_not_of("0.") == std::string::npos;
  return none ? "0" : (change > 0.0 ? "+" : "-") + text;
}

std::string point_text(const FigureColumn& column, const glm::dvec3& point) {
  const auto text = [&](double value) {
    const std::string digits = column.text(value);
    return digits.find_first_not_of("-0.") == std::string::npos ? column.text(0.0) : digits;
  };
  return fmt::format("{}, {}, {}", text(point.x), text(point.y), text(point.z));
}

}  // namespace moldlight
