// How the shadow maps differ from exact regions: sums, and what finer maps do.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

/// The comparison's samples are not those of the readout; both are off by this at most, of the area.
constexpr double k_readouts_apart = 2e-3;

Query quick(const glm::dvec3& direction, int resolution, int samples) {
  Query query;
  query.direction = direction;
  query.method.resolution = resolution;
  query.method.samples = samples;
  return query;
}

Classification compared(const std::shared_ptr<const PartModel>& model, const Query& query) {
  Classifier classifier(test::shared_context(), model);
  Classification result = classifier.classify(query, Progress{}, true);
  classifier.compare_maps(result, Progress{});
  return result;
}

void expect_exact_rows(const Classification& result, const std::string& name) {
  for (const Region region : k_regions) {
    EXPECT_NEAR(result.maps->areas[static_cast<std::size_t>(region)].total(), result.areas[region],
                1e-9 * result.total_area)
        << name << ", " << region_name(region);
  }
}

TEST(MapComparisonProperties, RowsAreTheExactAreas) {
  for (const test::Shape& shape : test::all_shapes({})) {
    const auto model = test::model_of(shape.mesh);
    for (const KernelShape kernel : {KernelShape::one_sided, KernelShape::symmetric}) {
      Query query = quick(shape.direction, 256, 20'000);
      query.method.kernel_shape = kernel;
      expect_exact_rows(compared(model, query), shape.name);
    }
  }
}

TEST(MapComparisonProperties, FinerMapsDifferLess) {
  for (const char* name : {"bottle_cap.stl", "cable_clip.stl", "enclosure_lid.stl", "tilted_bracket.stl"}) {
    const auto model = load_part((test::asset_folder() / "parts" / name).string(), ReadOptions{}, Progress{});
    double before = 1.0;
    for (const int resolution : {256, 1024, 4096}) {
      const Classification result = compared(model, quick({0, 0, 1}, resolution, 300'000));
      expect_exact_rows(result, name);
      const double share = result.maps->differing() / result.total_area;
      std::printf("%s, %d texels: %s, ± %.2g %%\n", name, resolution, comparison_text(*result.maps).c_str(),
                  100.0 * result.maps->error / result.total_area);
      EXPECT_LT(share, 0.5 * before) << name << ", " << resolution;
      EXPECT_LT(result.maps->error, 2e-3 * result.total_area) << name;
      before = share;
    }
  }
}

TEST(MapComparisonProperties, ColumnsAreThoseOfTheReadoutBySamples) {
  const auto model =
      load_part((test::asset_folder() / "parts" / "cable_clip.stl").string(), ReadOptions{}, Progress{});
  Query query = quick({0, 0, 1}, 512, 300'000);
  query.method.readout = Readout::samples;
  const Classification result = compared(model, query);
  const Classification exact = classify_exact(*model, query, Progress{});
  for (const Region region : k_regions) {
    EXPECT_NEAR(exact.areas[region] + result.maps->excess(region), result.areas[region],
                k_readouts_apart * result.total_area)
        << region_name(region);
  }
}

TEST(MapComparisonProperties, MoreSamplesAgreeWithinTheError) {
  const auto model =
      load_part((test::asset_folder() / "parts" / "tilted_bracket.stl").string(), ReadOptions{}, Progress{});
  Query query = quick({0.36, 0.48, 0.8}, 512, 4'000'000);
  const MapComparison fine = *compared(model, query).maps;
  query.method.samples = 50'000;
  const MapComparison coarse = *compared(model, query).maps;
  EXPECT_LT(std::abs(fine.differing() - coarse.differing()), fine.error + coarse.error);
  EXPECT_LT(fine.error, coarse.error);
}

}  // namespace
}  // namespace moldlight
