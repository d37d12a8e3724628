// Pieces of facets tile the part, and each guide is on its piece.
#include "proof/surface_elements.hpp"

#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/proof_model.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

double area(const SurfaceElement& piece) {
  const auto& [a, b, c] = piece.corners;
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

TEST(SurfacePieces, TileThePart) {
  const test::ProofModel model(test::model_of(test::subdivided(test::snap_hook({}).mesh, 300)));
  const ProofPart& part = model.part();
  const double scale = model.model().frame.diagonal * model.model().frame.diagonal;
  const SurfacePieces surface = surface_pieces(part, 0.05, 100'000, {});
  ASSERT_EQ(surface.first.size(), part.mesh.facets.size() + 1);
  EXPECT_EQ(surface.first.back(), surface.pieces.size());
  for (FacetIndex facet = 0; facet < part.mesh.facets.size(); ++facet) {
    double noted = 0.0, found = 0.0;
    for (std::uint32_t k = surface.first[facet]; k < surface.first[facet + 1]; ++k) {
      EXPECT_EQ(surface.pieces[k].facet, facet);
      EXPECT_LE(surface.pieces[k].length, 0.05);
      noted += surface.pieces[k].area;
      found += scale * area(surface.pieces[k]);
    }
    EXPECT_NEAR(noted, part.geometry.areas[facet], 1e-9 * part.geometry.total_area);
    EXPECT_NEAR(found, part.geometry.areas[facet], 1e-9 * part.geometry.total_area);
  }
}

TEST(SurfacePieces, AreNoMoreThanAskedForButWholeFacets) {
  const test::ProofModel model(test::model_of(test::snap_hook({}).mesh));
  const std::size_t facets = model.part().mesh.facets.size();
  EXPECT_EQ(surface_pieces(model.part(), 0.01, 1, {}).pieces.size(), facets);
  EXPECT_LE(surface_pieces(model.part(), 0.01, 10 * facets, {}).pieces.size(), 11 * facets);
}

TEST(SurfacePieces, AreUnderTheirGuides) {
  const test::ProofModel model(test::model_of(test::snap_hook({}).mesh));
  const SurfacePieces surface = model.pieces(3000);
  ASSERT_EQ(surface.piece_of_guide.size(), surface.guides.size());
  for (std::size_t k = 0; k < surface.guides.size(); ++k) {
    const SurfaceElement& piece = surface.pieces[surface.piece_of_guide[k]];
    const glm::dvec3& guide = surface.guides[k].corners[0];
    EXPECT_EQ(piece.facet, surface.guides[k].facet);
    // The triangles between the guide and the piece's sides cover no more than the piece.
    double around = 0.0;
    for (std::size_t side = 0; side < 3; ++side) {
      SurfaceElement part = piece;
      part.corners[side] = guide;
      around += area(part);
    }
    EXPECT_NEAR(around, area(piece), 1e-5 * piece.length);
  }
}

}  // namespace
}  // namespace moldlight
