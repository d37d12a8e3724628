#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mesh/symmetric_eigen.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "sweep/candidates/candidate_sources.hpp"
#include "sweep/candidates/find_candidates.hpp"

namespace moldlight {
namespace {

using test::Shape;

std::vector<Candidate> candidates_of(const TriangleMesh& mesh, const CandidateOptions& options) {
  return find_candidates(*test::model_of(mesh), options, Progress());
}

double nearest_deg(const std::vector<Candidate>& candidates, const glm::dvec3& direction) {
  double nearest = 90.0;
  for (const Candidate& candidate : candidates) {
    nearest = std::min(nearest, line_angle_deg(candidate.direction, direction));
  }
  return nearest;
}

bool has_source(const Candidate& candidate, CandidateKind kind) {
  return std::any_of(candidate.sources.begin(), candidate.sources.end(),
                     [&](const CandidateSource& source) { return source.kind == kind; });
}

Shape tilted(const Shape& shape) {
  return test::turned(test::refined(shape, 600), test::random_rotation(42));
}

/// The shape's direction is found by this source alone, however the part lies.
void expect_found_by(CandidateKind kind, const Shape& upright) {
  const Shape shape = tilted(upright);
  const auto candidates = candidates_of(shape.mesh, {.kinds = {kind}});
  EXPECT_LT(nearest_deg(candidates, shape.direction), 0.01) << shape.name << ' ' << candidate_kind_name(kind);
  for (const Candidate& candidate : candidates) {
    EXPECT_TRUE(has_source(candidate, kind));
    EXPECT_NEAR(glm::length(candidate.direction), 1.0, 1e-12);
    EXPECT_EQ(candidate.direction, half_sphere(candidate.direction));
  }
}

TEST(HalfSphere, TakesOneOfEachPair) {
  EXPECT_EQ(half_sphere({0.6, 0, -0.8}), glm::dvec3(-0.6, 0, 0.8));
  EXPECT_EQ(half_sphere({0.6, -0.8, 1e-17}), glm::dvec3(-0.6, 0.8, -1e-17));
  EXPECT_EQ(half_sphere({-1, 0, 0}), glm::dvec3(1, 0, 0));
  EXPECT_FALSE(std::signbit(half_sphere({0, 0, -1}).x));
}

TEST(LineAngle, IsExactForSmallAnglesAndBlindToSense) {
  EXPECT_NEAR(line_angle_deg({0, 0, 1}, glm::normalize(glm::dvec3(1e-9, 0, -1))), 5.729577951e-8, 1e-16);
  EXPECT_DOUBLE_EQ(line_angle_deg({0, 0, 1}, {1, 0, 0}), 90.0);
}

TEST(SymmetricEigen, SolvesAKnownMatrix) {
  const glm::dvec3 a = glm::normalize(glm::dvec3(1, 2, -2)), b = glm::normalize(glm::dvec3(2, 1, 2)),
                   c = glm::cross(a, b);
  const SymmetricEigen<3> eigen = symmetric_eigen<3>(
      5.0 * glm::outerProduct(a, a) - 1.0 * glm::outerProduct(b, b) + 3.0 * glm::outerProduct(c, c));
  EXPECT_NEAR(eigen.values[0], -1.0, 1e-13);
  EXPECT_NEAR(eigen.values[1], 3.0, 1e-13);
  EXPECT_NEAR(eigen.values[2], 5.0, 1e-13);
  EXPECT_NEAR(std::abs(glm::dot(eigen.vectors[0], b)), 1.0, 1e-14);
  EXPECT_NEAR(std::abs(glm::dot(eigen.vectors[2], a)), 1.0, 1e-14);
}

TEST(Candidates, PlanesGiveTheDirection) {
  expect_found_by(CandidateKind::plane, test::box_shape({}));
  expect_found_by(CandidateKind::plane, test::t_slot({}));
}

TEST(Candidates, WallsGiveTheDirection) {
  expect_found_by(CandidateKind::perpendicular, test::box_shape({}));
  expect_found_by(CandidateKind::perpendicular, test::cup_with_side_hole({}));
  expect_found_by(CandidateKind::perpendicular, test::plate_with_through_hole({}));
  expect_found_by(CandidateKind::perpendicular, test::frustum_over_tau({}));  // drafted all round
}

TEST(Candidates, HolesAndConesGiveTheirAxis) {
  expect_found_by(CandidateKind::revolution, test::plate_with_through_hole({}));
  expect_found_by(CandidateKind::revolution, test::spool({}));
  expect_found_by(CandidateKind::revolution, test::frustum_under_tau({}));
  expect_found_by(CandidateKind::revolution, test::frustum_over_tau({.tau_deg = 3.0}));
  expect_found_by(CandidateKind::revolution, test::ring({}));
}

TEST(Candidates, HullAndMomentsGiveTheDirection) {
  expect_found_by(CandidateKind::hull, test::t_bar({}));
  expect_found_by(CandidateKind::hull, test::cup({}));
  expect_found_by(CandidateKind::principal, test::box_shape({}));
}

TEST(Candidates, EqualMomentsGiveNoAxis) {
  const auto candidates = candidates_of(test::hollow_sphere({}).mesh, {.kinds = {CandidateKind::principal}});
  EXPECT_LE(candidates.size(), 1u);  // the facets' own axis at most
}

TEST(Candidates, SourcesThatAgreeAreOneCandidate) {
  const auto candidates = candidates_of(test::box_shape({}).mesh, {});
  std::size_t along_z = 0;
  for (const Candidate& candidate : candidates) {
    if (line_angle_deg(candidate.direction, {0, 0, 1}) > 0.02) continue;
    ++along_z;
    EXPECT_EQ(candidate.direction, glm::dvec3(0, 0, 1));
    for (const CandidateKind kind : {CandidateKind::axis, CandidateKind::plane, CandidateKind::perpendicular,
                                     CandidateKind::hull, CandidateKind::principal}) {
      EXPECT_TRUE(has_source(candidate, kind)) << candidate_kind_name(kind);
    }
  }
  EXPECT_EQ(along_z, 1u);
}

TEST(Candidates, NoTwoAreAlike) {
  const Shape shape = tilted(test::cup_with_side_hole({}));
  const auto candidates = candidates_of(shape.mesh, {});
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      ASSERT_GT(line_angle_deg(candidates[i].direction, candidates[j].direction), 0.02) << i << ' ' << j;
    }
  }
}

TEST(Candidates, UserDirectionsStayAsTheyAre) {
  const glm::dvec3 given(0.1, -0.2, -2.0);
  const auto candidates = candidates_of(test::box_shape({}).mesh, {.user = {given, {0, 0, -1}}});
  EXPECT_EQ(candidates[0].direction, glm::normalize(given));
  EXPECT_EQ(candidates[1].direction, glm::dvec3(0, 0, -1));
  EXPECT_EQ(candidates[1].sources.front().kind, CandidateKind::user);
  EXPECT_TRUE(has_source(candidates[1], CandidateKind::axis));
}

TEST(Candidates, DependOnlyOnThePart) {
  const Shape shape = tilted(test::plate_with_through_hole({}));
  const auto first = candidates_of(shape.mesh, {}), again = candidates_of(shape.mesh, {});
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].direction, again[i].direction);
  const auto permuted = candidates_of(test::permuted(shape.mesh, 5), {});
  EXPECT_LT(nearest_deg(permuted, shape.direction), 0.001);
}

TEST(Candidates, EmptyPartHasAxesAndUniformOnly) {
  const auto candidates = candidates_of(TriangleMesh{}, {.uniform_count = 10});
  EXPECT_EQ(candidates.size(), 13u);
}

TEST(Candidates, FlatPartHasNoHull) {
  TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  flat.facets = {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}};
  EXPECT_TRUE(hull_candidates(flat, 10, Progress()).empty());
}

/// Blades about an axis, with their ends on circles at these heights; on a circle no point is inside.
TriangleMesh wheel_of(VertexIndex points, std::initializer_list<double> heights) {
  TriangleMesh wheel;
  wheel.vertices = {{0, 0, 0.4}, {0, 0, 0.6}};
  for (VertexIndex i = 0; i < points; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / points;
    for (const double height : heights) {
      wheel.facets.push_back({0, 1, static_cast<VertexIndex>(wheel.vertices.size())});
      wheel.vertices.emplace_back(std::cos(angle), std::sin(angle), height);
    }
  }
  return wheel;
}

TEST(Candidates, AHullOfManyPointsInOnePlaneIsFound) {
  const auto found = hull_candidates(wheel_of(10'000, {0.25, 0.75}), 10, Progress());
  ASSERT_FALSE(found.empty());
  EXPECT_LT(line_angle_deg(found.front().direction, {0, 0, 1}), 0.01);
}

TEST(Candidates, AHullOfManyPointsIsGivenUp) {
  const TriangleMesh wheel = wheel_of(60'000, {0.5});  // of a second
  Progress progress;
  progress.cancel();
  EXPECT_THROW(static_cast<void>(hull_candidates(wheel, 10, progress)), Cancelled);
}

TEST(Candidates, CancelEndsTheSearch) {
  const auto model = test::model_of(test::box_shape({}).mesh);
  Progress progress;
  progress.cancel();
  EXPECT_THROW((void)find_candidates(*model, {}, progress), Cancelled);
}

TEST(Fibonacci, CoversTheHalfSphereEvenly) {
  const auto directions = fibonacci_half_sphere(500);
  ASSERT_EQ(directions.size(), 500u);
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& direction : directions) {
    EXPECT_NEAR(glm::length(direction), 1.0, 1e-12);
    EXPECT_GT(direction.z, 0.0);
    sum += direction / 500.0;
  }
  EXPECT_NEAR(sum.z, 0.5, 1e-3);
  EXPECT_NEAR(glm::length(glm::dvec2(sum)), 0.0, 1e-2);
  // No direction is farther from the set than its spacing allows: 4.6 degrees a cell.
  for (const glm::dvec3& probe : fibonacci_half_sphere(3001)) {
    double nearest = 90.0;
    for (const glm::dvec3& direction : directions)
      nearest = std::min(nearest, line_angle_deg(probe, direction));
    EXPECT_LT(nearest, 4.6);
  }
}

TEST(CurvedPatches, AreCylindersAndConesButNotPlanes) {
  const auto patches_of = [](const TriangleMesh& mesh) {
    return curved_patches(facet_geometry(mesh), build_adjacency(mesh));
  };
  EXPECT_TRUE(patches_of(test::cup({}).mesh).empty());
  const auto hole = patches_of(test::plate_with_through_hole({}).mesh);
  ASSERT_EQ(hole.size(), 1u);
  EXPECT_TRUE(hole[0].full_turn);
  const auto cone = patches_of(test::frustum_over_tau({.tau_deg = 3.0}).mesh);
  EXPECT_EQ(cone.size(), 1u);
}

TEST(FindCandidates, EndsBetweenSourcesWhenCancelled) {
  const auto model = test::model_of(test::cup({}).mesh);
  int reports = 0;
  Progress* cancelled = nullptr;
  Progress progress([&](std::string_view, double) {
    if (++reports == 3) cancelled->cancel();
  });
  cancelled = &progress;
  EXPECT_THROW(static_cast<void>(find_candidates(*model, {}, progress)), Cancelled);
  EXPECT_EQ(reports, 3);
  EXPECT_THROW(static_cast<void>(find_candidates(*model, {}, Progress(&progress))), Cancelled);
  EXPECT_EQ(reports, 3) << "it informs nobody";
}

}  // namespace
}  // namespace moldlight
