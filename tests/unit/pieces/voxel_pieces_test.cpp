// Solids of 32 cubed cells: the number of directions against all subsets of 26, and what the pieces leave
// against steps from cell to cell, which share nothing with the program.
#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "pieces/find_pieces.hpp"
#include "support/box_pile.hpp"
#include "support/classify_mesh.hpp"
#include "support/random.hpp"

namespace moldlight {
namespace {

constexpr int k_cells = 32;
constexpr std::size_t k_points = 2000, k_air_points = 20'000;
constexpr double k_eps = 0.005;

std::vector<glm::dvec3> steps_26() {
  std::vector<glm::dvec3> steps;
  for (int k = 0; k < 27; ++k)
    if (k != 13) steps.emplace_back(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
  return steps;
}

bool is_filled(const test::BoxPile& pile, const glm::dvec3& at) {
  const glm::dvec3 cell = glm::floor(at);
  return pile.is_filled({static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z)});
}

/// Whether a point in the air leaves the grid along the direction through empty cells alone.
bool leaves(const test::BoxPile& pile, glm::dvec3 at, const glm::dvec3& direction) {
  const auto within = [](double x) { return x >= 0.0 && x < k_cells; };
  while (within(at.x) && within(at.y) && within(at.z)) {
    if (is_filled(pile, at)) return false;
    double step = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0.0) continue;
      const double next = direction[axis] > 0.0 ? std::floor(at[axis]) + 1.0 : std::floor(at[axis]);
      step = std::min(step, (next - at[axis]) / direction[axis]);
    }
    at += (std::max(step, 0.0) + 1e-9) * direction;
  }
  return true;
}

/// Random points just in front of the surface.
std::vector<glm::dvec3> surface_points(const test::BoxPile& pile, test::Random& random) {
  std::vector<glm::dvec3> points;
  while (points.size() < k_points) {
    glm::dvec3 at(random.between(0.0, k_cells), random.between(0.0, k_cells), random.between(0.0, k_cells));
    const int axis = static_cast<int>(random.below(3));
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    if (!is_filled(pile, at)) continue;
    at[axis] = std::floor(at[axis]) + (side > 0.0 ? 1.0 + 1e-3 : -1e-3);
    if (!is_filled(pile, at)) points.push_back(at);
  }
  return points;
}

using Reached = std::bitset<k_points>;

/// Points that directions leave, of as many of them as may be added: the fewest.
std::size_t fewest_left(const std::vector<Reached>& reached, std::size_t from, std::size_t more,
                        const Reached& so_far) {
  if (more == 0) return k_points - so_far.count();
  std::size_t fewest = k_points;
  for (std::size_t k = from; k < reached.size(); ++k)
    fewest = std::min(fewest, fewest_left(reached, k + 1, more - 1, so_far | reached[k]));
  return fewest;
}

TEST(VoxelPieces, NeedNoMoreThanTheBestSubsetOf26Directions) {
  std::size_t compared = 0;
  for (const std::uint32_t seed : {1U, 2U, 5U, 6U, 8U, 9U}) {
    const test::BoxPile pile = test::voxel_pile(k_cells, seed);
    test::Random random(seed);
    const std::vector<glm::dvec3> steps = steps_26();
    const std::vector<glm::dvec3> points = surface_points(pile, random);
    std::vector<Reached> reached(steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k)
      for (std::size_t point = 0; point < points.size(); ++point)
        reached[k][point] = leaves(pile, points[point], steps[k]);
    std::array<std::size_t, 5> left{};
    for (std::size_t most = 1; most < left.size(); ++most) left[most] = fewest_left(reached, 0, most, {});
    PiecesSettings settings;
    settings.proposed = steps;
    const auto model = test::model_of(test::pile_mesh(pile, seed));
    const PiecesResult result = find_pieces(*model, {}, settings, Progress());
    // Three standard deviations of the share of points.
    const double spread = 3.0 * std::sqrt(k_points * k_eps);
    for (std::size_t most = 2; most < left.size(); ++most) {
      if (static_cast<double>(left[most]) > k_eps * k_points - spread) continue;
      EXPECT_TRUE(result.releases_all) << "seed " << seed;
      EXPECT_LE(result.count(), most) << "seed " << seed;
      EXPECT_LE(result.lower_bound, most) << "seed " << seed;
      ++compared;
      break;
    }
    // It leaves what the cells say, whatever its directions.
    Reached all;
    for (const PieceDirection& one : result.directions)
      for (std::size_t point = 0; point < points.size(); ++point)
        if (leaves(pile, points[point], one.direction)) all.set(point);
    const double share = static_cast<double>(k_points - all.count()) / k_points;
    const double exact = result.left_area / model->geometry.total_area;
    EXPECT_NEAR(share, exact, 0.004 + 4.0 * std::sqrt(exact / k_points)) << "seed " << seed;
    // What stays of the air when one piece after the other is removed.
    ASSERT_TRUE(result.enclosed_air);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < k_air_points; ++k) {
      const glm::dvec3 at(random.between(0.0, k_cells), random.between(0.0, k_cells),
                          random.between(0.0, k_cells));
      if (is_filled(pile, at)) continue;
      kept += std::ranges::none_of(
          result.directions, [&](const PieceDirection& one) { return leaves(pile, at, one.direction); });
    }
    const double volume = std::pow(k_cells, 3.0), air = static_cast<double>(kept) / k_air_points;
    EXPECT_NEAR(air, *result.enclosed_air / volume,
                1e-4 + 2.0 * result.enclosed_error / volume + 4.0 * std::sqrt(air / k_air_points))
        << "seed " << seed;
  }
  EXPECT_GE(compared, 3U);
}

}  // namespace
}  // namespace moldlight
