// Solids as STEP, read again by OpenCASCADE.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "io/mesh_writer.hpp"
#include "io/part_formats.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "support/boxes.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

class SolidsAsStep : public testing::Test {
 protected:
  void SetUp() override {
    if (!MOLDLIGHT_STEP_BUILT) GTEST_SKIP() << "built without STEP support";
  }
  [[nodiscard]] Part read_again(std::span<const NamedSolid> solids, const std::string& unit) {
    write_solids_step(path, "mold", solids, unit);
    return read_part(path, {}, Progress());
  }

  test::ScratchFolder folder;
  std::string path = folder.file("mold.step");
};

TEST_F(SolidsAsStep, AreTheSameBodies) {
  const TriangleMesh core = test::box_mesh({0, 0, 0}, {3, 2, 1});
  TriangleMesh inner = test::box_mesh({1, 1, 3}, {2, 2, 4});
  for (FacetIndex facet = 0; facet < inner.facets.size(); ++facet) test::reverse_facet(inner, facet);
  const TriangleMesh cavity = test::joined(test::box_mesh({0, 0, 2}, {3, 3, 5}), inner);
  const std::array solids = {NamedSolid{"core", &core, {0, 0, 255}}, NamedSolid{"cavity", &cavity}};
  const Part part = read_again(solids, "in");
  EXPECT_EQ(part.unit, "mm");
  ASSERT_EQ(part.bodies.size(), 2U);
  EXPECT_EQ(part.bodies[0].name, "core");
  EXPECT_EQ(part.bodies[1].name, "cavity");
  EXPECT_TRUE(health_report(part.mesh, facet_geometry(part.mesh)).closed);
  const double cubic_inch = 25.4 * 25.4 * 25.4;
  EXPECT_NEAR(signed_volume(part.mesh), (6.0 + 27.0 - 1.0) * cubic_inch, 1e-9 * cubic_inch);
  // A box has six faces, the one with a hollow twelve.
  ASSERT_TRUE(part.has_cad_faces);
  ASSERT_FALSE(part.facet_source.empty());
  EXPECT_EQ(*std::ranges::max_element(part.facet_source) + 1, 18U);
  EXPECT_NE(test::file_bytes(path).find("COLOUR_RGB('',0.,0.,1.)"), std::string::npos);
}

TEST_F(SolidsAsStep, StandBesideSurfaces) {
  const TriangleMesh core = test::box_mesh({0, 0, 0}, {1, 1, 1});
  TriangleMesh surface;
  surface.vertices = {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
  surface.facets = {{0, 1, 2}, {0, 2, 3}};
  const std::array solids = {NamedSolid{.name = "it's the core", .mesh = &core},
                             NamedSolid{.name = "between", .mesh = &surface, .closed = false}};
  const Part part = read_again(solids, "mm");
  ASSERT_EQ(part.bodies.size(), 2U);
  EXPECT_NEAR(facet_geometry(part.mesh).total_area, 6.0 + 4.0, 1e-9);
  EXPECT_NE(test::file_bytes(path).find("MANIFOLD_SOLID_BREP('it_s the core',"), std::string::npos);
}

}  // namespace
}  // namespace moldlight
