#include "support/boxes.hpp"

#include <utility>

#include <fmt/format.h>

#include "mesh/weld.hpp"

namespace moldlight::test {

std::vector<glm::dvec3> box_corners(const glm::dvec3& low, const glm::dvec3& high) {
  // Bit 0, 1, 2 of a corner's number: high x, y, z.
  const auto corner = [&](int number) {
    return glm::dvec3((number & 1) != 0 ? high.x : low.x, (number & 2) != 0 ? high.y : low.y,
                      (number & 4) != 0 ? high.z : low.z);
  };
  constexpr int k_quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::vector<glm::dvec3> corners;
  for (const auto& quad : k_quads) {
    for (const int place : {0, 1, 2, 0, 2, 3}) corners.push_back(corner(quad[place]));
  }
  return corners;
}

std::string obj_of_boxes(int count) {
  std::string text;
  int vertices = 0;
  for (int n = 0; n < count; ++n) {
    const glm::dvec3 low(3 * (n % 10), 3 * (n / 10 % 10), 3 * (n / 100));
    const auto corners = box_corners(low, low + glm::dvec3(1 + n % 2));
    text += fmt::format("o body_{}\n", n + 1);
    for (const glm::dvec3& corner : corners)
      text += fmt::format("v {} {} {}\n", corner.x, corner.y, corner.z);
    for (std::size_t k = 0; k < corners.size(); k += 3, vertices += 3)
      text += fmt::format("f {} {} {}\n", vertices + 1, vertices + 2, vertices + 3);
  }
  return text;
}

TriangleMesh box_mesh(const glm::dvec3& low, const glm::dvec3& high) {
  return weld_corners(box_corners(low, high));
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh both = a;
  const auto offset = static_cast<VertexIndex>(a.vertices.size());
  both.vertices.insert(both.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& facet : b.facets)
    both.facets.push_back({facet[0] + offset, facet[1] + offset, facet[2] + offset});
  return both;
}

void reverse_facet(TriangleMesh& mesh, FacetIndex facet) {
  std::swap(mesh.facets[facet][1], mesh.facets[facet][2]);
}

}  // namespace moldlight::test
