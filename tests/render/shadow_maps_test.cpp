// The maps of several directions at once, and what is counted in them, against one direction at a time.
#include "render/shadow_maps.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "render/readout_passes.hpp"
#include "support/classify_mesh.hpp"
#include "support/map_lookup.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"
#include "sweep/ray_scorer.hpp"

namespace moldlight {
namespace {

const MapSettings k_settings{.resolution = 200, .lateral = 0.002};

std::vector<MapFrame> frames() {
  std::vector<MapFrame> frames;
  for (const glm::dvec3& direction : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0.36, 0.48, 0.8),
                                      glm::dvec3(-0.61, 0.17, 0.25), glm::dvec3(0.002, -0.001, -1)}) {
    frames.push_back(map_frame(direction));
  }
  return frames;
}

/// A part with its samples, and every third facet left out of the counts.
struct Counted {
  Counted(std::shared_ptr<const PartModel> of_model, std::uint64_t wanted)
      : model(std::move(of_model)),
        buffers(part_buffers(test::shared_context(), *model)),
        samples(sample_surface_evenly(model->part.mesh, model->geometry, model->frame, wanted)) {}

  [[nodiscard]] static bool is_left_out(FacetIndex facet) { return facet % 3 == 0; }
  [[nodiscard]] std::vector<FacetClass> marked_classes(const MapFrame& frame) const {
    std::vector<FacetClass> classes = facet_classes(model->geometry, frame.z, 1.0);
    for (FacetIndex facet = 0; facet < classes.size(); ++facet)
      if (is_left_out(facet)) classes[facet] = left_out(classes[facet]);
    return classes;
  }
  [[nodiscard]] SampleCounts by_verdicts(const std::vector<std::uint8_t>& verdicts) const;

  std::shared_ptr<const PartModel> model;
  PartBuffers buffers;
  SurfaceSamples samples;
};

SampleCounts Counted::by_verdicts(const std::vector<std::uint8_t>& verdicts) const {
  SampleCounts sums;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (!is_left_out(samples.samples[i].facet))
      ++sums.regions[static_cast<std::size_t>(verdict_region(verdicts[i]))];
  }
  return sums;
}

/// Area of the shadow, unit frame squared, by the texels of single maps that facets cover.
double shadow_area(ShadowMaps& maps, const MapSubject& subject) {
  MapSettings bare = k_settings;
  bare.edge_thickness = 0.0;
  maps.draw(subject, bare);
  std::ptrdiff_t most = 0;
  for (const bool plus : {true, false}) {
    const std::vector<std::uint32_t> texels = maps.read(plus);
    most = std::max(most, std::count_if(texels.begin(), texels.end(), [](auto texel) { return texel != 0; }));
  }
  const double texel = 1.0 / bare.resolution;
  return static_cast<double>(most) * texel * texel;
}

void expect_equal_counts(const Counted& part) {
  const gl::Functions& gl = test::shared_context().functions();
  const std::vector<MapFrame> all = frames();
  const auto count = static_cast<int>(all.size());
  ShadowMaps batch(gl, count);
  SampleCounting counting(gl, part.samples.samples, count);
  for (int i = 0; i < count; ++i) {
    const std::vector<FacetClass> classes = part.marked_classes(all[i]);
    batch.draw({part.buffers, all[i], classes}, k_settings, i);
  }
  const std::vector<SampleCounts> counts = counting.run(batch, count);

  ShadowMaps maps(gl);
  SamplePass pass(gl);
  std::uint32_t undercut = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<FacetClass> classes = facet_classes(part.model->geometry, all[i].z, 1.0);
    const MapSubject subject{part.buffers, all[i], classes};
    const double shadow = shadow_area(maps, subject);
    maps.draw(subject, k_settings);
    const SampleCounts expected = part.by_verdicts(pass.run(part.samples.samples, maps));
    EXPECT_EQ(counts[i].regions, expected.regions) << "direction " << i;
    EXPECT_EQ(batch.shadow(i), shadow) << "direction " << i;
    undercut += expected.regions[3];
  }
  EXPECT_GT(undercut, 0U);
}

TEST(ShadowMaps, CountsWhatSingleMapsSay) {
  expect_equal_counts(Counted(test::model_of(test::subdivided(test::snap_hook({}).mesh, 3000)), 5003));
  expect_equal_counts(
      Counted(load_part((test::asset_folder() / "parts" / "enclosure_lid.stl").string(), {}, {}), 150'000));
}

TEST(ShadowMaps, TakesAsManyDirectionsAsFit) {
  constexpr std::size_t k_mib = 1U << 20;
  const auto fitting = [](int resolution, std::size_t facets, std::size_t bytes) {
    return fitting_places({.resolution = resolution}, facets, bytes);
  };
  EXPECT_EQ(fitting(512, 50'000, 512 * k_mib), 64);
  EXPECT_EQ(fitting(2048, 50'000, 512 * k_mib), 15);
  EXPECT_EQ(fitting(8192, 50'000, 512 * k_mib), 1);
  EXPECT_EQ(fitting(512, 2'000'000, 512 * k_mib), 2);
  EXPECT_EQ(fitting(512, 50'000, 0), 1);
}

}  // namespace
}  // namespace moldlight
