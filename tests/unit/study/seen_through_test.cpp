// A wall that a half sees only through a hole, across the room of a slide: the slide forms it, and the half's
// pin ends at the hole's rim.
#include "parting/seen_through.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "parting/mold_pieces.hpp"
#include "parting/planar_line.hpp"
#include "parting/slide_blank.hpp"
#include "study/study.hpp"
#include "support/box_pile.hpp"

namespace moldlight {
namespace {

/// A block with a square bore along y, and a hole from above into it.
TriangleMesh block_with_oil_hole(bool blind) {
  test::BoxPile pile;
  pile.planes = {{{0, 10, 13, 17, 20, 30}, {0, 2, 8, 12, 20}, {0, 5, 15, 20}}};
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 3; ++z) {
        const bool bore = x > 0 && x < 4 && z == 1 && !(blind && y == 0), hole = x == 2 && y == 2 && z == 2;
        pile.filled.push_back(bore || hole ? 0 : 1);
      }
    }
  }
  return test::pile_mesh(pile, 3);
}

Study study_with_oil_hole(bool blind) {
  Part part;
  part.unit = "mm";
  part.mesh = block_with_oil_hole(blind);
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  Questions questions;
  questions.with_actions = true;
  return Study(prepare_part(std::move(part), Progress()), questions);
}

TEST(SeenThrough, IsTheSlidesSurface) {
  for (const bool blind : {false, true}) {
    Study study = study_with_oil_hole(blind);
    const Assignment& sides = study.find<MoldLine>(Progress()).assignment;
    ASSERT_EQ(sides.seen_through.size(), 1U);
    double area = 0.0;
    for (const PieceIndex piece : sides.seen_through[0].pieces) {
      area += 0.5 * glm::length(twice_piece_area(sides.mesh, piece));
      EXPECT_EQ(sides.sides[piece], MoldSide::action);
      EXPECT_NEAR(sides.mesh.middle(piece).z, 5.0, 1e-9);
    }
    EXPECT_NEAR(area, 16.0, 1e-9);
    const glm::dvec3& way = sides.seen_through[0].way;
    EXPECT_NEAR(blind ? way.y : std::abs(way.y), 1.0, 1e-9);
  }
}

TEST(SeenThrough, EndsTheHalfsPinAtTheHolesRim) {
  Study study = study_with_oil_hole(true);
  // Without slides, too: what they would form is an insert that fills the bore.
  const MoldHalves& plain = study.find<MoldHalves>(Progress());
  ASSERT_EQ(plain.inserts.size(), 1U);
  EXPECT_NEAR(plain.inserts[0].volume, 10.0 * 10.0 * 18.0, 1e-6);
  for (const glm::dvec3& vertex : plain.written.bodies[0].mesh.vertices) {
    const bool in_hole = vertex.x > 12.0 && vertex.x < 18.0 && vertex.y > 7.0 && vertex.y < 13.0;
    EXPECT_GT(vertex.z, in_hole ? 14.999 : -INFINITY);
  }
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  const MoldHalves& halves = pieces.halves;
  ASSERT_EQ(halves.count(PieceKind::slide), 1U) << (pieces.unmade.empty() ? "" : pieces.unmade[0].why);
  ASSERT_EQ(halves.inserts.size(), 1U);
  EXPECT_TRUE(halves.certified());
  EXPECT_LE(std::abs(halves.volume_gap), 1e-9);
  // All of the bore.
  const TriangleMesh& slide = halves.written.bodies[2].mesh;
  EXPECT_GE(halves.inserts[0].volume, 10.0 * 10.0 * 18.0);
  for (const std::size_t half : {0U, 1U})
    EXPECT_LE(way_out(slide, halves.written.bodies[half].mesh, {0, 1, 0}).blocked, 0.02);
}

}  // namespace
}  // namespace moldlight
