// Reading binary glTF as far as the program writes it, and complaining of whatever the specification forbids.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight::test {

/// Throws std::runtime_error where the file is none: sizes, chunks, and accessors that leave their views.
class Glb {
 public:
  explicit Glb(std::string_view bytes);

  [[nodiscard]] const nlohmann::json& json() const { return json_; }
  /// Of an accessor, one after the other; its least and greatest are compared with those that it declares.
  [[nodiscard]] std::vector<float> floats(std::size_t accessor) const;
  [[nodiscard]] std::vector<std::uint32_t> indices(std::size_t accessor) const;
  /// Number of the node; throws where there is none or more than one.
  [[nodiscard]] std::size_t node(std::string_view name) const;
  /// From the node to the scene, in double.
  [[nodiscard]] glm::dmat4 placed(std::size_t node) const;
  /// The triangles of a primitive as they stand in the file.
  [[nodiscard]] TriangleMesh mesh(const nlohmann::json& primitive) const;
  [[nodiscard]] std::string material(const nlohmann::json& primitive) const;

 private:
  [[nodiscard]] std::string_view values(std::size_t accessor, int component, std::size_t per) const;

  nlohmann::json json_;
  std::string numbers_;
};

/// Equal places become one vertex.
[[nodiscard]] TriangleMesh joined(const std::vector<TriangleMesh>& meshes);

}  // namespace moldlight::test
