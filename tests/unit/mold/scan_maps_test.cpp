// The scan converter by itself: what does not need another one to compare with.
#include "mold/scan/scan_maps.hpp"

#include <cstring>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/adjacency.hpp"
#include "mesh/health.hpp"
#include "support/boxes.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

/// A mesh with what scan conversion needs of it.
struct Prepared {
  explicit Prepared(TriangleMesh of_mesh)
      : mesh(std::move(of_mesh)),
        geometry(facet_geometry(mesh)),
        edges(bent_edges(mesh, geometry, build_adjacency(mesh))),
        part(mesh, geometry, unit_frame(bounds(mesh)), edges.concave) {}

  TriangleMesh mesh;
  FacetGeometry geometry;
  BentEdges edges;
  ScanPart part;
};

std::vector<glm::dvec3> directions() {
  return {{0, 0, 1}, {1, 0, 0}, {0.36, 0.48, 0.8}, {-0.7, 0.1, -0.2}, {0.001, 0.6, 0.0004}};
}

std::vector<std::uint32_t> entries(const ScanMaps& maps) {
  std::vector<std::uint32_t> all;
  for (const bool plus : {true, false}) {
    for (int y = 0; y < maps.resolution(); ++y) {
      for (int x = 0; x < maps.resolution(); ++x) all.push_back(maps.entry(plus, x, y));
    }
  }
  return all;
}

bool same_sums(const ScanMaps& a, const ScanMaps& b, std::size_t clusters) {
  bool same = true;
  for (std::size_t i = 0; i < 2 * clusters; ++i) {
    const scan::ClusterSums &left = a.sums().clusters[i], &right = b.sums().clusters[i];
    same = same && left.fragments == right.fragments && left.weight == right.weight &&
           left.hidden_weight == right.hidden_weight;
  }
  return same;
}

TEST(ScanMapsAlone, AllKernelsGiveTheSameBits) {
  for (const test::Shape& shape : {test::snap_hook({}), test::hollow_sphere({}), test::thin_rib({})}) {
    for (const std::size_t facets : {500U, 30'000U}) {
      const Prepared prepared(test::subdivided(shape.mesh, facets));
      ScanMaps portable(300, scan::k_portable_kernel);
      for (const scan::Kernel* kernel : scan::kernels()) {
        ScanMaps other(300, *kernel);
        for (const glm::dvec3& direction : directions()) {
          portable.draw(prepared.part, map_frame(direction), {});
          other.draw(prepared.part, map_frame(direction), {});
          EXPECT_EQ(entries(portable), entries(other)) << shape.name << ", " << kernel->name;
          EXPECT_TRUE(same_sums(portable, other, prepared.part.clusters().all.size())) << shape.name;
        }
      }
    }
  }
}

TEST(ScanMapsAlone, FrontsAloneGiveTheSameSums) {
  for (const std::size_t facets : {500U, 30'000U}) {
    const Prepared prepared(test::subdivided(test::snap_hook({}).mesh, facets));
    ScanMaps whole(300), portable_fronts(300, scan::k_portable_kernel), fronts(300);
    for (const glm::dvec3& direction : directions()) {
      constexpr double k_never = 2.0;
      whole.draw(prepared.part, map_frame(direction), {});
      EXPECT_TRUE(whole.has_second_depth());
      for (ScanMaps* maps : {&fronts, &portable_fronts}) {
        maps->draw(prepared.part, map_frame(direction), {.second_depth_from = k_never});
        EXPECT_FALSE(maps->has_second_depth());
        EXPECT_TRUE(same_sums(whole, *maps, prepared.part.clusters().all.size()));
        EXPECT_EQ(whole.shadow_area(), maps->shadow_area());
      }
    }
  }
}

TEST(ScanMapsAlone, SecondDepthAloneGivesTheSameEntries) {
  for (const std::size_t facets : {500U, 30'000U}) {
    const Prepared prepared(test::subdivided(test::snap_hook({}).mesh, facets));
    ScanMaps whole(300);
    for (const scan::Kernel* kernel : scan::kernels()) {
      ScanMaps second(300, *kernel);
      for (const glm::dvec3& direction : directions()) {
        whole.draw(prepared.part, map_frame(direction), {});
        second.draw_second_depth(prepared.part, map_frame(direction), {});
        EXPECT_EQ(entries(whole), entries(second));
        std::vector<std::uint32_t> copied[2];
        second.copy_entries(true, copied[0]);
        second.copy_entries(false, copied[1]);
        copied[0].insert(copied[0].end(), copied[1].begin(), copied[1].end());
        EXPECT_EQ(entries(second), copied[0]);
      }
    }
  }
}

TEST(ScanMapsAlone, DoNotDependOnWhatWasDrawnBefore) {
  const Prepared prepared(test::subdivided(test::snap_hook({}).mesh, 3000));
  ScanMaps used(128), fresh(128);
  fresh.draw(prepared.part, map_frame({0.36, 0.48, 0.8}), {});
  // More often than there are generations.
  for (int i = 0; i < 300; ++i) {
    used.draw(prepared.part, map_frame({std::sin(i), std::cos(i), 0.01 * i}), {});
    if (i % 37 != 0) continue;
    used.draw(prepared.part, map_frame({0.36, 0.48, 0.8}), {});
    EXPECT_EQ(entries(used), entries(fresh)) << i;
    EXPECT_TRUE(same_sums(used, fresh, prepared.part.clusters().all.size())) << i;
  }
}

TEST(ScanMapsAlone, ConvexPartsCoverEachTexelOnceFromEitherSide) {
  const Prepared box(test::subdivided(test::box_mesh({-3, -2, -1}, {3, 2, 1}), 20'000));
  for (const int resolution : {16, 100, 512, 1500}) {
    ScanMaps maps(resolution);
    for (const glm::dvec3& direction : directions()) {
      maps.draw(box.part, map_frame(direction), {.edge_thickness = 0.0});
      const scan::RasterSums& sums = maps.sums();
      EXPECT_EQ(sums.hidden[0] + sums.hidden[1], 0U);
      EXPECT_EQ(sums.fragments[0], sums.fragments[1]);
      std::uint64_t present[2] = {};
      for (int y = 0; y < resolution; ++y) {
        for (int x = 0; x < resolution; ++x) {
          for (const bool plus : {false, true}) present[plus ? 1 : 0] += maps.entry(plus, x, y) != 0 ? 1 : 0;
        }
      }
      EXPECT_EQ(present[0], sums.fragments[0]);
      EXPECT_EQ(present[1], sums.fragments[0]);
      // The shadow is half of what the facets project.
      const double perimeter_texels = 8.0 * resolution;
      EXPECT_NEAR(maps.shadow_area(), 0.5 * maps.projected_area(),
                  perimeter_texels / resolution / resolution * 0.1 + 1e-6);
    }
  }
}

TEST(ScanMapsAlone, ClosedPartsAreEnteredAsOftenAsLeft) {
  for (const test::Shape& shape : test::all_shapes({})) {
    const Prepared prepared(shape.mesh);
    ASSERT_TRUE(health_report(prepared.mesh, prepared.geometry).closed) << shape.name;
    ScanMaps maps(256);
    for (const glm::dvec3& direction : directions()) {
      maps.draw(prepared.part, map_frame(direction), {});
      const scan::RasterSums& sums = maps.sums();
      EXPECT_EQ(sums.fragments[0], sums.fragments[1]) << shape.name;
      EXPECT_EQ(sums.hidden[0], sums.hidden[1]) << shape.name;
    }
  }
}

TEST(ScanMapsAlone, ClassesAreThoseOfDraft) {
  for (const double tau_deg : {0.0, 1.0, 1.0000001, 3.0}) {
    const test::Shape shape = test::frustum_over_tau({.tau_deg = 1.0});
    const Prepared prepared(test::subdivided(shape.mesh, 1000));
    ScanMaps maps(64);
    maps.draw(prepared.part, map_frame(shape.direction), {.tau_deg = tau_deg});
    const glm::dvec3 direction = maps.frame().z;
    double area = 0.0;
    std::size_t near_vertical = 0;
    for (FacetIndex facet = 0; facet < prepared.mesh.facets.size(); ++facet) {
      const FacetClass expected = facet_class(prepared.geometry.normals[facet], direction, tau_deg);
      EXPECT_EQ(maps.facet_class(facet), expected);
      if (expected != FacetClass::near_vertical) continue;
      ++near_vertical;
      area += static_cast<double>(prepared.part.areas()[facet]);
    }
    EXPECT_EQ(maps.near_vertical().size(), near_vertical);
    EXPECT_NEAR(maps.class_area(FacetClass::near_vertical), area, 1e-6);
  }
}

TEST(ScanMapsAlone, DegenerateFacetsDoNoHarm) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  const Prepared whole(mesh);
  mesh.facets.push_back({0, 0, 1});
  mesh.facets.push_back({2, 2, 2});
  const Prepared poor(mesh);
  ScanMaps a(64), b(64);
  a.draw(whole.part, map_frame({0.1, 0.2, 1}), {});
  b.draw(poor.part, map_frame({0.1, 0.2, 1}), {});
  EXPECT_EQ(entries(a), entries(b));
}

}  // namespace
}  // namespace moldlight
