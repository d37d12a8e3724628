// Binary glTF 2.0 (Khronos, 2021): a header, a chunk of JSON and one of numbers. Each group is a primitive
// with a material of its own; solids beside the mesh are nodes that an animation moves.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh_writer.hpp"
#include "io/text_scanner.hpp"
#include "mesh/length_unit.hpp"

namespace moldlight {

namespace {

using GltfJson = nlohmann::ordered_json;

constexpr int k_array_buffer = 34962, k_element_buffer = 34963, k_no_target = 0;
constexpr double k_opening_s = 2.0;

GltfJson gltf_point(const glm::dvec3& point) { return {point.x, point.y, point.z}; }

/// A share of light, of six digits, as colours of materials are.
double linear_share(std::uint8_t srgb) {
  const double share = srgb / 255.0;
  const double linear = share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  return std::round(linear * 1e6) / 1e6;
}

/// What coordinates are relative to: the middle of a part so far away that single precision would cost
/// digits.
glm::dvec3 gltf_place(const Bounds& bounds) {
  const glm::dvec3 middle = bounds.center();
  return glm::length(middle) > 4.0 * bounds.diagonal() ? middle : glm::dvec3(0.0);
}

class GltfFile {
 public:
  explicit GltfFile(const GroupedMesh& grouped) {
    const auto unit = find_length_unit(grouped.unit);
    const double scale = unit ? unit->mm / 1000.0 : 1.0;
    place_ = gltf_place(bounds(grouped.mesh));
    // From z up in the part's unit to y up in metres.
    nodes_.push_back(
        {{"name", written_description(grouped)},
         {"matrix", {scale, 0.0, 0.0, 0.0, 0.0, 0.0, -scale, 0.0, 0.0, scale, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}},
         {"children", {1}}});
    nodes_.push_back({{"name", "place"}, {"translation", gltf_point(place_)}});
    add_groups(grouped);
    for (const MovingSolid& solid : grouped.solids) add_solid(solid);
  }

  void write(const std::string& path) {
    const auto fill = [](std::string& bytes, char with) { bytes.resize((bytes.size() + 3) / 4 * 4, with); };
    GltfJson json = {{"asset", {{"version", "2.0"}, {"generator", "moldlight"}}},
                     {"scene", 0},
                     {"scenes", GltfJson::array({{{"nodes", {0}}}})},
                     {"nodes", nodes_},
                     {"meshes", meshes_},
                     {"materials", materials_},
                     {"accessors", accessors_},
                     {"bufferViews", views_},
                     {"buffers", GltfJson::array({{{"byteLength", numbers_.size()}}})}};
    if (!channels_.empty())
      json["animations"] =
          GltfJson::array({{{"name", "opening"}, {"channels", channels_}, {"samplers", samplers_}}});
    std::string text = json.dump(-1, ' ', false, GltfJson::error_handler_t::replace);
    fill(text, ' ');
    const std::uint64_t size = 12 + 8 + text.size() + 8 + numbers_.size();
    if (size > std::numeric_limits<std::uint32_t>::max())
      throw FileError(path, "", "would need more than the 4 GiB of a .glb; write .ply or .vtp");
    AtomicFile file(path);
    std::string head = "glTF";
    const auto add_word = [&](std::uint64_t word) { append_bytes(head, static_cast<std::uint32_t>(word)); };
    add_word(2);
    add_word(size);
    add_word(text.size());
    file.write(head.append("JSON").append(text));
    head.clear();
    add_word(numbers_.size());
    file.write(head.append("BIN\0", 4));
    file.write(numbers_);
    file.commit();
  }

 private:
  /// Number of the accessor to these values; `per` of them are one element.
  template <typename Value>
  std::size_t add_values(const std::vector<Value>& values, std::size_t per, int target) {
    static_assert(sizeof(Value) == 4, "so that all of them are aligned");
    GltfJson view = {{"buffer", 0}, {"byteOffset", numbers_.size()}, {"byteLength", 4 * values.size()}};
    if (target != k_no_target) view["target"] = target;
    for (const Value value : values) append_bytes(numbers_, value);
    constexpr std::array<const char*, 5> k_types = {"", "SCALAR", "", "VEC3", "VEC4"};
    GltfJson accessor = {{"bufferView", views_.size()},
                         {"componentType", std::is_same_v<Value, float> ? 5126 : 5125},
                         {"count", values.size() / per},
                         {"type", k_types[per]}};
    if constexpr (std::is_same_v<Value, float>) {
      std::vector<float> least(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(per)),
          most = least;
      for (std::size_t k = per; k < values.size(); ++k) {
        least[k % per] = std::min(least[k % per], values[k]);
        most[k % per] = std::max(most[k % per], values[k]);
      }
      accessor["min"] = least;
      accessor["max"] = most;
    }
    views_.push_back(std::move(view));
    accessors_.push_back(std::move(accessor));
    return accessors_.size() - 1;
  }

  /// Of these facets, over vertices of its own in the order of their use, relative to `origin`.
  GltfJson primitive(const TriangleMesh& mesh, std::span<const FacetIndex> facets, const glm::dvec3& origin,
                     const MeshGroup& group) {
    constexpr std::uint32_t k_unused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> numbers(mesh.vertices.size(), k_unused), corners;
    std::vector<float> points;
    for (const FacetIndex facet : facets) {
      for (const VertexIndex vertex : mesh.facets[facet]) {
        if (numbers[vertex] == k_unused) {
          numbers[vertex] = static_cast<std::uint32_t>(points.size() / 3);
          const glm::dvec3 point = mesh.vertices[vertex] - origin;
          for (int axis = 0; axis < 3; ++axis) points.push_back(static_cast<float>(point[axis]));
        }
        corners.push_back(numbers[vertex]);
      }
    }
    const Colour colour = group.colour;
    materials_.push_back(
        {{"name", group.name},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {linear_share(colour.r), linear_share(colour.g), linear_share(colour.b), 1.0}},
           {"metallicFactor", 0.0},
           {"roughnessFactor", 0.7}}},
         {"doubleSided", true}});  // an open part is seen from inside, too
    return {{"attributes", {{"POSITION", add_values(points, 3, k_array_buffer)}}},
            {"indices", add_values(corners, 1, k_element_buffer)},
            {"material", materials_.size() - 1}};
  }

  /// Number of the new node.
  std::size_t add_node(const std::string& name, GltfJson primitives) {
    nodes_.push_back({{"name", name}, {"mesh", meshes_.size()}});
    meshes_.push_back({{"name", name}, {"primitives", std::move(primitives)}});
    nodes_[1]["children"].push_back(nodes_.size() - 1);
    return nodes_.size() - 1;
  }

  void add_groups(const GroupedMesh& grouped) {
    std::vector<std::vector<FacetIndex>> facets(grouped.groups.size());
    for (FacetIndex facet = 0; facet < grouped.of_facet.size(); ++facet)
      facets[grouped.of_facet[facet]].push_back(facet);
    GltfJson primitives = GltfJson::array();
    for (std::size_t group = 0; group < facets.size(); ++group) {
      if (!facets[group].empty())
        primitives.push_back(primitive(grouped.mesh, facets[group], place_, grouped.groups[group]));
    }
    add_node(grouped.name.empty() ? "part" : clean_name(grouped.name), std::move(primitives));
  }

  void add_solid(const MovingSolid& solid) {
    std::vector<FacetIndex> facets(solid.mesh.facets.size());
    std::iota(facets.begin(), facets.end(), FacetIndex{0});
    GltfJson primitives = GltfJson::array();
    primitives.push_back(primitive(solid.mesh, facets, solid.point, {solid.name, solid.colour}));
    const std::size_t node = add_node(solid.name, std::move(primitives));
    const glm::dvec3 start = solid.point - place_, end = start + solid.way;
    nodes_[node]["translation"] = gltf_point(start);
    std::vector<float> places, turns;
    for (const glm::dvec3& place : {start, end})
      for (int axis = 0; axis < 3; ++axis) places.push_back(static_cast<float>(place[axis]));
    add_channel(node, "translation", places, 3);
    if (solid.turn_rad == 0.0) return;
    // Players take the shorter way from one place to the next.
    const double steps = std::ceil(std::abs(solid.turn_rad) / (std::numbers::pi / 2.0));
    for (double step = 0.0; step <= steps; ++step) {
      const double half_rad = 0.5 * solid.turn_rad * step / steps;
      const glm::dvec3 sine = std::sin(half_rad) * solid.axis;
      for (const double value : {sine.x, sine.y, sine.z, std::cos(half_rad)})
        turns.push_back(static_cast<float>(value));
    }
    add_channel(node, "rotation", turns, 4);
  }

  /// At even times.
  void add_channel(std::size_t node, const char* what, const std::vector<float>& values, std::size_t per) {
    std::vector<float> times(values.size() / per);
    for (std::size_t k = 0; k < times.size(); ++k)
      times[k] =
          static_cast<float>(k_opening_s * static_cast<double>(k) / static_cast<double>(times.size() - 1));
    channels_.push_back({{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", what}}}});
    const std::size_t input = add_values(times, 1, k_no_target);
    samplers_.push_back({{"input", input}, {"output", add_values(values, per, k_no_target)}});
  }

  GltfJson nodes_ = GltfJson::array(), meshes_ = nodes_, materials_ = nodes_, accessors_ = nodes_,
           views_ = nodes_, channels_ = nodes_, samplers_ = nodes_;
  std::string numbers_;
  glm::dvec3 place_{0.0};
};

}  // namespace

void write_glb(const std::string& path, const GroupedMesh& grouped) { GltfFile(grouped).write(path); }

}  // namespace moldlight
