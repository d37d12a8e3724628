#include "mesh/adjacency.hpp"

#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "mesh/weld.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

/// What the contract says, word for word and slowly.
Adjacency expected_adjacency(const TriangleMesh& mesh) {
  struct Use {
    FacetIndex facet;
    std::size_t edge;
    bool upward;
  };
  std::map<std::pair<VertexIndex, VertexIndex>, std::vector<Use>> edges;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const auto& corners = mesh.facets[facet];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const VertexIndex a = corners[edge], b = corners[(edge + 1) % 3];
      edges[std::minmax(a, b)].push_back({facet, edge, a < b});
    }
  }
  Adjacency adjacency;
  adjacency.across.assign(mesh.facets.size(), {k_no_facet, k_no_facet, k_no_facet});
  for (const auto& [vertices, uses] : edges) {
    if (uses.size() != 2 || uses[0].upward == uses[1].upward) continue;
    adjacency.across[uses[0].facet][uses[0].edge] = uses[1].facet;
    adjacency.across[uses[1].facet][uses[1].edge] = uses[0].facet;
  }
  return adjacency;
}

std::size_t cut_edges(const Adjacency& adjacency) {
  std::size_t count = 0;
  for (const auto& across : adjacency.across) {
    count += static_cast<std::size_t>(std::count(across.begin(), across.end(), k_no_facet));
  }
  return count;
}

TEST(Adjacency, EveryEdgeOfABoxJoins) {
  const TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 2, 3});
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_EQ(cut_edges(adjacency), 0u);
  EXPECT_EQ(adjacency.across, expected_adjacency(mesh).across);
}

TEST(Adjacency, BoxesThatShareAnEdgeAreCutThere) {
  const TriangleMesh mesh =
      weld_vertices(test::joined(test::box_mesh({0, 0, 0}, {1, 1, 1}), test::box_mesh({1, 1, 0}, {2, 2, 1})));
  EXPECT_EQ(mesh.vertices.size(), 14u);
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_EQ(cut_edges(adjacency), 4u);
  EXPECT_EQ(adjacency.across, expected_adjacency(mesh).across);
}

TEST(Adjacency, BoxesThatShareAVertexJoinAllTheirEdges) {
  const TriangleMesh mesh =
      weld_vertices(test::joined(test::box_mesh({0, 0, 0}, {1, 1, 1}), test::box_mesh({1, 1, 1}, {2, 2, 2})));
  EXPECT_EQ(mesh.vertices.size(), 15u);
  EXPECT_EQ(cut_edges(build_adjacency(mesh)), 0u);
}

TEST(Adjacency, DuplicateFacetCutsItsThreeEdges) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.facets.push_back(mesh.facets[4]);
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_EQ(cut_edges(adjacency), 9u);
  EXPECT_EQ(adjacency.across, expected_adjacency(mesh).across);
}

TEST(Adjacency, FlippedFacetIsCutLoose) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  test::reverse_facet(mesh, 5);
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_EQ(cut_edges(adjacency), 6u);
  EXPECT_EQ(adjacency.across[5], (std::array<FacetIndex, 3>{k_no_facet, k_no_facet, k_no_facet}));
  EXPECT_EQ(adjacency.across, expected_adjacency(mesh).across);
}

TEST(Adjacency, DegenerateFacetHasNoNeighbours) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.facets.insert(mesh.facets.begin() + 3, {mesh.facets[0][0], mesh.facets[0][1], mesh.facets[0][0]});
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_EQ(cut_edges(adjacency), 3u);
  EXPECT_EQ(adjacency.across, expected_adjacency(mesh).across);
}

TEST(Adjacency, OpenShellHasABorder) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.facets.resize(10);
  EXPECT_EQ(cut_edges(build_adjacency(mesh)), 4u);
}

TEST(Adjacency, TwoSidedTriangleJoinsItself) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.facets = {{0, 1, 2}, {0, 2, 1}};
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_EQ(adjacency.across[0], (std::array<FacetIndex, 3>{1, 1, 1}));
  EXPECT_EQ(adjacency.across[1], (std::array<FacetIndex, 3>{0, 0, 0}));
}

TEST(Adjacency, NoFacetsNoAdjacency) { EXPECT_TRUE(build_adjacency(TriangleMesh{}).across.empty()); }

/// Triangles over few vertices at random: every kind of bad edge, many a facet.
TEST(Adjacency, HoldsForRandomTriangleSoups) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    TriangleMesh mesh;
    const auto vertex_count = static_cast<VertexIndex>(4 + round % 40);
    for (VertexIndex vertex = 0; vertex < vertex_count; ++vertex)
      mesh.vertices.emplace_back(vertex, vertex % 7, vertex % 3);
    std::uniform_int_distribution<VertexIndex> any_vertex(0, vertex_count - 1);
    for (int facet = 0; facet < 5 + 2 * round; ++facet) {
      mesh.facets.push_back({any_vertex(random), any_vertex(random), any_vertex(random)});
    }
    ASSERT_EQ(build_adjacency(mesh).across, expected_adjacency(mesh).across) << "round " << round;
  }
}

/// Boxes of a grid, some facets shuffled, flipped, doubled or dropped: mostly manifold with faults.
TEST(Adjacency, HoldsForDamagedBoxPiles) {
  std::mt19937 random(12);
  std::bernoulli_distribution rarely(0.1), often(0.5);
  for (int round = 0; round < 60; ++round) {
    TriangleMesh pile;
    for (int cell = 0; cell < 27; ++cell) {
      const glm::dvec3 low(cell % 3, cell / 3 % 3, cell / 9);
      if (often(random)) pile = test::joined(pile, test::box_mesh(low, low + 1.0));
    }
    pile = weld_vertices(pile);
    std::shuffle(pile.facets.begin(), pile.facets.end(), random);
    for (FacetIndex facet = 0; facet < pile.facets.size(); ++facet) {
      if (rarely(random)) test::reverse_facet(pile, facet);
    }
    if (!pile.facets.empty()) pile.facets.resize(pile.facets.size() * 9 / 10);
    ASSERT_EQ(build_adjacency(pile).across, expected_adjacency(pile).across) << "round " << round;
  }
}

/// A fan of thousands of facets around one vertex, closed below by another one.
TEST(Adjacency, HoldsAroundVerticesOfThousandsOfFacets) {
  constexpr VertexIndex k_rim = 60'000;
  TriangleMesh mesh{.vertices = std::vector<glm::dvec3>(k_rim + 2), .facets = {}};
  for (VertexIndex k = 0; k < k_rim; ++k) {
    const VertexIndex next = (k + 1) % k_rim;
    mesh.facets.push_back({k, next, k_rim});
    mesh.facets.push_back({next, k, k_rim + 1});
  }
  mesh.facets.push_back({0, 1, k_rim});  // an edge of three facets
  EXPECT_EQ(build_adjacency(mesh).across, expected_adjacency(mesh).across);
}

TEST(Components, AreNumberedByFirstFacet) {
  const TriangleMesh near = test::box_mesh({0, 0, 0}, {1, 1, 1}), far = test::box_mesh({5, 0, 0}, {6, 1, 1});
  const Components components = connected_components(test::joined(near, far));
  EXPECT_EQ(components.count, 2u);
  for (FacetIndex facet = 0; facet < 24; ++facet) EXPECT_EQ(components.of_facet[facet], facet / 12);
}

TEST(Components, SharedEdgeConnectsAndSharedVertexDoesNot) {
  const TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(
      connected_components(weld_vertices(test::joined(box, test::box_mesh({1, 1, 0}, {2, 2, 1})))).count, 1u);
  EXPECT_EQ(
      connected_components(weld_vertices(test::joined(box, test::box_mesh({1, 1, 1}, {2, 2, 2})))).count, 2u);
}

TEST(VoidFacets, AreThoseOfClosedSurfaceThatFacesInwards) {
  TriangleMesh inner = test::box_mesh({1, 1, 1}, {2, 2, 2});
  for (FacetIndex facet = 0; facet < inner.facets.size(); ++facet) test::reverse_facet(inner, facet);
  TriangleMesh mesh = weld_vertices(test::joined(test::box_mesh({0, 0, 0}, {4, 4, 4}), inner));
  std::vector<bool> in_void = void_facets(mesh, build_adjacency(mesh));
  for (FacetIndex facet = 0; facet < 24; ++facet) EXPECT_EQ(in_void[facet], facet >= 12) << facet;
  mesh.facets.pop_back();
  in_void = void_facets(mesh, build_adjacency(mesh));
  EXPECT_EQ(std::ranges::count(in_void, true), 0) << "it has an opening";
}

TEST(Components, CollapsedFacetsBelongToNone) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.facets.push_back({0, 0, 1});
  const Components components = connected_components(mesh);
  EXPECT_EQ(components.count, 1u);
  EXPECT_EQ(components.of_facet[12], k_no_facet);
}

}  // namespace
}  // namespace moldlight
