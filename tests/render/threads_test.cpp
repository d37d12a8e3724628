// Contexts of several threads beside one another. A software driver breaks here, sooner or later, where two
// threads make its calls at the same time.
#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "gl/headless_context.hpp"
#include "render/shadow_maps.hpp"
#include "support/classify_mesh.hpp"
#include "support/map_lookup.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

constexpr int k_threads = 4, k_contexts = 4, k_maps = 150;

/// How many maps of a part that comes and goes are not as the first ones.
int wrong_maps(const PartModel& model) {
  const auto context = gl::create_headless_context(gl::HeadlessBackend::automatic);
  const MapFrame frame = map_frame({0.36, 0.48, 0.8});
  const std::vector<FacetClass> classes = facet_classes(model.geometry, frame.z, 1.0);
  std::vector<std::uint32_t> first;
  int wrong = 0;
  for (int k = 0; k < k_maps; ++k) {
    const PartBuffers buffers = part_buffers(*context, model);
    ShadowMaps maps(context->functions());
    maps.draw({.part = buffers, .frame = frame, .classes = classes}, {.resolution = 256, .lateral = 0.002});
    if (k % 3 != 0) continue;  // else they go while the driver still draws
    const std::vector<std::uint32_t> facets = maps.read(true);
    if (first.empty()) first = facets;
    if (facets != first) ++wrong;
  }
  return wrong;
}

TEST(GlThreads, ContextsOfManyThreadsDrawBesideOneAnother) {
  const auto model = test::model_of(test::refined(test::cup_with_side_hole({}), 5000).mesh);
  std::atomic<int> wrong = 0;
  {
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < k_threads; ++thread) {
      threads.emplace_back([&] {
        for (int k = 0; k < k_contexts; ++k) wrong += wrong_maps(*model);
      });
    }
  }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace moldlight
