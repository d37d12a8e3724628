// Faces of meshes against shapes whose faces, edges and loops are known.
#include "mesh/flat_faces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "mesh/edge_collapse.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

/// Each facet becomes four, by the middles of its edges; `bend` moves these at random.
TriangleMesh refined(const TriangleMesh& mesh, double bend) {
  TriangleMesh result;
  result.vertices = mesh.vertices;
  std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> middles;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-bend, bend);
  const auto middle = [&](VertexIndex a, VertexIndex b) {
    const auto [entry, fresh] = middles.try_emplace(std::minmax(a, b), 0);
    if (fresh) {
      entry->second = static_cast<VertexIndex>(result.vertices.size());
      result.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]) +
                                glm::dvec3(any(random), any(random), any(random)));
    }
    return entry->second;
  };
  for (const auto& [a, b, c] : mesh.facets) {
    const VertexIndex ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const std::array<VertexIndex, 3> facet :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
      result.facets.push_back(facet);
  }
  return result;
}

/// A round plate of so many sides with a square hole of side 1 through its middle.
TriangleMesh plate_with_hole(std::uint32_t sides) {
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const double radius : {2.0, 0.5 * std::numbers::sqrt2}) {
      for (std::uint32_t k = 0; k < 4 * sides; ++k) {
        const double turn = 2.0 * std::numbers::pi * k / (4 * sides);
        glm::dvec2 at(radius * std::cos(turn), radius * std::sin(turn));
        // The hole's points are on the square that its corners span.
        if (radius < 1.0) at *= 0.5 / std::max(std::abs(at.x), std::abs(at.y));
        mesh.vertices.emplace_back(at, z);
      }
    }
  }
  const std::uint32_t n = 4 * sides;
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    const auto quad = [&](VertexIndex a, VertexIndex b, VertexIndex c, VertexIndex d) {
      mesh.facets.push_back({a, b, c});
      mesh.facets.push_back({a, c, d});
    };
    quad(k, next, 2 * n + next, 2 * n + k);                  // outside
    quad(n + next, n + k, 3 * n + k, 3 * n + next);          // in the hole
    quad(2 * n + k, 2 * n + next, 3 * n + next, 3 * n + k);  // above
    quad(next, k, n + k, n + next);                          // below
  }
  return mesh;
}

/// Each edge is walked once either way, and each face's loops are as its normal says.
void expect_sound(const FlatFaces& flat, const TriangleMesh& mesh, double tolerance) {
  std::vector<int> ways(flat.edges.size(), 0), uses(flat.edges.size(), 0);
  for (const FlatFaces::Face& face : flat.faces) {
    for (const FlatFaces::Loop& loop : face.loops) {
      ASSERT_GE(loop.size(), 3U);
      glm::dvec3 area(0.0);
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const auto from = [&](const FlatFaces::Use& use) {
          return use.backwards ? flat.edges[use.edge].to : flat.edges[use.edge].from;
        };
        const FlatFaces::Edge& edge = flat.edges[loop[k].edge];
        EXPECT_EQ(loop[k].backwards ? edge.from : edge.to, from(loop[(k + 1) % loop.size()]));
        ways[loop[k].edge] += loop[k].backwards ? -1 : 1;
        ++uses[loop[k].edge];
        area += glm::cross(mesh.vertices[edge.from] - face.point, mesh.vertices[edge.to] - face.point) *
                (loop[k].backwards ? -1.0 : 1.0);
        EXPECT_LE(std::abs(glm::dot(mesh.vertices[edge.from] - face.point, face.normal)), 2.0 * tolerance);
      }
      EXPECT_EQ(glm::dot(area, face.normal) > 0.0, &loop == face.loops.data());
    }
  }
  EXPECT_TRUE(std::ranges::all_of(ways, [](int way) { return way == 0; }));
  EXPECT_TRUE(std::ranges::all_of(uses, [](int count) { return count == 2; }));
}

TEST(FlatFaces, OfABoxAreSix) {
  const TriangleMesh box = test::box_mesh({0, 0, 0}, {3, 2, 1});
  for (const TriangleMesh& mesh : {box, refined(refined(box, 0.0), 0.0)}) {
    const FlatFaces flat = flat_faces(mesh, 1e-9);
    EXPECT_EQ(flat.faces.size(), 6U);
    EXPECT_EQ(flat.edges.size(), 12U);
    ASSERT_EQ(flat.shells.size(), 1U);
    EXPECT_NEAR(flat.shells[0].volume, 6.0, 1e-12);
    expect_sound(flat, mesh, 1e-9);
  }
}

TEST(FlatFaces, AreBentByTheToleranceAtMost) {
  const TriangleMesh mesh = refined(refined(test::box_mesh({0, 0, 0}, {3, 2, 1}), 1e-6), 1e-6);
  const FlatFaces flat = flat_faces(mesh, 1e-5);
  EXPECT_EQ(flat.faces.size(), 6U);
  EXPECT_EQ(flat.edges.size(), 12U);
  expect_sound(flat, mesh, 1e-5);
  EXPECT_GT(flat_faces(mesh, 1e-8).faces.size(), 24U);
}

TEST(FlatFaces, HaveHolesAsLoops) {
  const TriangleMesh mesh = plate_with_hole(6);
  const FlatFaces flat = flat_faces(mesh, 1e-9);
  // Twenty-four around, four in the hole, above and below.
  EXPECT_EQ(flat.faces.size(), 30U);
  EXPECT_EQ(std::ranges::count(flat.faces, 2U, [](const auto& face) { return face.loops.size(); }), 2);
  EXPECT_EQ(flat.edges.size(), 3U * 24U + 3U * 4U);
  expect_sound(flat, mesh, 1e-9);
}

TEST(FlatFaces, OfAVoidHaveAShellOfTheirOwn) {
  TriangleMesh inner = test::box_mesh({1, 1, 1}, {2, 2, 2});
  for (FacetIndex facet = 0; facet < inner.facets.size(); ++facet) test::reverse_facet(inner, facet);
  const TriangleMesh mesh = test::joined(test::box_mesh({0, 0, 0}, {3, 3, 3}), inner);
  const FlatFaces flat = flat_faces(mesh, 1e-9);
  ASSERT_EQ(flat.shells.size(), 2U);
  EXPECT_NEAR(flat.shells[0].volume, 27.0, 1e-12);
  EXPECT_NEAR(flat.shells[1].volume, -1.0, 1e-12);
  EXPECT_EQ(flat.faces.size(), 12U);
  expect_sound(flat, mesh, 1e-9);
}

TEST(FlatFaces, TakeNeedlesWithTheFaceAtTheirLongestEdge) {
  // A box whose upper face has a corner in its middle edge, moved aside by less than the tolerance.
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {2, 2, 1});
  const FlatFaces before = flat_faces(mesh, 1e-9);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    for (FacetIndex other = facet + 1; other < mesh.facets.size(); ++other) {
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexIndex a = mesh.facets[facet][k], b = mesh.facets[facet][(k + 1) % 3];
        const auto& across = mesh.facets[other];
        for (std::size_t j = 0; j < 3; ++j) {
          if (across[j] != b || across[(j + 1) % 3] != a) continue;
          // The edge's middle is of a third facet between the two, without a width.
          const auto fresh = static_cast<VertexIndex>(mesh.vertices.size());
          mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
          const VertexIndex apex = mesh.facets[facet][(k + 2) % 3];
          mesh.facets[facet] = {a, fresh, apex};
          mesh.facets.push_back({fresh, b, apex});
          mesh.facets.push_back({b, fresh, a});
          const FlatFaces flat = flat_faces(mesh, 1e-9);
          EXPECT_EQ(flat.faces.size(), before.faces.size());
          EXPECT_EQ(flat.edges.size(), before.edges.size());
          expect_sound(flat, mesh, 1e-9);
          return;
        }
      }
    }
  }
}

TEST(CollapseShortEdges, LeavesAClosedMeshWithoutThem) {
  TriangleMesh mesh = refined(test::box_mesh({0, 0, 0}, {3, 2, 1}), 0.0);
  const auto [a, b, c] = mesh.facets.front();
  // Three facets for one, the point of two of them beside a corner.
  const auto fresh = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.push_back(mesh.vertices[a] +
                          1e-7 * (0.5 * (mesh.vertices[b] + mesh.vertices[c]) - mesh.vertices[a]));
  mesh.facets.front() = {a, b, fresh};
  mesh.facets.push_back({b, c, fresh});
  mesh.facets.push_back({c, a, fresh});
  TriangleMesh kept = mesh;
  collapse_short_edges(kept, 1e-9);
  EXPECT_EQ(kept.facets, mesh.facets);
  collapse_short_edges(mesh, 1e-5);
  EXPECT_EQ(mesh.facets.size(), 48U);
  const FlatFaces flat = flat_faces(mesh, 1e-9);
  EXPECT_EQ(flat.faces.size(), 6U);
  EXPECT_NEAR(flat.shells.front().volume, 6.0, 1e-6);
  expect_sound(flat, mesh, 1e-6);
}

TEST(CollapseShortEdges, KeepsWhatWouldTouchItself) {
  // A thin plate: both its sides share the corners of its rim.
  TriangleMesh plate = test::box_mesh({0, 0, 0}, {1, 1, 1e-7});
  collapse_short_edges(plate, 1e-5);
  EXPECT_GE(plate.facets.size(), 4U);
  EXPECT_EQ(flat_faces(plate, 1e-9).shells.size(), 1U);
}

TEST(FlatFaces, OfASurfaceHaveARim) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.facets = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  const FlatFaces flat = flat_faces(mesh, 1e-9);
  EXPECT_EQ(flat.faces.size(), 2U);
  EXPECT_EQ(flat.edges.size(), 6U);
  EXPECT_EQ(flat.shells.size(), 1U);
}

}  // namespace
}  // namespace moldlight
