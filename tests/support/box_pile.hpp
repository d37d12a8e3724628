// Random solids of known region areas: unions of axis-parallel boxes with some carved out, on a grid with
// planes at random places.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "mold/region.hpp"
#include "support/convex_shadows.hpp"

namespace moldlight::test {

struct BoxPile {
  std::array<std::vector<double>, 3> planes;  // of each axis, rising; one more than cells
  std::vector<char> filled;                   // cell (i, j, k) at (i * cells of y + j) * cells of z + k

  [[nodiscard]] int cells(int axis) const {
    return static_cast<int>(planes[static_cast<std::size_t>(axis)].size()) - 1;
  }
  [[nodiscard]] double plane(int axis, int number) const {
    return planes[static_cast<std::size_t>(axis)][static_cast<std::size_t>(number)];
  }
  /// False outside the grid.
  [[nodiscard]] bool is_filled(const std::array<int, 3>& cell) const;
  [[nodiscard]] double smallest_gap() const;  // between neighbouring planes
};

/// Depends on the seed only. Some 15 units long; planes are 0.25 to 4 units apart. `edges_touch`: pieces of
/// it may touch along an edge, where four facets meet then; else cells are filled until none do.
[[nodiscard]] BoxPile random_pile(std::uint32_t seed, bool edges_touch = false);

/// The same with so many cells of size 1 along each axis.
[[nodiscard]] BoxPile voxel_pile(int cells, std::uint32_t seed);

/// Its surface, closed and outward: the faces between filled and empty cells, each cut along a random
/// diagonal, and some of the vertices in planes and along straight edges taken out again.
[[nodiscard]] TriangleMesh pile_mesh(const BoxPile& pile, std::uint32_t seed);

/// Faces between filled and empty cells, and bodies that fill the same cells.
[[nodiscard]] std::vector<PlanarFace> pile_faces(const BoxPile& pile);
[[nodiscard]] std::vector<ConvexBody> pile_bodies(const BoxPile& pile);

/// A lateral tolerance (a random share of the gaps, 0.1 to 4 times the smallest) by which no plane is shifted
/// to within a hundredth of the smallest gap of another.
[[nodiscard]] double clear_lateral_tolerance(const BoxPile& pile, std::uint32_t seed);

/// Region areas along +axis or -axis, by what is filled in the column of cells through each face or, for a
/// wall, in the column `lateral` in front of it.
[[nodiscard]] RegionValues column_areas(const BoxPile& pile, int axis, bool along_plus, double lateral);

}  // namespace moldlight::test
