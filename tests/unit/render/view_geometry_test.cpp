// What pictures need of a part, made without GL.
#include "render/view_geometry.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "mold/exact/exact_regions.hpp"
#include "render/view_settings.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

TEST(Octahedral, KeepsDirectionsToAHundredthOfADegree) {
  for (int k = 0; k < 2000; ++k) {
    const float z = 1.0F - 2.0F * (static_cast<float>(k) + 0.5F) / 2000.0F;
    const float angle = 2.4F * static_cast<float>(k), radius = std::sqrt(1.0F - z * z);
    const glm::vec3 unit(radius * std::cos(angle), radius * std::sin(angle), z);
    EXPECT_LT(glm::distance(from_octahedral(octahedral(unit)), unit), 1.5e-4F);
  }
  for (const glm::vec3& axis : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(-1, 0, 0)}) {
    EXPECT_LT(glm::distance(from_octahedral(octahedral(axis)), axis), 1e-4F);
  }
}

struct Made {
  explicit Made(const TriangleMesh& mesh)
      : geometry(facet_geometry(mesh)),
        adjacency(build_adjacency(mesh)),
        frame(unit_frame(bounds(mesh))),
        view(view_geometry(mesh, geometry, adjacency, frame)) {}
  FacetGeometry geometry;
  Adjacency adjacency;
  UnitFrame frame;
  ViewGeometry view;
};

TEST(ViewGeometry, BoxHasItsEdgesItsCornersAndIsClosed) {
  const test::Shape box = test::box_shape({});
  const Made made(box.mesh);
  EXPECT_TRUE(made.view.closed);
  EXPECT_EQ(made.view.feature_edges.size(), 12U);
  EXPECT_EQ(made.view.extremes.size(), 8U);
  EXPECT_EQ(made.view.facets.size(), box.mesh.facets.size());
  TriangleMesh open = box.mesh;
  open.facets.pop_back();
  EXPECT_FALSE(Made(open).view.closed);
}

/// Segments of the parting line along z.
std::vector<ViewSegment> line_of(const TriangleMesh& mesh) {
  const Made made(mesh);
  const ExactPart part(mesh, made.geometry, made.frame, Progress{});
  const SplitMesh split = exact_split(part, {.direction = {0, 0, 1}, .lateral = 1e-3}, Progress{}).mesh;
  return parting_line(split, made.frame);
}

TEST(ViewGeometry, ThePartingLineRunsAroundRoundWallsAndNotUpThem) {
  const test::Loop2 outline = test::regular_polygon(64, 8.0), narrow = test::regular_polygon(64, 7.0);
  for (const bool drafted : {false, true}) {
    test::SolidBuilder solid;
    const test::Loop low = test::at_height(outline, 0.0),
                     high = test::at_height(drafted ? narrow : outline, 9.0);
    solid.face({low.rbegin(), low.rend()});
    solid.face(high);
    solid.walls(low, high);
    const std::vector<ViewSegment> line = line_of(solid.mesh());
    // Where a wall may be formed by either half, both its ends are where they can meet.
    EXPECT_EQ(line.size(), drafted ? 64U : 128U);
    for (const ViewSegment& segment : line) EXPECT_EQ(segment.start.z, segment.end.z);
  }
}

TEST(ViewGeometry, ThePartingLineLeavesUndercutsOut) {
  test::SolidBuilder solid;
  solid.extrude({{0, 0}, {10, 0}, {10, 9}, {0, 9}, {0, 6}, {6, 6}, {6, 3}, {0, 3}}, {}, 5.0);
  const std::vector<ViewSegment> line = line_of(solid.mesh());
  EXPECT_FALSE(line.empty());
  const auto height = [&](float z) {
    return std::abs(z * static_cast<float>(std::sqrt(10.0 * 10.0 + 9.0 * 9.0 + 5.0 * 5.0)));
  };
  for (const ViewSegment& segment : line) {
    EXPECT_NEAR(height(segment.start.z), 4.5F, 1e-4F) << "the groove is not outlined";
    EXPECT_NEAR(height(segment.end.z), 4.5F, 1e-4F);
  }
}

TEST(ViewArrow, StandsClearOfThePart) {
  const Made made(test::cup({}).mesh);
  for (const glm::dvec3& toward : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(0.6, 0.0, 0.8)}) {
    const ViewArrow arrow = parting_arrow(made.view.extremes, toward, 0.0);
    double top = -1.0;
    for (const ViewVertex& vertex : made.view.vertices)
      top = std::max(top, glm::dot(glm::dvec3(vertex.position), toward));
    EXPECT_GT(glm::dot(arrow.tail, toward), top);
    EXPECT_LT(glm::dot(arrow.tail, toward), top + 0.1);
    EXPECT_NEAR(glm::distance(parting_arrow(made.view.extremes, toward, 0.6).tip, arrow.tip), 0.3, 1e-12);
  }
}

TEST(DraftScale, HasTheNearVerticalBandInTheMiddle) {
  for (const double tau : {0.0, 1.0, 8.0}) {
    const DraftScale scale = draft_scale(tau, Palette::paper);
    EXPECT_DOUBLE_EQ(scale.limits_deg[3], tau);
    for (std::size_t i = 1; i < scale.limits_deg.size(); ++i) {
      EXPECT_LE(scale.limits_deg[i - 1], scale.limits_deg[i]);
    }
  }
}

}  // namespace
}  // namespace moldlight
