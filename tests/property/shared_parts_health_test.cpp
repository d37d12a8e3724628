// The health report of real parts against what is known of them.
#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/part_formats.hpp"
#include "mesh/health.hpp"
#include "mesh/orient.hpp"
#include "support/manifest.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

/// Good parts whose facets are the file's own (a STEP file's depend on who makes them) and whose format is
/// known.
std::vector<std::pair<test::ManifestRow, Part>> usable_parts() {
  std::vector<std::pair<test::ManifestRow, Part>> parts;
  for (const test::ManifestRow& row : test::read_manifest()) {
    if (row.file.starts_with("bad/") || row.format == "STEP") continue;
    try {
      parts.emplace_back(row,
                         read_part((*test::shared_folder() / "parts" / row.file).string(), {}, Progress()));
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("not supported"), std::string::npos) << error.what();
    }
  }
  std::cout << parts.size() << " shared parts used\n";
  return parts;
}

TEST(SharedPartsHealth, IsAsTheManifestSays) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  const auto parts = usable_parts();
  EXPECT_GE(parts.size(), 30u);
  for (const auto& [row, part] : parts) {
    const HealthReport report = health_report(part.mesh, facet_geometry(part.mesh));
    EXPECT_EQ(report.facets, row.facets) << row.file;
    EXPECT_EQ(report.vertices, row.vertices) << row.file;
    EXPECT_EQ(report.components, row.components) << row.file;
    EXPECT_EQ(report.open_edges, row.defect_count("bnd")) << row.file;
    EXPECT_EQ(report.nonmanifold_edges, row.defect_count("nonman")) << row.file;
    EXPECT_EQ(report.inconsistent_edges, row.defect_count("flip")) << row.file;
    EXPECT_EQ(report.duplicate_facets, row.defect_count("dup")) << row.file;
    EXPECT_EQ(report.closed, report.open_edges + report.inconsistent_edges == 0) << row.file;
    // The volume of an open part depends on the origin.
    const double volume = report.closed ? report.volume : *row.signed_volume;
    EXPECT_NEAR(volume, *row.signed_volume, 1e-4 * std::abs(volume)) << row.file;
    EXPECT_GE(report.degenerate_facets, row.defect_count("deg")) << row.file;
  }
}

TEST(SharedPartsHealth, OnlyTheInsideOutPartIsTurned) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  for (auto& [row, part] : usable_parts()) {
    const TurnedFacets turned = turn_if_inside_out(part.mesh);
    EXPECT_EQ(turned.facets, row.file == "m5_button_inside_out.stl" ? part.mesh.facets.size() : 0u)
        << row.file << ": " << turned_warning(turned);
  }
}

TEST(SharedPartsHealth, AdjacencyCutsAsManyEdgesAsTheReportCounts) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  for (const auto& [row, part] : usable_parts()) {
    const HealthReport report = health_report(part.mesh, facet_geometry(part.mesh));
    if (report.nonmanifold_edges + report.degenerate_facets > 0) continue;
    std::size_t cut = 0;
    for (const auto& across : build_adjacency(part.mesh).across) {
      for (const FacetIndex other : across) cut += other == k_no_facet ? 1 : 0;
    }
    EXPECT_EQ(cut, report.open_edges + 2 * report.inconsistent_edges) << row.file;
  }
}

}  // namespace
}  // namespace moldlight
