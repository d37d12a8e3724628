// Text of STEP files (ISO 10303-21, application protocol 214), in millimetres.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace moldlight {

/// Collects the entities of a file. Each gets a number, by which others name it.
class StepText {
 public:
  using Number = std::size_t;

  /// `description` and `name` of the file, in any characters. The contexts are there from the start.
  StepText(std::string_view description, std::string_view name);

  /// An entity, "VERTEX_POINT('',#12)", without number and semicolon.
  Number add(std::string_view entity);
  Number point(const glm::dvec3& at);
  Number direction(const glm::dvec3& unit);
  /// The x axis is any across.
  Number placement(const glm::dvec3& at, const glm::dvec3& axis);
  /// A product with its PRODUCT_DEFINITION; the number of that.
  Number product(std::string_view name);
  /// Says that `representation` is the shape of a product's definition.
  void represent(Number definition, Number representation);

  /// The geometric context that representations are in, and the placement at the origin.
  [[nodiscard]] static std::string_view context() { return "#7"; }
  [[nodiscard]] static std::string_view origin() { return "#11"; }
  /// "#1,#2": of consecutive numbers.
  [[nodiscard]] static std::string list(Number first, std::size_t count);
  /// What ends no string: other characters are underscores.
  [[nodiscard]] static std::string plain(std::string_view text);
  /// A real, which has a point.
  [[nodiscard]] static std::string real(double value);

  /// The whole file.
  [[nodiscard]] std::string finished() &&;

 private:
  std::string text_;
  Number next_ = 1;
};

}  // namespace moldlight
