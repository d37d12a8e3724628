#include "mesh/place_order.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include <gtest/gtest.h>

#include "mesh/adjacency.hpp"
#include "mesh/faces.hpp"
#include "mesh/facet_geometry.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

Part part_of(TriangleMesh mesh) {
  Part part;
  part.mesh = std::move(mesh);
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  return part;
}

Part ordered(Part part) {
  put_in_place_order(part, Progress());
  return part;
}

/// To the bit.
void expect_same_mesh(const TriangleMesh& a, const TriangleMesh& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.facets, b.facets);
}

TEST(PlaceOrder, IsTheSameWhateverTheFileLists) {
  const TriangleMesh mesh = test::snap_hook({}).mesh;
  const Part known = ordered(part_of(mesh));
  for (const std::uint32_t seed : {1U, 2U, 3U})
    expect_same_mesh(ordered(part_of(test::permuted(mesh, seed))).mesh, known.mesh);
}

TEST(PlaceOrder, GrowsWithThePart) {
  const TriangleMesh mesh = test::cup_with_side_hole({}).mesh;
  const Part known = ordered(part_of(mesh)), large = ordered(part_of(test::scaled(mesh, 1024.0)));
  EXPECT_EQ(large.mesh.facets, known.mesh.facets);
  EXPECT_EQ(large.file_facets, known.file_facets);
}

TEST(PlaceOrder, KeepsTheSurfaceAndWhereItComesFrom) {
  const TriangleMesh mesh = test::permuted(test::cup_with_side_hole({}).mesh, 7);
  Part part = part_of(mesh);
  part.facet_source.resize(mesh.facets.size());
  std::iota(part.facet_source.begin(), part.facet_source.end(), 100U);
  const Part known = ordered(part);
  ASSERT_EQ(known.mesh.facets.size(), mesh.facets.size());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const FacetIndex listed = known.file_facets[facet];
    EXPECT_EQ(known.facet_source[facet], 100U + listed);
    EXPECT_EQ(file_facet(known, facet), listed);
    const auto corners = [](const TriangleMesh& of, FacetIndex k) {
      return std::array{of.corner(k, 0), of.corner(k, 1), of.corner(k, 2)};
    };
    const auto now = corners(known.mesh, facet);
    auto before = corners(mesh, listed);
    std::rotate(before.begin(), std::ranges::find(before, now[0]), before.end());
    EXPECT_EQ(now, before) << "facet " << listed << " winds as it did";
  }
  const std::vector<FacetIndex> listed = listed_facets(known);
  for (FacetIndex k = 0; k < listed.size(); ++k) EXPECT_EQ(known.file_facets[listed[k]], k);
}

TEST(PlaceOrder, KeepsBodiesApartAndWhatARepairAddedLast) {
  Part part;
  part.mesh.vertices = {{9, 0, 0}, {8, 0, 0}, {9, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  part.mesh.facets = {{0, 1, 2}, {5, 6, 4}, {3, 4, 5}, {3, 5, 6}};
  part.bodies = {{"far", 0, 1}, {"near", 1, 3}};
  part.file_facets = {4, 7, k_no_facet, 5};
  const Part known = ordered(part);
  EXPECT_EQ(known.file_facets[0], 4U);
  EXPECT_EQ(known.mesh.corner(0, 0).x, 8.0) << "the first on the curve";
  std::vector<std::int64_t> listed;
  for (const FacetIndex facet : listed_facets(known)) listed.push_back(file_facet(known, facet));
  EXPECT_EQ(listed, (std::vector<std::int64_t>{4, 5, 7, -1}));
}

TEST(PlaceOrder, NumbersFacesAsTheFileListsThem) {
  const TriangleMesh mesh = test::permuted(test::box_shape({}).mesh, 5);
  const auto faces_of = [](const Part& part) {
    const FacetGeometry geometry = facet_geometry(part.mesh);
    return part_faces(part, geometry, build_adjacency(part.mesh));
  };
  const Part as_read = part_of(mesh), known = ordered(as_read);
  const Faces before = faces_of(as_read), now = faces_of(known);
  ASSERT_EQ(now.count(), before.count());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet)
    EXPECT_EQ(now.of_facet[facet], before.of_facet[known.file_facets[facet]]);
}

}  // namespace
}  // namespace moldlight
