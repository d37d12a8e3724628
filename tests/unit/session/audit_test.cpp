// The audit extrapolates what exact rays find wrong with every 61st sample to the whole surface.
#include <cmath>

#include <gtest/gtest.h>

#include "mold/measure.hpp"
#include "mold/settle.hpp"
#include "session/classifier.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

constexpr double k_area = 600.0;
constexpr std::uint64_t k_samples = 100'000;

/// Of a cube of which nothing is an undercut, every sample given these verdict bits and this doubt.
Audit audit_of_cube(std::uint8_t verdict, std::uint8_t doubt) {
  Part part;
  part.mesh = test::box_mesh({0, 0, 0}, {10, 10, 10});
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  const auto model = prepare_part(std::move(part), Progress());
  const SurfaceSamples samples = sample_surface(model->part.mesh, model->geometry, model->frame, k_samples);
  const std::vector<FacetClass> classes = facet_classes(model->geometry, {0, 0, 1}, 1.0);
  const ExactAnswers exact{*model->rays, model->geometry, classes, {.direction = {0, 0, 1}, .lateral = 1e-3}};
  const std::vector<std::uint8_t> verdicts(samples.samples.size(), verdict),
      doubtful(samples.samples.size(), doubt);
  return audit_undoubted(samples, exact, verdicts, doubtful);
}

TEST(Audit, ExtrapolatesToTheWholeSurface) {
  const Audit audit = audit_of_cube(0, 0);
  EXPECT_NEAR(static_cast<double>(audit.audited), k_samples / 61.0, 2.0);
  EXPECT_EQ(audit.wrong, audit.audited);
  EXPECT_NEAR(audit.undercut_bias, -k_area, 0.01 * k_area) << "undercut was given where there is none";
  EXPECT_NEAR(audit.undercut_error, k_area / std::sqrt(static_cast<double>(audit.audited)), 0.01 * k_area);
}

TEST(Audit, CountsTheUndercutAlone) {
  const Audit audit = audit_of_cube(verdict::k_accessible_plus, 0);
  EXPECT_NEAR(static_cast<double>(audit.wrong), 5.0 / 6.0 * static_cast<double>(audit.audited), 20.0)
      << "only the top is the core's";
  EXPECT_EQ(audit.undercut_bias, 0.0);
  EXPECT_EQ(audit.undercut_error, 0.0);
}

TEST(Audit, LeavesOutWhatIsInDoubt) { EXPECT_EQ(audit_of_cube(0, 1).audited, 0U); }

}  // namespace
}  // namespace moldlight
