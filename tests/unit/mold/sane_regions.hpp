// What must hold of the exact regions of any mesh, from many directions.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "support/exact_model.hpp"
#include "support/shapes.hpp"
#include "support/split_checks.hpp"

namespace moldlight {

inline constexpr test::ShapeSettings k_settings{.tau_deg = 1.0, .lateral_tolerance = 0.02};

inline std::vector<glm::dvec3> directions() {
  std::vector<glm::dvec3> all = test::five_directions();
  all.push_back(glm::normalize(glm::dvec3(1, 1, 0)));  // along diagonals of boxes
  all.push_back(glm::normalize(glm::dvec3(1, 1, 1)));
  all.push_back(glm::normalize(glm::dvec3(1e-9, 0, 1)));
  all.push_back(glm::normalize(glm::dvec3(1e-4, -1e-5, -1)));
  return all;
}

/// Whatever the mesh: areas that make up the whole, and a sound split with the same areas.
inline void expect_sane(const TriangleMesh& mesh, const test::ShapeSettings& settings,
                        const std::string& name) {
  const test::ExactModel model(mesh);
  const double total = model.geometry().total_area;
  std::size_t number = 0;
  for (const glm::dvec3& direction : directions()) {
    const std::string of = name + ", direction " + std::to_string(number++);
    const ExactAreas areas = model.areas(direction, settings);
    ASSERT_EQ(areas.facet_fractions.size(), mesh.facets.size()) << of;
    for (std::size_t facet = 0; facet < mesh.facets.size(); ++facet) {
      double sum = 0.0;
      for (const double share : areas.facet_fractions[facet]) {
        EXPECT_TRUE(share >= 0.0 && share <= 1.0 + 1e-12) << of << ", facet " << facet;
        sum += share;
      }
      if (model.geometry().areas[facet] == 0.0) {
        EXPECT_EQ(sum, 0.0) << of;
      } else {
        EXPECT_TRUE(std::abs(sum - 1.0) < 1e-12 || model.geometry().areas[facet] < 1e-12 * total)
            << of << ", facet " << facet << " of area " << model.geometry().areas[facet];
      }
    }
    EXPECT_NEAR(areas.areas.total(), total, 1e-10 * total) << of;
    for (const double projected : {areas.projected_core, areas.projected_cavity, areas.near_vertical_area})
      EXPECT_TRUE(projected >= 0.0 && projected <= total * (1.0 + 1e-12)) << of << ": " << projected;
    const ExactSplit split = model.split(direction, settings);
    EXPECT_EQ(split.areas.areas.values, areas.areas.values) << of;
    test::expect_sound_split(model, split, of);
    test::expect_whole_borders(split.mesh, of);
    if (settings.lateral_tolerance == 0.0) continue;  // rays along walls show nothing
    const test::RayVerdicts verdicts = test::ray_verdicts(model, split.mesh, direction, settings, 100, 1);
    EXPECT_TRUE(verdicts.wrong.empty())
        << of << ": " << verdicts.wrong.size() << " of " << verdicts.pieces << ", " << verdicts.wrong.front();
  }
}

}  // namespace moldlight
