#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mesh/part.hpp"

namespace moldlight {
namespace {

/// Three bodies of 1, 2 and 1 facets over five vertices; polygon k + 10 is the source of facet k.
Part sample_part() {
  Part part;
  part.file = "part.stl";
  part.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  part.mesh.facets = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {4, 0, 1}};
  part.bodies = {{"lid", 0, 1}, {"", 1, 2}, {"lid", 3, 1}};
  part.facet_source = {10, 11, 12, 13};
  return part;
}

std::string selection_error(std::string_view selector) {
  try {
    static_cast<void>(select_body(sample_part(), selector));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PartSelection, TakesABodyByNumber) {
  const Part body = select_body(sample_part(), "2");
  ASSERT_EQ(body.mesh.facets.size(), 2u);
  EXPECT_EQ(body.mesh.vertices.size(), 4u);
  EXPECT_EQ(body.mesh.corner(1, 2), glm::dvec3(1, 1, 1));
  EXPECT_EQ(body.facet_source, (std::vector<std::uint32_t>{11, 12}));
  EXPECT_EQ(body.file_facets, (std::vector<std::uint32_t>{1, 2}));
  ASSERT_EQ(body.bodies.size(), 1u);
  EXPECT_EQ(body.bodies[0].first_facet, 0u);
  EXPECT_EQ(body.bodies[0].facet_count, 2u);
}

TEST(PartSelection, TakesABodyByNameOrAll) {
  Part part = sample_part();
  part.bodies[2].name = "base plate";
  EXPECT_EQ(select_body(part, "base plate").file_facets, (std::vector<std::uint32_t>{3}));
  const Part all = select_body(part, "all");
  EXPECT_EQ(all.mesh.facets.size(), 4u);
  EXPECT_TRUE(all.file_facets.empty());
}

TEST(PartSelection, KeepsFacetNumbersThroughSeveralSelections) {
  Part part = sample_part();
  part.file_facets = {100, 200, 300, 400};
  EXPECT_EQ(extract_body(part, 1).file_facets, (std::vector<std::uint32_t>{200, 300}));
}

TEST(PartSelection, ListsTheBodiesWhereNoneFits) {
  EXPECT_EQ(selection_error("4"), "part.stl: there is no body '4'; its bodies are 1 'lid', 2, 3 'lid'");
  EXPECT_EQ(selection_error("0"), "part.stl: there is no body '0'; its bodies are 1 'lid', 2, 3 'lid'");
  EXPECT_EQ(selection_error("base"), "part.stl: there is no body 'base'; its bodies are 1 'lid', 2, 3 'lid'");
  EXPECT_EQ(selection_error("lid"),
            "part.stl: more than one body is named 'lid'; its bodies are 1 'lid', 2, 3 'lid'");
}

TEST(PartUnit, IsNamedOrConverted) {
  Part part = sample_part();
  set_unit(part, "m");
  EXPECT_EQ(part.unit, "m");
  EXPECT_EQ(part.mesh.corner(0, 1), glm::dvec3(1, 0, 0));
  set_unit(part, "millimeter");
  EXPECT_EQ(part.unit, "mm");
  EXPECT_EQ(part.mesh.corner(0, 1), glm::dvec3(1000, 0, 0));
  set_unit(part, "in");
  EXPECT_NEAR(part.mesh.corner(0, 1).x, 1000 / 25.4, 1e-12);
  EXPECT_THROW(set_unit(part, "parsec"), UsageError);
}

}  // namespace
}  // namespace moldlight
