// Facets that cross others by rounding are moved apart; those that cross by more stay, and are not certified.
#include <cmath>

#include <gtest/gtest.h>

#include "parting/halves/tidy_solid.hpp"
#include "parting/mold_files.hpp"
#include "parting/mold_report.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

constexpr double k_step = 0x1p-17;  // of coordinates from 64 to 128 in single precision

/// A slab and a pyramid that stands on its tip, `deep` in the slab's top.
TriangleMesh tip_in_slab(double deep) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {100, 100, 10});
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  for (const glm::dvec3& corner : {glm::dvec3(48, 31, 10 - deep), {40, 30, 80}, {60, 25, 80}, {50, 45, 80}})
    mesh.vertices.push_back(corner);
  for (const auto& [a, b, c] : {std::array{0U, 2U, 1U}, {0U, 3U, 2U}, {0U, 1U, 3U}, {1U, 2U, 3U}})
    mesh.facets.push_back({first + a, first + b, first + c});
  return mesh;
}

TEST(Uncross, MovesWhatCrossesByRoundingApart) {
  const TriangleMesh before = tip_in_slab(k_step);
  ASSERT_FALSE(crossed_facets(before, Progress()).empty());
  TriangleMesh mesh = before;
  EXPECT_TRUE(uncross(mesh, {.tolerance = 2.0 * k_step, .pull = {0, 0, 1}}, crossed_facets(mesh, Progress()),
                      Progress())
                  .empty());
  EXPECT_TRUE(crossed_facets(mesh, Progress()).empty());
  EXPECT_EQ(mesh.facets, before.facets);
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
    const glm::dvec3 way = mesh.vertices[k] - before.vertices[k];
    EXPECT_EQ(glm::dvec2(way), glm::dvec2(0.0)) << k;
    EXPECT_LE(std::abs(way.z), 2.0 * k_step) << k;
    EXPECT_EQ(glm::dvec3(glm::vec3(mesh.vertices[k])), mesh.vertices[k]) << "single precision";
  }
}

TEST(Uncross, LeavesWhatCrossesByMore) {
  const TriangleMesh before = tip_in_slab(1.0);
  TriangleMesh mesh = before;
  EXPECT_FALSE(uncross(mesh, {.tolerance = 2.0 * k_step, .pull = {0, 0, 1}}, crossed_facets(mesh, Progress()),
                       Progress())
                   .empty());
  EXPECT_EQ(mesh.facets, before.facets);
}

TEST(PutBody, TakesWhatCanBeMendedAndLeavesTheRestAsItWas) {
  MoldHalves halves;
  halves.written.bodies.resize(2);
  const auto put = [&](const TriangleMesh& mesh) {
    return put_body(halves, 2 + halves.inserts.size(), {.mesh = mesh, .name = "insert"}, 1e-9, Progress());
  };
  EXPECT_FALSE(put(tip_in_slab(1.0)));
  TriangleMesh open = test::box_mesh({0, 0, 0}, {1, 1, 1});
  open.facets.pop_back();
  EXPECT_FALSE(put(open));
  EXPECT_TRUE(halves.inserts.empty());
  EXPECT_EQ(halves.written.bodies.size(), 2U);
  EXPECT_TRUE(put(tip_in_slab(k_step)));
  ASSERT_EQ(halves.inserts.size(), 1U);
  ASSERT_EQ(halves.written.bodies.size(), 3U);
  EXPECT_TRUE(crossed_facets(halves.written.bodies[2].mesh, Progress()).empty());
  // Another in its place, that fails.
  EXPECT_FALSE(put_body(halves, 2, {.mesh = tip_in_slab(1.0), .name = "other"}, 1e-9, Progress()));
  EXPECT_EQ(halves.inserts[0].name, "insert");
  EXPECT_EQ(halves.written.bodies[2].name, "insert");
}

TEST(Certificate, IsNotGivenToHalvesThatCrossOrTouchThemselves) {
  MoldHalves halves;
  EXPECT_TRUE(halves.certified());
  Part part;
  part.mesh = test::box_mesh({0, 0, 0}, {30, 20, 10});
  const auto model = prepare_part(std::move(part), Progress());
  EXPECT_TRUE(half_faults(*model, halves).empty());
  halves.core.crossed_facets = 1;
  halves.core.crossed_at = glm::dvec3(1, 2, 3);
  halves.cavity.nonmanifold_edges = 3;
  EXPECT_FALSE(halves.certified());
  const std::vector<std::string> faults = half_faults(*model, halves);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0], "1 facet of the core crosses others by rounding, near 1, 2, 3");
  EXPECT_EQ(faults[1], "the cavity touches itself in 3 edges");
  halves.core.crossed_facets = 0;
  EXPECT_FALSE(halves.certified());
  halves.cavity.nonmanifold_edges = 0;
  EXPECT_TRUE(halves.certified());
}

}  // namespace
}  // namespace moldlight
