// The surface of which a verdict speaks: its areas are those of the verdict, its facets those at fault.
#include "study/verdict_surface.hpp"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "study/study.hpp"
#include "support/boxes.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

using Of = Subject::Of;

double area_of(const SplitMesh& mesh) {
  double sum = 0.0;
  for (std::size_t k = 0; k < mesh.pieces.size(); ++k)
    sum += 0.5 * glm::length(glm::cross(mesh.corner(k, 1) - mesh.corner(k, 0),
                                        mesh.corner(k, 2) - mesh.corner(k, 0)));
  return sum;
}

/// A study along z with its answers, and the surface of a subject.
class Surfaces {
 public:
  explicit Surfaces(TriangleMesh mesh) : study_(model_of(std::move(mesh)), questions()) {
    plan = &study_.find<ActionPlan>(Progress());
    regions = &study_.find<SplitRegions>(Progress()).result;
  }
  [[nodiscard]] SubjectSurface of(const Subject& subject) const {
    return surface_of(subject, study_.model(), regions->split.get(), plan);
  }
  [[nodiscard]] Verdict verdict() { return study_.verdict(Progress()); }

  const ActionPlan* plan = nullptr;
  const Classification* regions = nullptr;

 private:
  static Questions questions() {
    Questions questions;
    questions.with_actions = true;
    return questions;
  }
  static std::shared_ptr<const PartModel> model_of(TriangleMesh mesh) {
    Part part;
    part.mesh = std::move(mesh);
    part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
    return prepare_part(std::move(part), Progress());
  }

  Study study_;
};

TEST(VerdictSurface, OfRegionsAndUndercutsHasTheirAreas) {
  Surfaces pocket(test::plate_with_side_pocket({}).mesh);
  const Verdict verdict = pocket.verdict();
  for (const Region region : k_regions)
    EXPECT_NEAR(area_of(pocket.of({.region = region}).mesh), pocket.regions->areas[region],
                1e-9 * pocket.regions->total_area)
        << region_name(region);
  EXPECT_NEAR(area_of(pocket.of({.of = Of::undercuts}).mesh), verdict.undercut_area,
              1e-9 * pocket.regions->total_area);
  EXPECT_TRUE(pocket.of({.of = Of::unreleased}).mesh.pieces.empty()) << "a slide releases it";
  EXPECT_TRUE(pocket.of({.of = Of::tiny}).mesh.pieces.empty());
  EXPECT_FALSE(least_released(*pocket.plan));
}

TEST(VerdictSurface, OfWhatNothingReleasesIsTheVoid) {
  Surfaces sphere(test::hollow_sphere({}).mesh);
  const SubjectSurface found = sphere.of({.of = Of::unreleased});
  EXPECT_NEAR(area_of(found.mesh), sphere.verdict().unreleased_area, 1e-9 * sphere.regions->total_area);
  ASSERT_FALSE(found.mesh.pieces.empty());
  EXPECT_EQ(least_released(*sphere.plan), 0U);
}

TEST(VerdictSurface, OfOpenEdgesIsTheFacetsBesideThem) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {2, 2, 2});
  const auto missing = mesh.facets.back();
  mesh.facets.pop_back();
  const Surfaces torn(mesh);
  const SubjectSurface found = torn.of({.of = Of::open_edges});
  EXPECT_EQ(found.edges.size(), 3U);
  for (const auto& [a, b] : found.edges)
    for (const VertexIndex end : {a, b})
      EXPECT_NE(std::ranges::find(missing, end), missing.end()) << "an edge of the hole";
  std::vector<FacetIndex> facets;
  for (const SplitPiece& piece : found.mesh.pieces) facets.push_back(piece.facet);
  std::ranges::sort(facets);
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  EXPECT_EQ(facets.size(), 3U) << "one on the other side of each";
}

TEST(VerdictSurface, OfTurnedFacetsAndCrossingsIsFound) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {2, 2, 2});
  std::swap(mesh.facets.front()[0], mesh.facets.front()[1]);
  const SubjectSurface turned = Surfaces(mesh).of({.of = Of::turned_edges});
  EXPECT_EQ(turned.edges.size(), 3U);
  EXPECT_TRUE(
      std::ranges::any_of(turned.mesh.pieces, [](const SplitPiece& piece) { return piece.facet == 0; }));
  // Two boxes through each other.
  TriangleMesh crossing = test::box_mesh({0, 0, 0}, {2, 2, 2});
  const TriangleMesh other = test::box_mesh({1, 1, 1}, {3, 3, 3});
  const auto first = static_cast<VertexIndex>(crossing.vertices.size());
  crossing.vertices.insert(crossing.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.facets) crossing.facets.push_back({first + a, first + b, first + c});
  const Surfaces crossed(crossing);
  const std::size_t count = crossed.of({.of = Of::crossings}).mesh.pieces.size();
  EXPECT_GT(count, 4U);
  EXPECT_LT(count, crossing.facets.size());
  EXPECT_TRUE(Surfaces(test::box_mesh({0, 0, 0}, {2, 2, 2})).of({.of = Of::crossings}).mesh.pieces.empty());
}

TEST(VerdictSurface, IsEmptyWhereTheAnswersDoNotBelongTogether) {
  const Surfaces pocket(test::plate_with_side_pocket({}).mesh), box(test::box_mesh({0, 0, 0}, {1, 1, 1}));
  const auto model = [] {
    Part part;
    part.mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
    part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
    return prepare_part(std::move(part), Progress());
  }();
  EXPECT_TRUE(
      surface_of({.of = Of::undercuts}, *model, box.regions->split.get(), pocket.plan).mesh.pieces.empty());
  EXPECT_TRUE(surface_of({.of = Of::undercuts}, *model, nullptr, box.plan).mesh.pieces.empty());
  EXPECT_TRUE(surface_of({}, *model, nullptr, nullptr).mesh.pieces.empty());
}

}  // namespace
}  // namespace moldlight
