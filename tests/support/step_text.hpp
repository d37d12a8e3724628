// Makes STEP files of boxes by writing their entities out, so that tests can have any schema, unit and
// placement.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace moldlight::test {

inline constexpr std::string_view k_ap203 = "CONFIG_CONTROL_DESIGN";
inline constexpr std::string_view k_ap214 = "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }";
inline constexpr std::string_view k_ap242 =
    "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }";

enum class StepUnit { mm, m, inch };

/// Where a component sits in its assembly.
struct StepPlacement {
  glm::dvec3 origin{0.0};
  glm::dvec3 z{0.0, 0.0, 1.0};
  glm::dvec3 x{1.0, 0.0, 0.0};
};

/// Entities in a row; each call adds some and returns the number of the one that others refer to.
class StepText {
 public:
  explicit StepText(std::string_view schema = k_ap214) : schema_(schema) {}

  /// The file's text so far.
  [[nodiscard]] std::string file() const;

  std::size_t add(const std::string& entity);
  std::size_t point(const glm::dvec3& at);
  std::size_t direction(const glm::dvec3& along);
  std::size_t placement(const StepPlacement& place);
  /// A closed shell, from the origin to `size`.
  std::size_t box_shell(const glm::dvec3& size);
  /// A manifold solid.
  std::size_t box(const glm::dvec3& size);
  /// The style of an item, a face or a solid, in a colour; parts in [0, 1].
  std::size_t style(std::size_t item, const glm::dvec3& colour);
  /// What lists styles, a list such as "#4,#5"; without it they are not the part's.
  void show_styles(const std::string& styles, std::size_t context);
  /// Faces so far, in order.
  [[nodiscard]] std::vector<std::size_t> faces() const;
  /// A geometric context of this unit.
  std::size_t context(StepUnit unit);

  struct Product {
    std::size_t definition = 0;      // PRODUCT_DEFINITION
    std::size_t representation = 0;  // SHAPE_REPRESENTATION of some kind
  };
  /// A product whose shape is a representation of the `kind` with these items, a list such as "#4,#5".
  Product product(const std::string& name, const std::string& kind, const std::string& items,
                  std::size_t context);
  /// One box.
  Product box_product(const std::string& name, const glm::dvec3& size, std::size_t context);
  /// A product without a shape of its own, to be filled by place().
  Product assembly(const std::string& name, std::size_t context);
  /// An instance of `part` in `whole`.
  void place(const Product& part, const Product& whole, const StepPlacement& place);
  /// The items of a representation that repeats a box, of the operator's axes, scale and origin.
  struct Operator {
    glm::dvec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
    glm::dvec3 origin{0.0};
    double scale = 1.0;
  };
  std::string mapped_box(const glm::dvec3& size, const Operator& target, std::size_t context);

 private:
  std::string schema_;
  std::string data_;
  std::size_t count_ = 0;
};

/// "#3"
[[nodiscard]] std::string step_reference(std::size_t number);

}  // namespace moldlight::test
