// The shipped parts are what the documentation says: closed, manifold, outward, small files.
#include <filesystem>

#include <gtest/gtest.h>

#include "io/part_formats.hpp"
#include "mesh/health.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;

TEST(DemoParts, AreHealthy) {
  std::size_t parts = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(test::asset_folder() / "parts")) {
    const Part part = read_part(entry.path().string(), {}, Progress());
    const HealthReport report = health_report(part.mesh, facet_geometry(part.mesh));
    EXPECT_TRUE(report.closed) << entry;
    EXPECT_EQ(report.components, 1u) << entry;
    EXPECT_GT(report.volume, 0.0) << entry;
    for (const std::string& warning : health_warnings(report)) ADD_FAILURE() << entry << ": " << warning;
    for (const std::string& warning : part.warnings) ADD_FAILURE() << entry << ": " << warning;
    EXPECT_GT(report.facets, 4000u) << entry;
    EXPECT_LT(entry.file_size(), 1'500'000u) << entry;
    ++parts;
  }
  EXPECT_EQ(parts, 4u);
}

}  // namespace
}  // namespace moldlight
