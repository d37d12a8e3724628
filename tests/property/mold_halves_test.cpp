// Mold halves of real parts along their axes: those that come are what their certificate says, by means that
// made none of it; how many are refused, and why.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/median.hpp"
#include "base/stopwatch.hpp"
#include "classify/part_model.hpp"
#include "mesh/health.hpp"
#include "parting/loops.hpp"
#include "parting/mold_files.hpp"
#include "support/manifest.hpp"
#include "support/mold_checks.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> part_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(test::asset_folder() / "parts"))
    files.push_back(entry.path());
  std::ranges::sort(files);
  if (const auto shared = test::shared_folder()) {
    for (const test::ManifestRow& row : test::read_manifest()) {
      const bool large = row.facets.value_or(0) > 70000;  // they take as long as all others
      if (!row.file.starts_with("bad/") && row.facets.value_or(0) > 0 && !large)
        files.push_back(*shared / "parts" / row.file);
    }
  }
  return files;
}

glm::dvec3 axis_direction(int axis) {
  glm::dvec3 d(0.0);
  d[axis] = 1.0;
  return d;
}

struct Tally {
  std::size_t rows = 0, made = 0, crowded = 0, crossed = 0, steep = 0;
  double worst_gap = 0.0, worst_undercut = 0.0;
  std::vector<double> times_ms;
  std::map<std::string, std::size_t> refusals;
};

void check_bodies(const MoldHalves& halves, const WrittenMold& written, const std::string& name,
                  Tally& tally) {
  const glm::dvec3 up = written.part_frame ? halves.frame.z : glm::dvec3(0, 0, 1);
  bool crowded = false;
  for (std::size_t k = 0; k < written.bodies.size(); ++k) {
    const WrittenBody& body = written.bodies[k];
    EXPECT_TRUE(body.closed) << name << " " << body.name;
    crowded = crowded || (k < 2 && body.crowded_edges > 0);
    if (k >= 2) continue;
    EXPECT_LE(body.undercut, 1e-8) << name << " " << body.name;
    EXPECT_NEAR(signed_volume(body.mesh) / body.volume, 1.0, 1e-4) << name << " " << body.name;
    const double undercut = test::undercut_share(body.mesh, k == 0 ? up : -up, 0.01);
    tally.worst_undercut = std::max(tally.worst_undercut, undercut);
    EXPECT_LE(undercut, 3e-6) << name << " " << body.name;
    // As a printer slices it.
    const Bounds box = bounds(body.mesh);
    for (int axis = 0; axis < 3; ++axis) {
      const int layers = 50;
      for (int layer = 1; layer < layers && axis == 2; ++layer) {
        const double z = box.min.z + (box.max.z - box.min.z) * layer / layers;
        EXPECT_EQ(test::open_outlines(body.mesh, z), 0U) << name << " " << body.name << " at " << z;
      }
    }
  }
  tally.crowded += crowded ? 1 : 0;
}

TEST(MoldHalvesOfParts, AreWhatTheirCertificateSays) {
  Tally tally;
  for (const fs::path& file : part_files()) {
    const auto model = load_part(file.string(), {}, Progress{});
    if (!model->health.closed) continue;
    static_cast<void>(model->exact(Progress{}));
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec3 d = axis_direction(axis);
      const std::string name = fmt::format("{} along {}", file.filename().string(), "xyz"[axis]);
      ++tally.rows;
      const Stopwatch watch;
      const MoldHalves halves = make_halves(*model, d, glm::dot(model->frame.center, d), {}, Progress{});
      tally.times_ms.push_back(watch.elapsed_ms());
      const WrittenMold written = written_mold(halves);
      if (!written.refusal.empty()) {
        ++tally.refusals[name + ": " + written.refusal];
        continue;
      }
      ++tally.made;
      EXPECT_LE(std::abs(halves.volume_gap), 1e-9) << name;
      tally.worst_gap = std::max(tally.worst_gap, std::abs(halves.volume_gap));
      tally.crossed += halves.core.crossed_facets + halves.cavity.crossed_facets > 0 ? 1 : 0;
      tally.steep += halves.steepest_deg > 60.01 ? 1 : 0;
      check_bodies(halves, written, name, tally);
    }
  }
  std::cout << fmt::format(
      "{} parts along axes, {} with halves, {} of them with edges of four facets, {} with facets that cross "
      "by rounding, {} with a parting surface "
      "steeper "
      "than asked somewhere; volumes at most {:.1e} of the block apart, undercut at most {:.1e} of a half; "
      "median "
      "{:.0f} ms, longest {:.0f} ms\n",
      tally.rows, tally.made, tally.crowded, tally.crossed, tally.steep, tally.worst_gap,
      tally.worst_undercut, median(tally.times_ms), *std::ranges::max_element(tally.times_ms));
  for (const auto& [refusal, count] : tally.refusals) std::cout << "refused: " << refusal << "\n";
  EXPECT_GE(tally.made * 100, tally.rows * 95);
}

/// Ten rows: no two facets of a body cross, and a random point lies in exactly one of block's halves, part
/// and inserts.
TEST(MoldHalvesOfParts, FillTheBlockOnce) {
  std::size_t rows = 0, misplaced = 0, crossed = 0, by_rounding = 0;
  constexpr std::size_t k_points = 100000;
  for (const fs::path& file : part_files()) {
    if (rows >= 10) break;
    const auto model = load_part(file.string(), {}, Progress{});
    if (!model->health.closed || model->health.facets > 25000) continue;
    const glm::dvec3 d = axis_direction(2);
    const MoldHalves halves = make_halves(*model, d, glm::dot(model->frame.center, d), {}, Progress{});
    if (!halves.made()) continue;
    if (halves.core.crossed_facets + halves.cavity.crossed_facets > 0) {
      ++by_rounding;
      continue;
    }
    ++rows;
    std::vector<TriangleMesh> bodies = {halves.core.mesh, halves.cavity.mesh, model->part.mesh};
    for (glm::dvec3& vertex : bodies[2].vertices) vertex = halves.frame.to_mold(vertex - halves.centre);
    for (const MoldBody& insert : halves.inserts) bodies.push_back(insert.mesh);
    const std::size_t wrong = test::misplaced_points(bodies, k_points, 11);
    // Voids thinner than a tolerance are in no body; the report tells their volume.
    const double in_specks = k_points * std::abs(halves.specks_volume) / halves.block_volume;
    EXPECT_LE(static_cast<double>(wrong), in_specks < 1e-3 ? 0.0 : 3.0 + 3.0 * in_specks) << file;
    misplaced += wrong;
    for (std::size_t k = 0; k < 2; ++k) crossed += test::crossed_facets(bodies[k]);
  }
  std::cout << fmt::format(
      "{} parts along z: {} of {} points in none or several bodies, {} facets that cross others; {} parts "
      "left out, whose report tells of facets that cross by rounding\n",
      rows, misplaced, rows * k_points, crossed, by_rounding);
  EXPECT_EQ(crossed, 0U);
  EXPECT_GE(rows, 4U);
}

TEST(PartingLineOfParts, HasTheLoopsThatItsHandlesAskFor) {
  std::size_t rows = 0, free_of_actions = 0, as_asked = 0;
  std::vector<double> times_ms;
  for (const fs::path& file : part_files()) {
    const auto model = load_part(file.string(), {}, Progress{});
    if (!model->health.closed) continue;
    static_cast<void>(model->exact(Progress{}));
    for (int axis = 0; axis < 3; ++axis) {
      const std::string name = fmt::format("{} along {}", file.filename().string(), "xyz"[axis]);
      const Stopwatch watch;
      const Assignment assignment = assign_sides(*model, {axis_direction(axis), {}}, {}, Progress{});
      const PartingLine line = parting_line(assignment);
      times_ms.push_back(watch.elapsed_ms());
      ++rows;
      EXPECT_TRUE(line.euler.sums()) << name;
      const double slack = 1e-9 * (1.0 + assignment.energy);
      EXPECT_LE(assignment.energy, assignment.energy_to_core + slack) << name;
      EXPECT_LE(assignment.energy, assignment.energy_to_cavity + slack) << name;
      if (assignment.area(MoldSide::action) > 0.0) continue;
      ++free_of_actions;
      if (line.euler.loops == line.euler.expected_loops) {
        ++as_asked;
      } else {
        std::cout << name << ": " << parting_verdict(assignment, line, model->frame.diagonal) << "\n";
      }
    }
  }
  std::cout << fmt::format(
      "{} parts along axes, {} without side actions, {} of them with genus + 1 loops; median {:.0f} ms, "
      "longest "
      "{:.0f} ms\n",
      rows, free_of_actions, as_asked, median(times_ms), *std::ranges::max_element(times_ms));
  EXPECT_GE(as_asked * 100, free_of_actions * 90);
}

}  // namespace
}  // namespace moldlight
