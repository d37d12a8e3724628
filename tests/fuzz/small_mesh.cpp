#include "fuzz/small_mesh.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/weld.hpp"
#include "support/boxes.hpp"
#include "support/random.hpp"

namespace moldlight::fuzz {

namespace {

constexpr std::size_t k_most_facets = 24;
constexpr std::array<double, 4> k_jitters = {0.0, 1e-2, 1e-4, 1e-6};
/// None that facets of the grid have: rounding would show their class.
constexpr std::array<double, 4> k_taus_deg = {1.0, 0.1, 5.0, 29.0};
constexpr std::array<double, 4> k_laterals = {1.0 / 2048.0, 0.01, 0.1, 0.03};

/// Zeros after the last byte.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] bool at_end() const { return next_ >= bytes_.size(); }
  std::uint8_t take() { return at_end() ? std::uint8_t{0} : bytes_[next_++]; }
  glm::dvec3 take_corner() {
    const int x = take() % 8, y = take() % 8;
    return {x, y, take() % 8};
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

using Corners = std::vector<glm::dvec3>;  // three a facet

void add_tetrahedron(Corners& corners, Bytes& bytes) {
  std::array<glm::dvec3, 4> p{};
  for (glm::dvec3& point : p) point = bytes.take_corner();
  const double volume = glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
  if (volume == 0.0) return;
  if (volume < 0.0) std::swap(p[0], p[1]);
  for (const auto& [a, b, c] : {std::array{0U, 2U, 1U}, {0U, 1U, 3U}, {1U, 2U, 3U}, {0U, 3U, 2U}})
    corners.insert(corners.end(), {p[a], p[b], p[c]});
}

void add_box(Corners& corners, Bytes& bytes) {
  const glm::dvec3 a = bytes.take_corner(), b = bytes.take_corner();
  const glm::dvec3 low = glm::min(a, b), size = glm::max(a, b) - low;
  if (size.x * size.y * size.z == 0.0) return;
  const Corners box = test::box_corners(low, low + size);
  corners.insert(corners.end(), box.begin(), box.end());
}

/// Of three corners in a line, only where they stay there: off the grid it is a needle, whose normal is
/// rounding.
void add_facet(Corners& corners, Bytes& bytes, bool any) {
  const glm::dvec3 a = bytes.take_corner(), b = bytes.take_corner(), c = bytes.take_corner();
  if (any || glm::cross(b - a, c - a) != glm::dvec3(0.0)) corners.insert(corners.end(), {a, b, c});
}

}  // namespace

SmallMesh small_mesh(std::span<const std::uint8_t> data) {
  Bytes bytes(data);
  SmallMesh result;
  const unsigned choice = bytes.take();
  result.kind = static_cast<MeshKind>(choice & 3U);
  result.jitter = k_jitters[choice >> 2 & 3U];
  result.settings = {.tau_deg = k_taus_deg[choice >> 4 & 3U], .lateral_tolerance = k_laterals[choice >> 6]};
  const glm::dvec3 direction = bytes.take_corner() - glm::dvec3(3.0);
  if (direction != glm::dvec3(0.0)) result.direction = glm::normalize(direction);
  Corners corners;
  while (!bytes.at_end() && corners.size() < 3 * k_most_facets) {
    if (result.kind == MeshKind::loose_facets) {
      add_facet(corners, bytes, result.jitter == 0.0);
    } else if (result.kind == MeshKind::boxes) {
      add_box(corners, bytes);
    } else {
      add_tetrahedron(corners, bytes);
    }
  }
  if (result.kind == MeshKind::open_tetrahedra && !corners.empty())
    corners.erase(corners.begin(), corners.begin() + 3);
  result.mesh = weld_corners(corners);
  // After welding, so that bodies that share corners still do.
  test::Random random(static_cast<std::uint32_t>(data.size()));
  for (glm::dvec3& vertex : result.mesh.vertices) vertex += random.in_cube(result.jitter);
  return result;
}

}  // namespace moldlight::fuzz
