// Mold halves of real parts along their axes: those that come are what their certificate says, by means that
// made none of it; how many are refused, and why.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <numeric>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/numbers.hpp"
#include "base/stopwatch.hpp"
#include "classify/part_model.hpp"
#include "mesh/health.hpp"
#include "parting/loops.hpp"
#include "parting/make_halves.hpp"
#include "parting/mold_files.hpp"
#include "parting/planar_line.hpp"
#include "support/exact_crossing.hpp"
#include "support/mold_checks.hpp"
#include "support/mold_rows.hpp"

namespace moldlight {
namespace {

using test::part_rows;
using test::PartRows;
using test::row_name;

MoldHalves halves_of(const PartModel& model, const glm::dvec3& d) {
  return make_halves(model, d, {.height = glm::dot(model.frame.center, d)}, {}, Progress{});
}

struct Tally {
  std::size_t rows = 0, made = 0, touching = 0, crossed = 0, contacts = 0, unforced = 0, needles = 0,
              facets = 0;
  double worst_gap = 0.0, worst_undercut = 0.0;
  std::vector<double> times_ms;
  std::map<std::string, std::size_t> refusals;
};

/// Edges with another count of facets than two, of vertices that are apart and of those that are not in one
/// place.
std::size_t edges_not_of_two(const TriangleMesh& mesh) {
  std::vector<VertexIndex> order(mesh.vertices.size()), place(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto at = [&](VertexIndex vertex) {
    const glm::dvec3& v = mesh.vertices[vertex];
    return std::array{v.x, v.y, v.z};
  };
  std::ranges::sort(order, {}, at);
  for (std::size_t k = 0; k < order.size(); ++k)
    place[order[k]] = k > 0 && at(order[k - 1]) == at(order[k]) ? place[order[k - 1]] : order[k];
  std::size_t others = 0;
  for (const bool welded : {false, true}) {
    std::vector<std::pair<VertexIndex, VertexIndex>> uses;
    for (const auto& facet : mesh.facets) {
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexIndex a = facet[k], b = facet[(k + 1) % 3];
        uses.push_back(welded ? std::minmax(place[a], place[b]) : std::minmax(a, b));
      }
    }
    std::ranges::sort(uses);
    for (auto use = uses.begin(), end = use; use != uses.end(); use = end) {
      end = std::upper_bound(use, uses.end(), *use);
      others += end - use != 2 ? 1 : 0;
    }
  }
  return others;
}

std::size_t needles_of(const TriangleMesh& mesh, double thinnest) {
  std::size_t needles = 0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3 &a = mesh.corner(facet, 0), &b = mesh.corner(facet, 1), &c = mesh.corner(facet, 2);
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    needles += glm::length(glm::cross(b - a, c - a)) < thinnest * longest ? 1 : 0;
  }
  return needles;
}

void check_bodies(const MoldHalves& halves, const WrittenMold& written, double diagonal,
                  const std::string& name, Tally& tally) {
  const glm::dvec3 up = written.part_frame ? halves.frame.z : glm::dvec3(0, 0, 1);
  bool touches = false;
  for (std::size_t k = 0; k < written.bodies.size(); ++k) {
    const WrittenBody& body = written.bodies[k];
    EXPECT_TRUE(body.closed) << name << " " << body.name;
    if (k >= 2) continue;
    EXPECT_EQ(edges_not_of_two(body.mesh), 0U) << name << " " << body.name;
    touches = touches || body.nonmanifold_edges > 0;
    EXPECT_LE(body.undercut, 1e-8) << name << " " << body.name;
    EXPECT_NEAR(signed_volume(body.mesh) / body.volume, 1.0, 1e-4) << name << " " << body.name;
    const std::size_t needles = needles_of(body.mesh, 1e-7 * halves.scale * diagonal);
    EXPECT_EQ(needles, (k == 0 ? halves.core : halves.cavity).needles) << name << " " << body.name;
    tally.needles += needles;
    tally.facets += body.mesh.facets.size();
    const double undercut = test::undercut_share(body.mesh, k == 0 ? up : -up, 0.01);
    tally.worst_undercut = std::max(tally.worst_undercut, undercut);
    EXPECT_LE(undercut, 1e-6) << name << " " << body.name;
  }
  tally.touching += touches ? 1 : 0;
}

TEST(MoldHalvesOfParts, AreWhatTheirCertificateSays) {
  Tally tally;
  for (const PartRows& file : part_rows()) {
    const auto model = load_part(file.path.string(), {}, Progress{});
    if (!model->health.closed) continue;
    static_cast<void>(model->exact(Progress{}));
    for (const glm::dvec3& d : file.directions) {
      const std::string name = row_name(file, d);
      ++tally.rows;
      // As the command makes them: along the parting line.
      const MoldLine line = find_mold_line(*model, {d, {}}, {}, Progress{});
      const Stopwatch watch;
      const MoldHalves halves = make_halves(*model, d, meeting_place(line), {}, Progress{});
      tally.times_ms.push_back(watch.elapsed_ms());
      const WrittenMold& written = halves.written;
      if (!written.refusal.empty()) {
        ++tally.refusals[name + ": " + written.refusal];
        continue;
      }
      ++tally.made;
      EXPECT_LE(std::abs(halves.volume_gap), 1e-9) << name;
      tally.worst_gap = std::max(tally.worst_gap, std::abs(halves.volume_gap));
      tally.crossed += halves.core.crossed_facets + halves.cavity.crossed_facets > 0 ? 1 : 0;
      EXPECT_LE(halves.surface.steepest_deg, 60.0) << name;
      tally.contacts += halves.contact_area > 0.0 ? 1 : 0;
      tally.unforced += halves.contact_area > 0.0 && !halves.forced_at ? 1 : 0;
      check_bodies(halves, written, model->frame.diagonal, name, tally);
    }
  }
  std::cout << fmt::format(
      "{} rows of parts and directions, {} with halves, {} of them with a half that touches itself in an "
      "edge, "
      "{} with facets that cross by rounding, {} where the halves touch on upright walls, {} of them "
      "although the "
      "part's outline is nowhere steeper than asked; "
      "volumes "
      "at most {:.1e} of the block apart, undercut at most {:.1e} of a half; median {:.0f} ms, longest "
      "{:.0f} "
      "ms\n",
      tally.rows, tally.made, tally.touching, tally.crossed, tally.contacts, tally.unforced, tally.worst_gap,
      tally.worst_undercut, median(tally.times_ms), *std::ranges::max_element(tally.times_ms));
  std::cout << fmt::format("{} of {} facets are needles\n", tally.needles, tally.facets);
  EXPECT_LE(100 * tally.needles, tally.facets);
  for (const auto& [refusal, count] : tally.refusals) std::cout << "refused: " << refusal << "\n";
  EXPECT_GE(tally.made * 100, tally.rows * 97);
  EXPECT_LE(tally.unforced * 100, tally.rows * 2);
}

/// Ten rows, of other directions one after the other: no two facets of a half cross, and a random point lies
/// in exactly one of block's halves, part and inserts.
TEST(MoldHalvesOfParts, FillTheBlockOnce) {
  std::size_t rows = 0, misplaced = 0, crossing = 0, by_rounding = 0;
  constexpr std::size_t k_points = 100000;
  for (const PartRows& file : part_rows(25000)) {
    if (rows >= 10) break;
    const auto model = load_part(file.path.string(), {}, Progress{});
    if (!model->health.closed) continue;
    const glm::dvec3 d = file.directions[(rows + by_rounding) % file.directions.size()];
    const MoldHalves halves = halves_of(*model, d);
    const WrittenMold& written = halves.written;
    if (!written.refusal.empty()) continue;
    if (halves.core.crossed_facets + halves.cavity.crossed_facets > 0) {
      ++by_rounding;
      continue;
    }
    ++rows;
    std::vector<TriangleMesh> bodies;
    for (const WrittenBody& body : written.bodies) bodies.push_back(body.mesh);
    for (std::size_t k = 0; k < 2; ++k) crossing += test::exactly_crossing_pairs(bodies[k]);
    bodies.push_back(model->part.mesh);
    if (!written.part_frame) {
      for (glm::dvec3& vertex : bodies.back().vertices) vertex = halves.frame.to_mold(vertex - halves.centre);
    }
    const std::size_t wrong = test::misplaced_points(bodies, k_points, 11);
    // Voids thinner than a tolerance are in no body; the report shows their volume. Single precision moves
    // walls by a ten-millionth.
    const double in_specks = k_points * std::abs(halves.specks_volume) / halves.block_volume;
    EXPECT_LE(static_cast<double>(wrong), in_specks < 1e-3 ? 1.0 : 3.0 + 3.0 * in_specks)
        << row_name(file, d);
    misplaced += wrong;
  }
  std::cout << fmt::format(
      "{} rows: {} of {} points in none or several bodies, {} pairs of facets that cross; {} rows left out, "
      "whose report has facets that cross by rounding\n",
      rows, misplaced, rows * k_points, crossing, by_rounding);
  EXPECT_EQ(crossing, 0U);
  EXPECT_GE(rows, 3U);
}

/// Every 0.2 of the part's unit, or a thousandth of its height where that is more.
TEST(MoldHalvesOfParts, SliceIntoOutlinesThatCloseAndDoNotCross) {
  std::size_t rows = 0, sections = 0;
  for (const PartRows& file : part_rows(20000)) {
    const auto model = load_part(file.path.string(), {}, Progress{});
    if (!model->health.closed) continue;
    const WrittenMold written = halves_of(*model, file.pull).written;
    if (!written.refusal.empty()) continue;
    ++rows;
    for (std::size_t k = 0; k < 2; ++k) {
      const Bounds box = bounds(written.bodies[k].mesh);
      const double height = box.max.z - box.min.z;
      const test::SectionCheck check =
          test::check_sections(written.bodies[k].mesh, std::clamp(0.2, height / 1000.0, height / 20.0));
      EXPECT_EQ(check.open, 0U) << file.path << " " << written.bodies[k].name;
      EXPECT_EQ(check.crossing, 0U) << file.path << " " << written.bodies[k].name;
      sections += check.sections;
    }
  }
  std::cout << fmt::format("{} parts along their pulls, {} sections\n", rows, sections);
  EXPECT_GE(rows, 4U);
}

TEST(PartingLineOfParts, HasTheLoopsThatItsHandlesAskFor) {
  std::size_t rows = 0, free_of_actions = 0, as_asked = 0, with_other_count = 0;
  for (const PartRows& file : part_rows()) {
    const auto model = load_part(file.path.string(), {}, Progress{});
    if (!model->health.closed) continue;
    static_cast<void>(model->exact(Progress{}));
    for (const glm::dvec3& d : file.directions) {
      const std::string name = row_name(file, d);
      const Assignment assignment = assign_sides(*model, {d, {}}, {}, Progress{});
      const PartingLine line = parting_line(assignment);
      ++rows;
      EXPECT_TRUE(line.euler.sums()) << name;
      EXPECT_TRUE(line.euler.accounted()) << name << ": " << parting_verdict(assignment, line, *model);
      with_other_count += line.euler.loops != line.euler.expected_loops ? 1 : 0;
      const double slack = 1e-9 * (1.0 + assignment.energy);
      EXPECT_LE(assignment.energy, assignment.energy_to_core + slack) << name;
      EXPECT_LE(assignment.energy, assignment.energy_to_cavity + slack) << name;
      if (assignment.area(MoldSide::action) > 0.0) continue;
      ++free_of_actions;
      if (line.euler.loops == line.euler.expected_loops) {
        ++as_asked;
      } else {
        std::cout << name << ": " << parting_verdict(assignment, line, *model) << "\n";
      }
    }
  }
  std::cout << fmt::format(
      "{} rows of parts and directions, {} without side actions, {} of them with genus + 1 loops; {} with "
      "another count, which their side actions account for\n",
      rows, free_of_actions, as_asked, with_other_count);
  EXPECT_EQ(as_asked, free_of_actions);
}

}  // namespace
}  // namespace moldlight
