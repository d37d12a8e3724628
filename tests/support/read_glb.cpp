#include "support/read_glb.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>
#include <tuple>

namespace moldlight::test {

namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("glb: " + what);
}

std::uint32_t word(std::string_view bytes, std::size_t at) {
  require(at + 4 <= bytes.size(), "it ends early");
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

template <typename Value>
std::vector<Value> numbers_of(std::string_view bytes) {
  std::vector<Value> values(bytes.size() / sizeof(Value));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

}  // namespace

Glb::Glb(std::string_view bytes) {
  require(bytes.starts_with("glTF") && word(bytes, 4) == 2, "magic and version");
  require(word(bytes, 8) == bytes.size(), "length of the file");
  const std::size_t text = word(bytes, 12);
  require(bytes.substr(16, 4) == "JSON" && text % 4 == 0, "chunk of JSON");
  const std::size_t data = 20 + text, size = word(bytes, data);
  require(bytes.substr(data + 4, 4) == std::string_view("BIN\0", 4) && size % 4 == 0, "chunk of numbers");
  require(data + 8 + size == bytes.size(), "lengths of the chunks");
  json_ = nlohmann::json::parse(bytes.substr(20, text));
  numbers_ = bytes.substr(data + 8);
  require(json_["asset"]["version"] == "2.0", "version");
  require(json_["buffers"].size() == 1 && json_["buffers"][0]["byteLength"] == size, "one buffer");
}

std::string_view Glb::values(std::size_t accessor, int component, std::size_t per) const {
  const auto& one = json_["accessors"].at(accessor);
  const auto& view = json_["bufferViews"].at(one["bufferView"].get<std::size_t>());
  require(one["componentType"] == component, "component type");
  require(one["type"] == (per == 1 ? "SCALAR" : per == 3 ? "VEC3" : "VEC4"), "type");
  const std::size_t at = view["byteOffset"], length = view["byteLength"];
  require(at % 4 == 0 && at + length <= numbers_.size(), "a view leaves the buffer");
  require(one["count"].get<std::size_t>() > 0 && one["count"].get<std::size_t>() * per * 4 == length,
          "count");
  return std::string_view(numbers_).substr(at, length);
}

std::vector<float> Glb::floats(std::size_t accessor) const {
  const auto& one = json_["accessors"].at(accessor);
  const std::size_t per = one["type"] == "SCALAR" ? 1 : one["type"] == "VEC3" ? 3 : 4;
  std::vector<float> found = numbers_of<float>(values(accessor, 5126, per));
  require(one["min"].size() == per && one["max"].size() == per, "bounds");
  for (std::size_t axis = 0; axis < per; ++axis) {
    float least = found[axis], most = found[axis];
    for (std::size_t k = axis; k < found.size(); k += per) {
      least = std::min(least, found[k]);
      most = std::max(most, found[k]);
    }
    require(one["min"][axis].get<float>() == least && one["max"][axis].get<float>() == most, "bounds");
  }
  return found;
}

std::vector<std::uint32_t> Glb::indices(std::size_t accessor) const {
  return numbers_of<std::uint32_t>(values(accessor, 5125, 1));
}

std::size_t Glb::node(std::string_view name) const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < json_["nodes"].size(); ++k)
    if (json_["nodes"][k]["name"] == name) found.push_back(k);
  require(found.size() == 1, "one node " + std::string(name));
  return found.front();
}

glm::dmat4 Glb::placed(std::size_t node) const {
  const auto& one = json_["nodes"].at(node);
  glm::dmat4 own(1.0);
  if (one.contains("matrix")) {
    for (int k = 0; k < 16; ++k) own[k / 4][k % 4] = one["matrix"].at(static_cast<std::size_t>(k));
  } else if (one.contains("translation")) {
    for (int axis = 0; axis < 3; ++axis) own[3][axis] = one["translation"].at(static_cast<std::size_t>(axis));
  }
  for (std::size_t k = 0; k < json_["nodes"].size(); ++k) {
    const auto& parent = json_["nodes"][k];
    if (!parent.contains("children")) continue;
    if (std::ranges::find(parent["children"], nlohmann::json(node)) != parent["children"].end())
      return placed(k) * own;
  }
  require(json_["scenes"][0]["nodes"] == nlohmann::json::array({node}), "a node hangs in the air");
  return own;
}

TriangleMesh Glb::mesh(const nlohmann::json& primitive) const {
  TriangleMesh mesh;
  const std::vector<float> points = floats(primitive["attributes"]["POSITION"]);
  for (std::size_t k = 0; k < points.size(); k += 3)
    mesh.vertices.emplace_back(points[k], points[k + 1], points[k + 2]);
  const std::vector<std::uint32_t> corners = indices(primitive["indices"]);
  require(corners.size() % 3 == 0, "triangles");
  require(*std::ranges::max_element(corners) + std::size_t{1} == mesh.vertices.size(), "indices");
  for (std::size_t k = 0; k < corners.size(); k += 3)
    mesh.facets.push_back({corners[k], corners[k + 1], corners[k + 2]});
  return mesh;
}

std::string Glb::material(const nlohmann::json& primitive) const {
  return json_["materials"].at(primitive["material"].get<std::size_t>())["name"];
}

TriangleMesh joined(const std::vector<TriangleMesh>& meshes) {
  TriangleMesh whole;
  std::map<std::tuple<double, double, double>, VertexIndex> numbers;
  for (const TriangleMesh& mesh : meshes) {
    for (const auto& facet : mesh.facets) {
      std::array<VertexIndex, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3& point = mesh.vertices[facet[k]];
        const auto [found, is_new] =
            numbers.try_emplace({point.x, point.y, point.z}, static_cast<VertexIndex>(whole.vertices.size()));
        if (is_new) whole.vertices.push_back(point);
        corners[k] = found->second;
      }
      whole.facets.push_back(corners);
    }
  }
  return whole;
}

}  // namespace moldlight::test
