// Whoever cancels does not wait, whatever the shape.
#include <ctime>

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

/// Loose facets thrown together: they hide each other from everywhere.
TriangleMesh loose_facets(std::size_t count) {
  test::Random random(20);
  TriangleMesh mesh;
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec3 at = random.in_cube(50.0);
    const auto first = static_cast<VertexIndex>(mesh.vertices.size());
    for (int corner = 0; corner < 3; ++corner) mesh.vertices.push_back(at + random.in_cube(10.0));
    mesh.facets.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

std::shared_ptr<const PartModel> soup(std::size_t count) {
  Part part;
  part.mesh = loose_facets(count);
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  return prepare_part(std::move(part), Progress());
}

TEST(Cancelling, FindingActionsEndsAtOnceInEveryStage) {
  const auto model = soup(50);
  Query query;
  query.direction = glm::dvec3(0.133, 0.546, -0.914);
  const Classification result = classify_exact(*model, query, Progress(), true);
  for (const char* stage : {"joining undercuts", "looking for side actions", "looking for threads",
                            "splitting undercuts that no single action releases", "looking for loose inserts",
                            "choosing the least set", "describing undercuts"}) {
    std::clock_t cancelled = 0;
    Progress* asked = nullptr;
    Progress progress([&](std::string_view now, double) {
      if (now != stage || cancelled != 0) return;
      cancelled = std::clock();
      asked->cancel();
    });
    asked = &progress;
    EXPECT_THROW(static_cast<void>(find_actions(*model, result, {}, progress)), Cancelled) << stage;
    const double late_s = static_cast<double>(std::clock() - cancelled) / CLOCKS_PER_SEC;
    EXPECT_LT(late_s, 0.5) << "of the processor, cancelled in the stage: " << stage;
  }
}

TEST(Cancelling, CountingUndercutsEndsAtOnce) {
  const auto model = soup(50);
  const ExactQuery query = exact_query(*model, Query{});
  const Classification result = classify_exact(*model, {}, Progress(), true);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(static_cast<void>(find_undercuts(*model, *result.split, query, progress)), Cancelled);
}

}  // namespace
}  // namespace moldlight
