// The facets of real parts come into the same order, whatever their file lists first.
#include "mesh/place_order.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "io/part_formats.hpp"
#include "support/mesh_edits.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

TEST(PlaceOrder, OfSharedPartsIsTheSameWhateverTheFileLists) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "the shared parts are not here";
  std::size_t used = 0;
  for (const auto& file : std::filesystem::directory_iterator(*shared / "parts")) {
    if (!file.is_regular_file() || file.path().extension() != ".stl") continue;
    SCOPED_TRACE(file.path().filename().string());
    Part part = read_part(file.path().string(), {}, Progress());
    if (part.bodies.size() > 1) continue;
    Part other = part;
    other.mesh = test::permuted(part.mesh, 11);
    put_in_place_order(part, Progress());
    put_in_place_order(other, Progress());
    EXPECT_TRUE(part.mesh.vertices == other.mesh.vertices);
    EXPECT_TRUE(part.mesh.facets == other.mesh.facets);
    ++used;
  }
  RecordProperty("parts", static_cast<int>(used));
  EXPECT_GT(used, 10U);
}

}  // namespace
}  // namespace moldlight
