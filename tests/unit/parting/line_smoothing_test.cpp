// The parting line on wavy surface.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "parting/loops.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/curved_solids.hpp"
#include "support/mesh_edits.hpp"
#include "support/process.hpp"

namespace moldlight {
namespace {

struct Smoothed {
  std::shared_ptr<const PartModel> model;
  Assignment assignment;
  PartingLine line;
};

Smoothed smoothed_line(TriangleMesh mesh, double soft_deg, double effort = 1.0) {
  Smoothed found;
  found.model = test::model_of(std::move(mesh), effort);
  MoldSettings settings;
  settings.soft_deg = soft_deg;
  found.assignment = assign_sides(*found.model, {glm::dvec3(0, 0, 1), {}}, settings, Progress{});
  found.line = parting_line(found.assignment);
  return found;
}

/// Whether a point is on a piece that either half may form, as far as rounding lets it, by barycentric
/// coordinates.
bool on_free_piece(const Assignment& a, const glm::dvec3& p) {
  for (PieceIndex piece = 0; piece < a.mesh.pieces.size(); ++piece) {
    if (a.free[piece] == 0) continue;
    const auto& corners = a.mesh.pieces[piece].corners;
    const glm::dvec3 &o = a.mesh.vertices[corners[0]], u = a.mesh.vertices[corners[1]] - o,
                     v = a.mesh.vertices[corners[2]] - o, w = p - o;
    const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), det = uu * vv - uv * uv;
    if (det <= 0.0) continue;
    const double s = (vv * glm::dot(w, u) - uv * glm::dot(w, v)) / det,
                 t = (uu * glm::dot(w, v) - uv * glm::dot(w, u)) / det;
    if (s < -1e-9 || t < -1e-9 || s + t > 1.0 + 1e-9) continue;
    if (glm::distance(o + s * u + t * v, p) < 1e-9) return true;
  }
  return false;
}

TEST(LineSmoothing, StraightensTheLineOnWavySurface) {
  // Facets of a ring whose edges do not keep to a height, as those of a scan: every other vertex around the
  // tube is shifted along it, so that the surface stays about what it was.
  TriangleMesh ring = test::subdivided(test::torus_mesh(10.0, 2.0, 90, 24), 16000);
  for (std::size_t k = 0; k < ring.vertices.size(); ++k) {
    glm::dvec3& v = ring.vertices[k];
    const glm::dvec3 centre = 10.0 * glm::normalize(glm::dvec3(v.x, v.y, 0.0)), out = v - centre;
    const glm::dvec3 along = glm::cross(glm::normalize(glm::dvec3(-v.y, v.x, 0.0)), out);
    v += 0.02 * std::sin(2.4 * static_cast<double>(k)) * along;
  }
  const glm::dvec3 d(0, 0, 1);
  const Smoothed found = smoothed_line(std::move(ring), 10.0);
  ASSERT_EQ(found.line.euler.loops, 2U);
  std::size_t moved = 0;
  for (const PartingLoop& loop : found.line.loops) {
    ASSERT_EQ(loop.points.size(), loop.vertices.size());
    double length = 0.0, climb = 0.0, length_before = 0.0, climb_before = 0.0;
    for (std::size_t k = 0; k < loop.points.size(); ++k) {
      const std::size_t next = (k + 1) % loop.points.size();
      const glm::dvec3 before = found.assignment.mesh.vertices[loop.vertices[next]] -
                                found.assignment.mesh.vertices[loop.vertices[k]],
                       after = loop.points[next] - loop.points[k];
      length += glm::length(after);
      climb += std::abs(glm::dot(after, d));
      length_before += glm::length(before);
      climb_before += std::abs(glm::dot(before, d));
      if (loop.points[k] == found.assignment.mesh.vertices[loop.vertices[k]]) continue;
      ++moved;
      EXPECT_TRUE(on_free_piece(found.assignment, loop.points[k])) << k;
    }
    EXPECT_NEAR(loop.length, length, 1e-9 * length);
    EXPECT_NEAR(loop.up_and_down, climb, 1e-9 * length);
    EXPECT_NEAR(loop.smoothed_length, length_before - length, 1e-9 * length);
    EXPECT_NEAR(loop.smoothed_climb, climb_before - climb, 1e-9 * length);
    if (loop.moved == 0) continue;
    EXPECT_LT(length + 3.0 * climb, length_before + 3.0 * climb_before);
  }
  EXPECT_GT(moved, 100U);
  double left = 0.0;
  for (const PartingLoop& loop : found.line.loops) left += loop.up_and_down;
  EXPECT_GT(found.line.smoothed_climb, left) << "more than half of it";
  EXPECT_NE(parting_verdict(found.assignment, found.line, *found.model).find("Smoothing made"),
            std::string::npos);
}

TEST(LineSmoothing, LeavesTheLineOnCreases) {
  for (const TriangleMesh& mesh : {test::box_mesh({0, 0, 0}, {4, 3, 2}), test::plate_with_holes(1, 2, 2.0)}) {
    const Smoothed found = smoothed_line(mesh, 2.0);
    for (const PartingLoop& loop : found.line.loops) {
      EXPECT_EQ(loop.moved, 0U);
      for (std::size_t k = 0; k < loop.points.size(); ++k)
        EXPECT_EQ(loop.points[k], found.assignment.mesh.vertices[loop.vertices[k]]);
    }
    EXPECT_EQ(found.line.smoothed_length, 0.0);
    EXPECT_EQ(parting_verdict(found.assignment, found.line, *found.model).find("Smoothing"),
              std::string::npos);
  }
}

TEST(LineSmoothing, ThousandsOfPiecesAroundOneEdgeTakeLittleMemory) {
  const bool sanitized = test::built_with_sanitizers();  // they take time and memory of their own
  const int blades = sanitized ? 500 : 2000;
  TriangleMesh mesh{.vertices = {{0, 0, 0}, {0, 0, 1}}, .facets = {}};
  for (int k = 0; k < blades; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / blades;
    mesh.vertices.emplace_back(std::cos(turn), std::sin(turn), 0.3);
    mesh.facets.push_back({0, 1, static_cast<VertexIndex>(mesh.vertices.size() - 1)});
  }
  const auto peak_mib = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
  };
  const auto before = peak_mib();
  // With the usual effort they are sampled, and no line is sought.
  const Smoothed found = smoothed_line(std::move(mesh), 1.0, 1000.0);
  EXPECT_FALSE(found.line.loops.empty());
  EXPECT_LT(sanitized ? 0 : peak_mib() - before, 30);
}

}  // namespace
}  // namespace moldlight
