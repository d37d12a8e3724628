// What every test of mold halves asks of their certificate.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "parting/mold_files.hpp"
#include "support/mold_checks.hpp"

namespace moldlight::test {

/// All that the certificate promises, found anew on what would be written.
inline void expect_certified(const MoldHalves& halves, const std::string& name,
                             const TriangleMesh* part = nullptr) {
  ASSERT_TRUE(halves.made()) << name << ": " << halves.refusal;
  EXPECT_LE(std::abs(halves.volume_gap), 1e-9) << name;
  EXPECT_LE(halves.fold_area, 1e-8) << name;
  const WrittenMold written = written_mold(halves);
  ASSERT_EQ(written.refusal, "") << name;
  std::vector<TriangleMesh> bodies;
  for (const WrittenBody& body : written.bodies) {
    EXPECT_TRUE(body.closed) << name;
    EXPECT_NEAR(signed_volume(body.mesh), body.volume, 1e-5 * halves.block_volume) << name;
    bodies.push_back(body.mesh);
  }
  const glm::dvec3 up = written.part_frame ? halves.frame.z : glm::dvec3(0, 0, 1);
  EXPECT_LE(undercut_share(bodies[0], up, 0.01), 1e-6) << name;
  EXPECT_LE(undercut_share(bodies[1], -up, 0.01), 1e-6) << name;
  if (part != nullptr) bodies.push_back(*part);
  if (part != nullptr) {
    EXPECT_EQ(misplaced_points(bodies, 20000, 7), 0U) << name;
  }
  for (const TriangleMesh& body : bodies) {
    const Bounds box = bounds(body);
    const SectionCheck sections = check_sections(body, (box.max.z - box.min.z) / 40.0);
    EXPECT_GE(sections.sections, 39U) << name;
    EXPECT_EQ(sections.open, 0U) << name;
    EXPECT_EQ(sections.crossing, 0U) << name;
  }
}

}  // namespace moldlight::test
