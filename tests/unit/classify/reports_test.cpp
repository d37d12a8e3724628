// Figures and reports at their edges: nothing to measure, checks that fail, numbers of every size.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "classify/classify_report.hpp"
#include "classify/info_report.hpp"
#include "classify/number_format.hpp"
#include "support/boxes.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight {
namespace {

Part part_of(TriangleMesh mesh, const std::string& name = "folder/part.stl") {
  Part part;
  part.file = name;
  part.format = "STL binary";
  part.bodies = {{"", 0, static_cast<FacetIndex>(mesh.facets.size())}};
  part.mesh = std::move(mesh);
  return part;
}

TEST(Figures, HaveFourDigitsAndNoExponent) {
  EXPECT_EQ(rounded(27335.46), "27335");
  EXPECT_EQ(rounded(0.0748225), "0.07482");
  EXPECT_EQ(rounded(-555.9903), "-556");
  EXPECT_EQ(rounded(2.31628e-06), "0.000002316");
  EXPECT_EQ(rounded(2.31628e-06, 0.00013), "< 0.0002");
  EXPECT_EQ(rounded(0.0), "0");
  EXPECT_EQ(rounded(1.5e14), "1.5e+14") << "for a screen's width of zeros";
  EXPECT_EQ(rounded(5e-10), "5e-10");
  EXPECT_EQ(error_text(1.234e-05), "0.000012");
  EXPECT_EQ(error_text(4.8e-12, 1e-8), "< 0.00000001");
}

TEST(Figures, GetATrueMinusOnPictures) {
  EXPECT_EQ(with_minus("-1, 2, -3.5"), "−1, 2, −3.5");
  EXPECT_EQ(with_minus("3 shut-offs along -y, 2e-05"), "3 shut-offs along −y, 2e−05");
  EXPECT_EQ(with_minus(""), "");
}

TEST(SweepTexts, WriteDirectionsWithoutTheSignOfNothing) {
  EXPECT_EQ(direction_text({-1e-6, 0.6, -0.8}), "0.00000, 0.60000, -0.80000");
}

TEST(Figures, NameTheUnit) {
  Part part;
  EXPECT_EQ(powered_unit(part, 2), "unit²");
  part.unit = "mm";
  EXPECT_EQ(powered_unit(part, 3), "mm³");
  part.file = "a/b\x01\xFF.stl";
  EXPECT_EQ(part_name(part).find('\x01'), std::string::npos);
}

TEST(ClassifyReport, OfAPartWithoutAreaHoldsNumbersAlone) {
  TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.facets = {{0, 1, 2}};
  const auto model = prepare_part(part_of(flat), Progress());
  const Classification nothing;
  const auto json = classify_json(*model, nothing);
  EXPECT_EQ(json["fractions"]["undercut"], 0.0);
  EXPECT_EQ(json_text(json).find("nan"), std::string::npos);
}

TEST(ClassifyReport, MarksACheckThatFails) {
  const auto model = prepare_part(part_of(test::box_mesh({0, 0, 0}, {1, 1, 1})), Progress());
  Classification result;
  result.total_area = 6.0;
  result.identity = {.core = 1.0, .cavity = 0.5, .gap = 0.5, .gap_limit = 0.1};
  const nlohmann::ordered_json noted = {
      {"core", 1.0}, {"cavity", 0.5}, {"gap", 0.5}, {"gap_limit", 0.1}, {"agrees", false}};
  EXPECT_EQ(classify_json(*model, result)["identity"], noted);
  result.identity = {.core = 1.0, .cavity = 1.05, .gap = -0.05, .gap_limit = 0.1};
  EXPECT_TRUE(classify_json(*model, result)["identity"]["agrees"].get<bool>());
}

TEST(InfoReport, NumbersFacetsAsTheFileDoes) {
  TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 1, 1});
  box.facets.pop_back();
  Part part = part_of(box);
  for (FacetIndex facet = 0; facet < box.facets.size(); ++facet) part.file_facets.push_back(100 + facet);
  const auto model = prepare_part(part, Progress());
  const auto json = info_json(*model, defect_places(*model));
  ASSERT_EQ(json["defects"]["open"]["places"].size(), 1u);
  EXPECT_GE(json["defects"]["open"]["places"][0]["facet"], 100);
}

TEST(InfoReport, ListsTenPlacesAtMostButCountsAll) {
  TriangleMesh loose;
  for (int i = 0; i < 12; ++i) {
    const auto first = static_cast<VertexIndex>(loose.vertices.size());
    loose.vertices.insert(loose.vertices.end(), {{i, 0, 0}, {i, 0.5, 0}, {i, 0, 0.5}});
    loose.facets.push_back({first, first + 1, first + 2});
  }
  const auto model = prepare_part(part_of(loose), Progress());
  const std::string text = info_text(*model, defect_places(*model));
  EXPECT_NE(text.find("open edges: 12 chains"), std::string::npos) << text;
  EXPECT_NE(text.find("the 10 longest"), std::string::npos) << text;
}

}  // namespace
}  // namespace moldlight
