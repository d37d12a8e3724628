// Thick concave contour edges must be in the maps, for near-vertical neighbours too.
#include <cstdio>

#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

/// Undercut area that the maps alone find, less the true one, as a share of the part's area.
double undercut_bias(const test::Shape& shape, double edge_thickness) {
  Query query;
  query.direction = shape.direction;
  query.method.tau_deg = shape.settings.tau_deg;
  query.method.tolerance = shape.settings.lateral_tolerance;
  query.method.resolution = 64;
  query.method.readout = Readout::samples;
  query.method.edge_thickness = edge_thickness;
  const Classification result = test::classify_mesh(shape.mesh, query);
  return (result.areas[Region::undercut] - shape.expected[Region::undercut]) / result.total_area;
}

// The ceiling of a blind side pocket meets a vertical wall: without its extension the maps end at the wall,
// and the half texel of the pocket's floor beside it reads as lit.
TEST(ThickEdges, CloseTheLeakAtNearVerticalNeighbours) {
  const test::Shape pocket = test::plate_with_side_pocket({.tau_deg = 1.0, .lateral_tolerance = 0.4});
  const double with = undercut_bias(pocket, 2.0), without = undercut_bias(pocket, 0.0);
  std::printf("undercut bias with edges %.5f, without %.5f\n", with, without);
  EXPECT_LT(without, -0.002);
  EXPECT_GT(with, 0.6 * without);
}

// The same where the ceiling meets a slanted facet that faces the other way.
TEST(ThickEdges, CloseTheLeakAtSlantedNeighbours) {
  const test::Shape slot = test::dovetail_slot({.tau_deg = 1.0, .lateral_tolerance = 0.4});
  const double with = undercut_bias(slot, 2.0), without = undercut_bias(slot, 0.0);
  std::printf("undercut bias with edges %.5f, without %.5f\n", with, without);
  EXPECT_LT(without, -0.002);
  EXPECT_GT(with, 0.6 * without);
}

// With the paper's symmetric kernel, positions inside the wall pass unless the edge at its foot covers them.
TEST(ThickEdges, KeepTheSymmetricKernelOutOfTheSolid) {
  const test::Shape cup = test::cup({.tau_deg = 1.0, .lateral_tolerance = 0.02});
  Query query;
  query.direction = cup.direction;
  query.method.resolution = 256;
  query.method.readout = Readout::samples;
  query.method.kernel_shape = KernelShape::symmetric;
  const auto wrong = [&](double edge_thickness) {
    query.method.edge_thickness = edge_thickness;
    return test::worst_region_error(test::classify_mesh(cup.mesh, query), cup.expected);
  };
  EXPECT_GT(wrong(0.0), 0.1);
  EXPECT_LT(wrong(4.0), 0.04);
}

}  // namespace
}  // namespace moldlight
