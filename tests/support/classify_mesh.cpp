#include "support/classify_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gl/headless_context.hpp"

namespace moldlight::test {

const gl::Context& shared_context() {
  static const std::unique_ptr<gl::Context> k_context =
      gl::create_headless_context(gl::HeadlessBackend::automatic);
  k_context->make_current();
  return *k_context;
}

std::shared_ptr<const PartModel> model_of(TriangleMesh mesh, double effort) {
  Part part;
  part.effort = effort;
  part.file = "(test)";
  part.bodies = {{"", 0, static_cast<FacetIndex>(mesh.facets.size())}};
  part.mesh = std::move(mesh);
  return prepare_part(std::move(part), Progress{});
}

Classification classify_mesh(TriangleMesh mesh, const Query& query) {
  return Classifier(shared_context(), model_of(std::move(mesh))).classify(query, Progress{});
}

double worst_region_error(const Classification& result, const RegionValues& expected) {
  double worst = 0.0;
  for (const Region region : k_regions) {
    worst = std::max(worst, std::abs(result.areas[region] - expected[region]));
  }
  return worst / result.total_area;
}

}  // namespace moldlight::test
