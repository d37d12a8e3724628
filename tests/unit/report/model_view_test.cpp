// What a page's script unpacks is what was packed, to the rounding that is promised.
#include "report/model_view.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "packed_reader.hpp"
#include "support/boxes.hpp"
#include "support/shapes.hpp"

namespace moldlight::report {
namespace {

using Json = nlohmann::ordered_json;

ModelView view_of(const TriangleMesh& mesh) {
  ModelView view;
  view.centre = bounds(mesh).center();
  view.diagonal = bounds(mesh).diagonal();
  view.groups = {{"a"}, {"b"}};
  ViewSurface surface{mesh, {}};
  for (std::size_t k = 0; k < mesh.facets.size(); ++k)
    surface.group_of_facet.push_back(static_cast<std::uint16_t>(k / 3 % 2));
  view.surfaces.push_back(std::move(surface));
  return view;
}

TEST(ModelView, HasItsNumbersInTheUnitFrame) {
  ModelView view = view_of(test::box_mesh({-1, -2, -3}, {5, 6, 7}));
  view.callouts = {{"1", {5, 2, 2}, {1, 0, 0}}};
  const Json packed = report::packed(view);
  ASSERT_EQ(packed["callouts"].size(), 1u);
  EXPECT_NEAR(packed["callouts"][0]["place"][0].get<double>(), 3.0 / view.diagonal, 1e-12);
  EXPECT_NEAR(packed["callouts"][0]["place"][1].get<double>(), 0.0, 1e-12);
  EXPECT_EQ(packed["callouts"][0]["normal"][0], 1.0);
}

TEST(ModelView, UnpacksToTheSameSurface) {
  const TriangleMesh mesh = test::refined(test::cup_with_side_hole(test::ShapeSettings{}), 2000).mesh;
  const ModelView view = view_of(mesh);
  const Json packed = report::packed(view);
  const Json& surface = packed["surfaces"][0];
  PackedReader reader(packed);
  const std::size_t corners = surface["corners"];
  ASSERT_EQ(surface["facets"], mesh.facets.size());
  std::vector<glm::dvec3> points(corners);
  glm::ivec3 last(0);
  for (glm::dvec3& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      last[axis] += reader.difference();
      const double low = surface["low"][axis], high = surface["high"][axis];
      point[axis] = low + (high - low) * last[axis] / 65535.0 + view.centre[axis];
    }
  }
  std::uint32_t next = 0;
  double furthest = 0.0;
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex corner : facet) {
      const std::uint32_t back = reader.number();
      ASSERT_LE(back, next);
      furthest = std::max(furthest, glm::distance(points.at(next - back), mesh.vertices[corner]));
      if (back == 0) ++next;
    }
  }
  EXPECT_EQ(next, corners);
  EXPECT_LE(furthest, view.diagonal / 65535.0);
  std::int32_t group = 0;
  for (const std::uint16_t expected : view.surfaces[0].group_of_facet) {
    group += reader.difference();
    ASSERT_EQ(group, expected);
  }
  EXPECT_TRUE(reader.at_end());
}

TEST(ModelView, LinesAreInThePartsBox) {
  ModelView view = view_of(test::box_mesh({0, 0, 0}, {1, 2, 3}));
  view.surfaces.clear();
  view.lines = {{{{0, 0, 0}, {1, 1, 1}}, false, 1}, {{{0.5, 0.25, 0}, {1, 0, 0}, {0, 1, 1}}, true, 0}};
  const Json packed = report::packed(view);
  PackedReader reader(packed);
  glm::ivec3 last(0);
  for (const ViewLine& line : view.lines) {
    for (const glm::dvec3& point : line.points) {
      for (int axis = 0; axis < 3; ++axis) {
        last[axis] += reader.difference();
        EXPECT_NEAR(last[axis] / 65535.0, point[axis], 1e-5);
      }
    }
  }
  EXPECT_TRUE(reader.at_end());
  EXPECT_EQ(packed["lines"][1]["points"], 3);
  EXPECT_EQ(packed["lines"][1]["closed"], true);
}

TEST(ModelView, FiftyThousandFacetsAreSmall) {
  const TriangleMesh mesh = test::refined(test::cup_with_side_hole(test::ShapeSettings{}), 50'000).mesh;
  ASSERT_GE(mesh.facets.size(), 50'000u);
  const double bytes_a_facet = static_cast<double>(report::packed(view_of(mesh)).dump().size()) /
                               static_cast<double>(mesh.facets.size());
  EXPECT_LT(50'000.0 * bytes_a_facet, 0.7e6) << "pictures and text want their share of 1.5 MB";
  RecordProperty("bytes_for_50k_facets", std::to_string(50'000.0 * bytes_a_facet));
}

}  // namespace
}  // namespace moldlight::report
