#include "mesh/file_order.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/facet_geometry.hpp"
#include "mesh/weld.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

Part part_of(const TriangleMesh& mesh) {
  Part part;
  part.mesh = weld_vertices(mesh);
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  return part;
}

const TriangleMesh& some_mesh() {
  static const TriangleMesh mesh = test::all_shapes({}).front().mesh;
  return mesh;
}

TEST(FileOrder, PlaceOrderIsTheSameForEveryOrderOfTheFile) {
  Part own = part_of(some_mesh());
  put_in_place_order(own);
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    Part other = part_of(test::permuted(some_mesh(), seed));
    ASSERT_NE(other.mesh.facets, own.mesh.facets);
    put_in_place_order(other);
    EXPECT_EQ(other.mesh.vertices, own.mesh.vertices);
    EXPECT_EQ(other.mesh.facets, own.mesh.facets);
    EXPECT_NE(other.file_facets, own.file_facets);
  }
}

TEST(FileOrder, TheMeshIsListedAsTheFileDoes) {
  const Part as_read = part_of(test::permuted(some_mesh(), 7));
  Part part = as_read;
  put_in_place_order(part);
  put_in_place_order(part);
  const TriangleMesh listed = mesh_as_listed(part);
  ASSERT_EQ(listed.facets.size(), as_read.mesh.facets.size());
  EXPECT_EQ(listed.vertices.size(), as_read.mesh.vertices.size());
  for (FacetIndex facet = 0; facet < listed.facets.size(); ++facet) {
    // But for the corner that it begins with.
    std::size_t first = 0;
    while (first < 3 && listed.corner(facet, static_cast<int>(first)) != as_read.mesh.corner(facet, 0))
      ++first;
    ASSERT_LT(first, 3U);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(listed.corner(facet, static_cast<int>((first + k) % 3)),
                as_read.mesh.corner(facet, static_cast<int>(k)));
  }
  EXPECT_EQ(as_listed(part, facet_geometry(part.mesh).areas).size(), listed.facets.size());
}

TEST(FileOrder, BodiesAndSourcesKeepTheirFacets) {
  Part part = part_of(some_mesh());
  const auto count = static_cast<FacetIndex>(part.mesh.facets.size());
  part.bodies = {{"a", 0, 4}, {"b", 4, count - 4}};
  for (FacetIndex facet = 0; facet < count; ++facet) part.facet_source.push_back(100 + facet);
  put_in_place_order(part);
  for (FacetIndex facet = 0; facet < count; ++facet) {
    EXPECT_EQ(part.facet_source[facet], 100 + part.file_facets[facet]);
    EXPECT_EQ(facet < 4, part.file_facets[facet] < 4);
    EXPECT_EQ(file_facet(part, facets_as_listed(part)[facet]), facet);
  }
}

}  // namespace
}  // namespace moldlight
