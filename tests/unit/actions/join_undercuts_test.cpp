// What counts as one undercut: pieces that touch, or nearly.
#include <gtest/gtest.h>

#include "actions/undercut.hpp"
#include "mold/exact/exact_regions.hpp"
#include "mold/exact/split_mesh.hpp"
#include "support/classify_mesh.hpp"

namespace moldlight {
namespace {

/// Two upright facets of 8 by 10 beside each other, with a gap between their nearest corners, as undercut.
std::size_t undercuts_of_two(double begin, double gap) {
  TriangleMesh mesh;
  for (const double x : {begin, begin + 8.0 + gap}) {
    const auto first = static_cast<VertexIndex>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {x + 8.0, 0, 0}, {x, 0, 10}});
    mesh.facets.push_back({first, first + 1, first + 2});
  }
  SplitMesh split{.vertices = mesh.vertices, .pieces = {}};
  for (FacetIndex facet = 0; facet < 2; ++facet)
    split.pieces.push_back({.corners = mesh.facets[facet], .facet = facet, .region = Region::undercut});
  const auto model = test::model_of(mesh);
  const ExactQuery query{.direction = {0, 0, 1}, .tau_deg = 0.0, .lateral = 0.2 / model->frame.diagonal};
  const Undercuts found = find_undercuts(*model, split, query, Progress{});
  return found.counted.size() + found.specks.size();
}

/// However the cells of the grid lie in which corners are looked for: as wide as twice the tolerance.
TEST(JoinUndercuts, WithinTwiceTheLateralToleranceTheyAreOne) {
  for (int k = 0; k < 8; ++k) {
    const double begin = 0.05 * k;
    EXPECT_EQ(undercuts_of_two(begin, 0.3), 1U) << begin;
    EXPECT_EQ(undercuts_of_two(begin, 0.5), 2U) << begin;
  }
}

}  // namespace
}  // namespace moldlight
