#include <clocale>
#include <vector>

#include <gtest/gtest.h>

#include "io/csv_tables.hpp"
#include "mesh/triangle_mesh.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

TEST(FacetCsv, WritesShortestNumbersInFileOrder) {
  const test::ScratchFolder folder;
  const std::vector<double> areas = {0.1, 1.0 / 3.0, 1e-9};
  const FacetFractions fractions = {{1, 0, 0, 0}, {0.1, 0.2, 0.7, 0}, {0, 0, 1.0 / 3.0, 1e-7}};
  const std::string path = folder.file("facets.csv");
  // Where a locale with a decimal comma is installed, it must not reach the file.
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "C"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  }
  write_facet_csv(path, {areas, fractions, {}});
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(test::file_bytes(path),
            "facet,area,core,cavity,both,undercut\n0,0.1,1,0,0,0\n1,0.3333333333333333,0.1,0.2,0.7,0\n"
            "2,1e-09,0,0,0.3333333333333333,1e-07\n");
}

TEST(FacetCsv, NamesFacetsByTheirNumbersInTheFile) {
  const test::ScratchFolder folder;
  const std::vector<double> areas = {1, 2, 3};
  const FacetFractions fractions(3);
  const std::vector<std::uint32_t> numbers = {7, 4'000'000'000, k_no_facet};
  write_facet_csv(folder.file("facets.csv"), {areas, fractions, numbers});
  EXPECT_EQ(test::file_bytes(folder.file("facets.csv")),
            "facet,area,core,cavity,both,undercut\n7,1,0,0,0,0\n4000000000,2,0,0,0,0\n-1,3,0,0,0,0\n");
}

TEST(FacetCsv, SumsByCadFace) {
  const test::ScratchFolder folder;
  const std::vector<std::uint32_t> sources = {5, 2, 5, 9};
  const std::vector<double> areas = {1, 2, 3, 0};
  const FacetFractions fractions = {{1, 0, 0, 0}, {0, 0.5, 0.5, 0}, {0, 0, 0, 1}, {0, 0, 0, 0}};
  write_face_csv(folder.file("faces.csv"), region_areas_by_source(sources, areas, fractions));
  EXPECT_EQ(test::file_bytes(folder.file("faces.csv")),
            "face,area,core_share,cavity_share,both_share,undercut_share\n2,2,0,0.5,0.5,0\n5,4,0.25,0,0,0."
            "75\n9,0,0,0,0,0\n");
}

}  // namespace
}  // namespace moldlight
