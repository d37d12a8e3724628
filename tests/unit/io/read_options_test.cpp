#include "io/read_options.hpp"

#include <gtest/gtest.h>

#include "unit/io/read_text.hpp"

namespace moldlight {
namespace {

const std::string k_two_bodies =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no first\nf 1 2 3\nf 1 1 2\no second\nf 2 3 4\nf 4 4 4\n";

TEST(ReadOptions, SetUnitBodyAndRepairInOneGo) {
  ReadOptions options{.unit = "cm", .body = "second"};
  options.repair.level = RepairLevel::full;
  const Part part = test::read_bytes("part.obj", k_two_bodies, options);
  EXPECT_EQ(part.unit, "cm");
  ASSERT_EQ(part.mesh.facets.size(), 1u);
  EXPECT_EQ(part.file_facets, std::vector<std::uint32_t>{2});
  EXPECT_EQ(part.mesh.corner(0, 2), glm::dvec3(0, 0, 1));
  EXPECT_FALSE(part.repairs.empty());
}

TEST(ReadOptions, FailClearlyWhereNothingIsLeft) {
  ReadOptions options;
  options.repair.level = RepairLevel::full;
  EXPECT_EQ(test::read_error("a.obj", "v 0 0 0\nv 1 0 0\nf 1 1 2\n", options),
            "a.obj: has no facet with an area; the repair left nothing");
  EXPECT_THROW(test::read_bytes("a.obj", k_two_bodies, {.body = "third"}), UsageError);
  EXPECT_THROW(test::read_bytes("a.obj", k_two_bodies, {.unit = "ell"}), UsageError);
}

}  // namespace
}  // namespace moldlight
