// Exact regions do not depend on how a surface is cut into facets, on their order, on the frame of reference,
// on the unit or on the number of threads.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "io/part_formats.hpp"
#include "support/box_pile.hpp"
#include "support/exact_model.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

struct Case {
  std::string name;
  TriangleMesh mesh;
  test::ShapeSettings settings;
  std::vector<glm::dvec3> directions;
};

TriangleMesh read_mesh(const std::filesystem::path& path) { return read_part(path.string(), {}, {}).mesh; }

/// Shapes along their own direction and an oblique one, piles, the shipped parts and a few real ones.
const std::vector<Case>& cases() {
  static const std::vector<Case> made = [] {
    std::vector<Case> all;
    for (test::Shape& shape : test::all_shapes({})) {
      all.push_back({shape.name,
                     std::move(shape.mesh),
                     shape.settings,
                     {shape.direction, glm::normalize(glm::dvec3(0.3, -0.5, 0.6))}});
    }
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      const test::BoxPile pile = test::random_pile(seed, seed % 5 == 4);
      all.push_back({"pile " + std::to_string(seed),
                     test::pile_mesh(pile, seed),
                     {.tau_deg = 1.0, .lateral_tolerance = test::clear_lateral_tolerance(pile, seed)},
                     test::five_directions()});
    }
    const auto add_part = [&](const std::filesystem::path& path) {
      TriangleMesh mesh = read_mesh(path);
      const double diagonal = bounds(mesh).diagonal();
      all.push_back(
          {path.filename().string(), std::move(mesh), {1.0, diagonal / 2048.0}, test::five_directions()});
    };
    for (const char* name : {"bottle_cap.stl", "cable_clip.stl", "tilted_bracket.stl"})
      add_part(test::asset_folder() / "parts" / name);
    std::size_t shared_parts = 0;
    if (const auto shared = test::shared_folder()) {
      for (const char* name :
           {"framework_expansion_card.stl", "lego_brick_2x4.stl", "m5_button_half_flipped.stl",
            "m5_rfid2_face_shell.stl", "numpystl_rear_case.stl", "screwcap_medical_bottle.stl",
            "so101_trigger.stl", "trimesh_angle_block_open.stl", "trimesh_quadknot.obj",
            "trimesh_multibody_flipped.stl", "trimesh_shared_edge.stl", "openscad_far_out_ring.off"}) {
        if (!std::filesystem::exists(*shared / "parts" / name)) continue;
        add_part(*shared / "parts" / name);
        ++shared_parts;
      }
    }
    std::printf("%zu cases, %zu of them shared parts\n", all.size(), shared_parts);
    return all;
  }();
  return made;
}

/// Runs through all cases and directions; compare(model, direction, settings, areas) gives the difference as
/// a share of the part's area, which has to stay below the bound.
template <typename Compare>
void expect_differences_below(double bound, const Compare& compare) {
  double worst = 0.0;
  std::string worst_name;
  for (const Case& one : cases()) {
    const test::ExactModel model(one.mesh);
    for (const glm::dvec3& direction : one.directions) {
      const ExactAreas areas = model.areas(direction, one.settings);
      const double difference = compare(model, direction, one.settings, areas) / areas.areas.total();
      char name[200];
      std::snprintf(name, sizeof name, "%s along (%.3g, %.3g, %.3g)", one.name.c_str(), direction.x,
                    direction.y, direction.z);
      EXPECT_LE(difference, bound) << name;
      if (!(difference <= worst)) {
        worst = difference;
        worst_name = name;
      }
    }
  }
  std::printf("worst %.2e: %s\n", worst, worst_name.c_str());
}

double difference_of(const ExactAreas& a, const ExactAreas& b) {
  return std::max({test::largest_difference(a.areas, b.areas), std::abs(a.projected_core - b.projected_core),
                   std::abs(a.projected_cavity - b.projected_cavity),
                   std::abs(a.near_vertical_area - b.near_vertical_area)});
}

TEST(ExactInvariance, FractionsAreSharesThatMakeUpTheAreas) {
  expect_differences_below(1e-12, [](const test::ExactModel& model, const glm::dvec3&,
                                     const test::ShapeSettings&, const ExactAreas& areas) {
    RegionValues summed;
    EXPECT_EQ(areas.facet_fractions.size(), model.mesh().facets.size());
    for (std::size_t facet = 0; facet < areas.facet_fractions.size(); ++facet) {
      double sum = 0.0;
      for (const Region region : k_regions) {
        const double share = areas.facet_fractions[facet][static_cast<std::size_t>(region)];
        EXPECT_GE(share, 0.0);
        sum += share;
        summed[region] += share * model.geometry().areas[facet];
      }
      EXPECT_NEAR(sum, model.geometry().areas[facet] > 0.0 ? 1.0 : 0.0, 1e-14);
    }
    return std::max(test::largest_difference(summed, areas.areas),
                    std::abs(areas.areas.total() - model.geometry().total_area));
  });
}

TEST(ExactInvariance, CuttingEveryFacetInFourChangesNothing) {
  expect_differences_below(1e-10, [](const test::ExactModel& model, const glm::dvec3& direction,
                                     const test::ShapeSettings& settings, const ExactAreas& areas) {
    const ExactAreas cut = test::exact_areas_of(test::cut_in_four(model.mesh()), direction, settings);
    return difference_of(areas, cut);
  });
}

TEST(ExactInvariance, UnevenSubdivisionChangesNothing) {
  // Shapes and piles alone: new vertices off the planes of real facets bend them by their rounding.
  expect_differences_below(1e-10, [](const test::ExactModel& model, const glm::dvec3& direction,
                                     const test::ShapeSettings& settings, const ExactAreas& areas) {
    if (model.mesh().facets.size() > 3000) return 0.0;
    const std::size_t facets = 3 * model.mesh().facets.size();
    return difference_of(areas,
                         test::exact_areas_of(test::subdivided(model.mesh(), facets), direction, settings));
  });
}

TEST(ExactInvariance, OrderOfFacetsAndVerticesChangesNothing) {
  std::uint32_t seed = 0;
  expect_differences_below(1e-12, [&](const test::ExactModel& model, const glm::dvec3& direction,
                                      const test::ShapeSettings& settings, const ExactAreas& areas) {
    return difference_of(areas,
                         test::exact_areas_of(test::permuted(model.mesh(), ++seed), direction, settings));
  });
}

TEST(ExactInvariance, ReversedDirectionSwapsCoreAndCavity) {
  expect_differences_below(1e-12, [](const test::ExactModel& model, const glm::dvec3& direction,
                                     const test::ShapeSettings& settings, const ExactAreas& areas) {
    const ExactAreas reversed = model.areas(-direction, settings);
    return std::max({test::largest_difference(areas.areas, test::swapped_sides(reversed.areas)),
                     std::abs(areas.projected_core - reversed.projected_cavity),
                     std::abs(areas.projected_cavity - reversed.projected_core)});
  });
}

TEST(ExactInvariance, PartAndDirectionTurnTogether) {
  std::uint32_t seed = 100;
  expect_differences_below(1e-10, [&](const test::ExactModel& model, const glm::dvec3& direction,
                                      const test::ShapeSettings& settings, const ExactAreas& areas) {
    const glm::dquat rotation = test::random_rotation(++seed);
    // About the middle: a part far from the origin would lose digits by turning about that.
    const TriangleMesh centred = test::translated(model.mesh(), -bounds(model.mesh()).center());
    return difference_of(
        areas, test::exact_areas_of(test::rotated(centred, rotation), rotation * direction, settings));
  });
}

void expect_same_bits(const ExactAreas& a, const ExactAreas& b, double factor, const std::string& name) {
  EXPECT_EQ(a.facet_fractions, b.facet_fractions) << name;
  for (const Region region : k_regions) EXPECT_EQ(a.areas[region] * factor, b.areas[region]) << name;
  EXPECT_EQ(a.near_vertical_area * factor, b.near_vertical_area) << name;
  EXPECT_EQ(a.projected_core * factor, b.projected_core) << name;
  EXPECT_EQ(a.projected_cavity * factor, b.projected_cavity) << name;
}

void expect_same_pieces(const SplitMesh& a, const SplitMesh& b, double factor, const std::string& name) {
  ASSERT_EQ(a.pieces.size(), b.pieces.size()) << name;
  ASSERT_EQ(a.vertices.size(), b.vertices.size()) << name;
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    different += a.pieces[i].corners != b.pieces[i].corners || a.pieces[i].facet != b.pieces[i].facet ||
                         a.pieces[i].region != b.pieces[i].region
                     ? 1
                     : 0;
  }
  for (std::size_t i = 0; i < a.vertices.size(); ++i)
    different += a.vertices[i] * factor != b.vertices[i] ? 1 : 0;
  EXPECT_EQ(different, 0U) << name;
}

TEST(ExactInvariance, ScalingByPowersOfTwoScalesToTheBit) {
  for (const Case& one : cases()) {
    const test::ExactModel model(one.mesh);
    for (const int power : {20, -20}) {
      const double factor = std::ldexp(1.0, power);
      const test::ExactModel scaled(test::scaled(one.mesh, factor));
      test::ShapeSettings settings = one.settings;
      settings.lateral_tolerance *= factor;
      for (const glm::dvec3& direction : {one.directions.front(), one.directions.back()}) {
        const ExactSplit before = model.split(direction, one.settings);
        const ExactSplit after = scaled.split(direction, settings);
        expect_same_bits(before.areas, after.areas, factor * factor, one.name);
        expect_same_bits(before.areas, scaled.areas(direction, settings), factor * factor, one.name);
        expect_same_pieces(before.mesh, after.mesh, factor, one.name);
      }
    }
  }
}

TEST(ExactInvariance, TheNumberOfThreadsChangesNoBit) {
  const tbb::global_control seven(tbb::global_control::max_allowed_parallelism, 7);
  for (const Case& one : cases()) {
    const glm::dvec3& direction = one.directions.back();
    std::vector<ExactSplit> splits;
    std::vector<std::size_t> crossings;
    for (const int threads : {1, 2, 7}) {
      tbb::task_arena arena(threads);
      arena.execute([&] {
        const test::ExactModel model(one.mesh);
        crossings.push_back(0);
        for (FacetIndex facet = 0; facet < one.mesh.facets.size(); ++facet)
          crossings.back() += model.part().crossings(facet).size();
        splits.push_back(model.split(direction, one.settings));
        expect_same_bits(splits.front().areas, splits.back().areas, 1.0, one.name);
        expect_same_bits(splits.front().areas, model.areas(direction, one.settings), 1.0, one.name);
      });
      EXPECT_EQ(crossings.front(), crossings.back()) << one.name;
      expect_same_pieces(splits.front().mesh, splits.back().mesh, 1.0, one.name);
      const auto borders = region_borders(splits.front().mesh), again = region_borders(splits.back().mesh);
      ASSERT_EQ(borders.size(), again.size());
      for (std::size_t i = 0; i < borders.size(); ++i) EXPECT_EQ(borders[i].vertices, again[i].vertices);
    }
  }
}

}  // namespace
}  // namespace moldlight
