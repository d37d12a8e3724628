// A facet whose draft is exactly the draft tolerance has draft enough, for a single facet as for all of a
// part.
#include <cmath>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "classify/classifier.hpp"
#include "mold/draft.hpp"

namespace moldlight {
namespace {

constexpr double k_tau_deg = 30.0;

glm::dvec3 normal_with_sine(double sine) { return {std::sqrt(1.0 - sine * sine), 0.0, sine}; }

TEST(FacetClasses, HoldTheDraftToleranceItself) {
  const glm::dvec3 up(0, 0, 1);
  const double at = std::sin(glm::radians(k_tau_deg)), below = std::nextafter(at, 0.0);
  FacetGeometry geometry;
  for (const double sine : {at, -at, below, -below}) geometry.normals.push_back(normal_with_sine(sine));
  const std::vector<FacetClass> expected = {FacetClass::up, FacetClass::down, FacetClass::near_vertical,
                                            FacetClass::near_vertical};
  EXPECT_EQ(facet_classes(geometry, up, k_tau_deg), expected);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(facet_class(geometry.normals[i], up, k_tau_deg), expected[i]) << i;
  }
}

}  // namespace
}  // namespace moldlight
