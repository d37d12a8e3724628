// How far a point gets away along a pull, past surface that is all but parallel to it.
#include "actions/release.hpp"

#include <cmath>
#include <limits>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

/// A slot open to +x. Its floor rises to there by `rise_deg`; at x = 40 stands a lip on it.
struct Slot {
  double rise_deg = 0.0, lip = 0.0;
  [[nodiscard]] double floor(double x) const { return 4.0 + (x - 10.0) * std::tan(glm::radians(rise_deg)); }
};

/// Of the floor at x = 12.
double free_along_x(const Slot& slot, double lateral) {
  test::SolidBuilder solid;
  const double top = slot.floor(40) + slot.lip;
  test::Loop2 profile = {{0, 0}, {44, 0}, {44, top}, {40, top}};
  if (slot.lip > 0.0) profile.push_back({40, slot.floor(40)});
  profile.insert(profile.end(), {{10, 4}, {10, 16}, {44, 16}, {44, 20}, {0, 20}});
  solid.extrude(profile, {}, 12.0);
  Part part;
  part.mesh = solid.mesh();
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  const auto model = prepare_part(std::move(part), Progress());
  const double rise = glm::radians(slot.rise_deg);
  const UndercutSample sample{
      model->frame.to_unit({12, 6, slot.floor(12)}), {-std::sin(rise), 0, std::cos(rise)}, 1.0};
  const Release release(*model, {.direction = {0, 0, 1}, .tau_deg = 1.0, .lateral = lateral});
  return release.free_length(sample, {1, 0, 0}) * model->frame.diagonal;
}

/// The floor is passed as if it were parallel to the pull; the lip that stands on it is not, though a
/// straight way into the floor would run below it.
TEST(Release, OfAFloorEndsAtWhatStandsOnIt) {
  for (const double lateral : {0.0, 1e-6, 1.0 / 2048.0}) {
    for (const double rise_deg : {-1.5, -0.5, 0.0, 0.1, 0.5, 0.95}) {
      EXPECT_NEAR(free_along_x({rise_deg, 1.0}, lateral), 28.0, 1e-3) << rise_deg << " " << lateral;
      EXPECT_EQ(free_along_x({rise_deg, 0.0}, lateral), std::numeric_limits<double>::infinity())
          << rise_deg << " " << lateral;
    }
    EXPECT_EQ(free_along_x({1.05, 0.0}, lateral), 0.0) << "it faces against the pull";
  }
}

}  // namespace
}  // namespace moldlight
