// What a live page gets of a part with too many facets: fewer of them, and an error that has what they are
// off.
#include <algorithm>

#include <gtest/gtest.h>

#include "classify/classifier.hpp"
#include "report/describe/describe.hpp"
#include "support/classify_mesh.hpp"
#include "support/curved_solids.hpp"
#include "support/random.hpp"

namespace moldlight {
namespace {

report::Report live_report(const std::shared_ptr<const PartModel>& model, std::size_t most_facets) {
  Study study(model);
  const Progress progress;
  return report::classify_report({.model = model,
                                  .progress = progress,
                                  .gl = &test::shared_context(),
                                  .live = true,
                                  .most_live_facets = most_facets},
                                 study);
}

TEST(LiveReport, OfManyFacetsHasFewerAndSaysWhatTheyAreOff) {
  const auto model = test::model_of(test::torus_mesh(20.0, 6.0, 80, 40));
  const std::size_t facets = model->part.mesh.facets.size();
  const report::Report coarse = live_report(model, facets / 5);
  ASSERT_TRUE(coarse.live);
  EXPECT_LE(coarse.live->mesh.facets.size(), facets / 5);
  EXPECT_GT(coarse.live->mesh.facets.size(), facets / 8);
  for (const std::size_t number : {coarse.live->mesh.facets.size(), facets})
    EXPECT_NE(coarse.live_notice.find(std::to_string(number)), std::string::npos) << coarse.live_notice;
  EXPECT_EQ(coarse.live->known.front().areas.values, classify_exact(*model, {}, Progress()).areas.values)
      << "what is exact is the part's";

  const auto drawn = test::model_of(coarse.live->mesh);
  const double stated = coarse.live->errors.back().resting;
  test::Random random(7);
  double worst = 0.0;
  for (int k = 0; k < 30; ++k) {
    const Query query{Direction(random.in_cube(1.0)), {}};
    const RegionValues exact = classify_exact(*model, query, Progress()).areas;
    worst = std::max(worst, test::worst_region_error(classify_exact(*drawn, query, Progress()), exact));
  }
  EXPECT_LT(worst, stated);
  EXPECT_GT(worst, 0.05 * stated) << "the coarser mesh is off";
}

}  // namespace
}  // namespace moldlight
