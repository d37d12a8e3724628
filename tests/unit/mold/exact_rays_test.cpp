// The tree of exact rays, beside work that is cancelled.
#include "mold/exact_rays.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "support/boxes.hpp"

namespace moldlight {
namespace {

/// Cancels work that has work within.
void cancel_some_work() {
  EXPECT_THROW(tbb::parallel_for(0, 4,
                                 [](int outer) {
                                   tbb::parallel_for(0, 4, [outer](int inner) {
                                     if (outer == inner) throw std::runtime_error("cancelled");
                                   });
                                 }),
               std::runtime_error);
}

TEST(ExactRays, OutliveTheWorkInWhichTheyWereMade) {
  const TriangleMesh box = test::box_mesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  std::vector<glm::vec3> positions;
  for (const auto& vertex : box.vertices) positions.emplace_back(vertex);
  std::optional<ExactRays> rays;
  using Context = tbb::task_group_context;
  alignas(Context) std::array<std::byte, sizeof(Context)> room;
  auto* const context = new (room.data()) Context(Context::isolated);
  tbb::parallel_for(
      0, 1, [&](int) { rays.emplace(box, positions); }, *context);
  std::destroy_at(context);
  std::memset(room.data(), 0x5A, room.size());  // as whatever comes next leaves it
  cancel_some_work();
  EXPECT_TRUE(rays->surface_point_blocked({0, 0, -2}, {0, 0, 1}, {0, 0, 1}));
}

}  // namespace
}  // namespace moldlight
