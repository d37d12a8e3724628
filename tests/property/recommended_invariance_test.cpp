// The direction that is recommended for a real part does not depend on the order of its facets, on its scale,
// or on which hand it is, and turns with the part.
#include <array>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "io/part_formats.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shared_parts.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

constexpr double k_same = 1e-6;

glm::dvec3 recommended(TriangleMesh mesh) {
  return best_direction(test::model_of(std::move(mesh)), {}, Progress{}).direction;
}

TEST(RecommendedInvariance, HoldsForSharedParts) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  const std::array<std::string, 5> names{"framework_expansion_card.stl", "so100_lego_gauge.stl",
                                         "so101_waveshare_plate.stl", "m5_basic27_button.stl",
                                         "m5_stackchan_basecover.stl"};
  std::uint32_t seed = 3;
  for (const std::string& name : names) {
    const TriangleMesh mesh =
        read_part((*test::shared_folder() / "parts" / name).string(), {}, Progress()).mesh;
    const glm::dvec3 known = recommended(mesh);
    EXPECT_LT(glm::distance(recommended(test::permuted(mesh, seed)), known), k_same) << name;
    EXPECT_LT(glm::distance(recommended(test::mirrored(mesh)) * glm::dvec3(-1, 1, 1), known), k_same) << name;
    EXPECT_LT(glm::distance(recommended(test::scaled(mesh, 3.7)), known), k_same) << name;
    const glm::dquat rotation = test::random_rotation(seed++);
    EXPECT_LT(glm::distance(recommended(test::rotated(mesh, rotation)), rotation * known), k_same) << name;
  }
}

}  // namespace
}  // namespace moldlight
