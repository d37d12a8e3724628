// The maps of several directions at once, and what is counted in them, against one direction at a time.
#include "render/map_batch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/sweep/ray_scorer.hpp"
#include "render/sample_counting.hpp"
#include "render/sample_pass.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"

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
        buffers(test::shared_context().functions(), model->part.mesh, model->geometry, model->frame,
                model->edges.concave),
        samples(sample_surface_evenly(model->part.mesh, model->geometry, model->frame, wanted)) {}

  [[nodiscard]] static bool left_out(FacetIndex facet) { return facet % 3 == 0; }
  [[nodiscard]] std::vector<std::uint8_t> marked_classes(const MapFrame& frame) const {
    std::vector<std::uint8_t> marked;
    for (const FacetClass of_facet : facet_classes(model->geometry, frame.z, 1.0)) {
      const bool out = left_out(static_cast<FacetIndex>(marked.size()));
      marked.push_back(
          static_cast<std::uint8_t>(static_cast<int>(of_facet) | (out ? MapBatch::k_left_out : 0)));
    }
    return marked;
  }
  [[nodiscard]] SampleCounts by_verdicts(const std::vector<std::uint8_t>& verdicts) const;

  std::shared_ptr<const PartModel> model;
  PartBuffers buffers;
  SurfaceSamples samples;
};

SampleCounts Counted::by_verdicts(const std::vector<std::uint8_t>& verdicts) const {
  SampleCounts sums;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (!left_out(samples.samples[i].facet))
      ++sums.regions[static_cast<std::size_t>(verdict_region(verdicts[i]))];
  }
  return sums;
}

/// Area of the shadow, unit frame squared, by the texels of single maps that facets cover.
double shadow_area(ShadowMaps& maps, const PartBuffers& buffers, const MapFrame& frame) {
  const gl::Functions& gl = test::shared_context().functions();
  MapSettings bare = k_settings;
  bare.edge_thickness = 0.0;
  maps.draw(buffers, frame, bare);
  std::ptrdiff_t most = 0;
  for (const bool plus : {true, false}) {
    const gl::Framebuffer framebuffer = gl::make_framebuffer(gl, maps.facets(plus));
    std::vector<std::uint32_t> texels(static_cast<std::size_t>(bare.resolution) * bare.resolution);
    gl.ReadPixels(0, 0, bare.resolution, bare.resolution, GL_RED_INTEGER, GL_UNSIGNED_INT, texels.data());
    most = std::max(most, std::count_if(texels.begin(), texels.end(), [](auto texel) { return texel != 0; }));
  }
  const double texel = 1.0 / bare.resolution;
  return static_cast<double>(most) * texel * texel;
}

void expect_equal_counts(const Counted& part) {
  const gl::Functions& gl = test::shared_context().functions();
  const std::vector<MapFrame> all = frames();
  const auto count = static_cast<int>(all.size());
  MapBatch batch(gl, part.buffers, k_settings, count);
  SampleCounting counting(gl, part.samples.samples, count);
  for (int i = 0; i < count; ++i) batch.draw(i, all[i], part.marked_classes(all[i]));
  const std::vector<SampleCounts> counts = counting.run(batch, count);

  ShadowMaps maps(gl);
  SamplePass pass(gl);
  PartBuffers buffers(gl, part.model->part.mesh, part.model->geometry, part.model->frame,
                      part.model->edges.concave);
  std::uint32_t undercut = 0;
  for (int i = 0; i < count; ++i) {
    buffers.set_facet_classes(facet_classes(part.model->geometry, all[i].z, 1.0));
    const double shadow = shadow_area(maps, buffers, all[i]);
    maps.draw(buffers, all[i], k_settings);
    const SampleCounts expected = part.by_verdicts(pass.run(part.samples.samples, buffers, maps));
    EXPECT_EQ(counts[i].regions, expected.regions) << "direction " << i;
    EXPECT_EQ(batch.shadow(i), shadow) << "direction " << i;
    undercut += expected.regions[3];
  }
  EXPECT_GT(undercut, 0U);
}

TEST(MapBatch, CountsWhatSingleMapsSay) {
  expect_equal_counts(Counted(test::model_of(test::subdivided(test::snap_hook({}).mesh, 3000)), 5003));
  expect_equal_counts(
      Counted(load_part((test::asset_folder() / "parts" / "enclosure_lid.stl").string(), {}, {}), 150'000));
}

TEST(MapBatch, TakesAsManyDirectionsAsFit) {
  constexpr std::size_t k_mib = 1U << 20;
  const auto fitting = [](int resolution, std::size_t facets, std::size_t bytes) {
    return MapBatch::fitting_capacity({.resolution = resolution}, facets, bytes);
  };
  EXPECT_EQ(fitting(512, 50'000, 512 * k_mib), 64);
  EXPECT_EQ(fitting(2048, 50'000, 512 * k_mib), 15);
  EXPECT_EQ(fitting(8192, 50'000, 512 * k_mib), 1);
  EXPECT_EQ(fitting(512, 2'000'000, 512 * k_mib), 2);
  EXPECT_EQ(fitting(512, 50'000, 0), 1);
}

}  // namespace
}  // namespace moldlight
