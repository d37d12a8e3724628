// A split surface as pictures draw it: the part's own corners and light, and every piece's source.
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "render/view_geometry.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

/// A ring whose every third facet is cut from the middle of its first side to the opposite corner.
struct Cut {
  Cut()
      : mesh(test::ring({}).mesh),
        geometry(facet_geometry(mesh)),
        frame(unit_frame(bounds(mesh))),
        view(view_geometry(mesh, geometry, build_adjacency(mesh), frame)) {
    split.vertices = mesh.vertices;
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      const auto& [a, b, c] = mesh.facets[facet];
      if (facet % 3 != 0) {
        split.pieces.push_back({{a, b, c}, facet, Region::both});
        continue;
      }
      const auto middle = static_cast<VertexIndex>(split.vertices.size());
      split.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
      split.pieces.push_back({{a, middle, c}, facet, Region::core});
      split.pieces.push_back({{middle, b, c}, facet, Region::undercut});
    }
  }
  TriangleMesh mesh;
  FacetGeometry geometry;
  UnitFrame frame;
  ViewGeometry view;
  SplitMesh split;
};

TEST(SplitGeometry, KeepsWholeFacetsAndInterpolatesOverCutOnes) {
  const Cut cut;
  const SplitGeometry found = split_geometry(cut.split, cut.mesh, cut.view, cut.frame);
  ASSERT_EQ(found.pieces.size(), cut.split.pieces.size());
  ASSERT_EQ(found.sources.size(), found.pieces.size());
  const std::size_t cuts = cut.split.vertices.size() - cut.mesh.vertices.size();
  EXPECT_GT(cuts, 20U);
  EXPECT_EQ(found.vertices.size(), cut.view.vertices.size() + cuts) << "two pieces of a facet share its cut";
  for (std::size_t k = 0; k < found.pieces.size(); ++k) {
    const SplitPiece& piece = cut.split.pieces[k];
    const auto& corners = cut.view.facets[piece.facet];
    const std::uint32_t bits = piece.region == Region::both ? 3 : piece.region == Region::core ? 1 : 0;
    EXPECT_EQ(found.sources[k], piece.facet | bits << 30);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(found.vertices[found.pieces[k][corner]].position,
                cut.frame.to_unit(cut.split.vertices[piece.corners[corner]]));
    }
    if (piece.region == Region::both) {
      EXPECT_EQ(found.pieces[k], corners);
      continue;
    }
    const ViewVertex& middle = found.vertices[found.pieces[k][piece.region == Region::core ? 1 : 0]];
    const glm::vec3 between = glm::normalize(from_octahedral(cut.view.vertices[corners[0]].normal) +
                                             from_octahedral(cut.view.vertices[corners[1]].normal));
    EXPECT_LT(glm::distance(from_octahedral(middle.normal), between), 3e-4F);
  }
}

TEST(SplitGeometry, AVertexInsideAFacetBelongsToThatFacetAlone) {
  const Cut cut;
  SplitMesh split = cut.split;
  // The same vertex named by another facet gets a copy of its own there.
  const auto last = static_cast<VertexIndex>(split.vertices.size() - 1);
  split.pieces.push_back({{cut.mesh.facets[1][0], cut.mesh.facets[1][1], last}, 1, Region::cavity});
  const SplitGeometry found = split_geometry(split, cut.mesh, cut.view, cut.frame);
  EXPECT_EQ(found.vertices.size(),
            cut.view.vertices.size() + split.vertices.size() - cut.mesh.vertices.size() + 1);
  EXPECT_EQ(found.sources.back(), 1U | 2U << 30);
}

}  // namespace
}  // namespace moldlight
