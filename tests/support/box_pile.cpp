#include "support/box_pile.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "support/random.hpp"

namespace moldlight::test {
namespace {

using Cell = std::array<int, 3>;

char& cell_of(BoxPile& pile, const Cell& cell) {
  return pile.filled[static_cast<std::size_t>((cell[0] * pile.cells(1) + cell[1]) * pile.cells(2) + cell[2])];
}

template <typename Visit>
void for_each_cell(const BoxPile& pile, Visit&& visit) {
  for (int i = 0; i < pile.cells(0); ++i) {
    for (int j = 0; j < pile.cells(1); ++j) {
      for (int k = 0; k < pile.cells(2); ++k) visit(Cell{i, j, k});
    }
  }
}

void set_random_box(BoxPile& pile, Random& random, char value) {
  Cell low{}, high{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto cells = static_cast<std::size_t>(pile.cells(axis));
    const std::size_t a = random.below(cells), b = random.below(cells);
    low[static_cast<std::size_t>(axis)] = static_cast<int>(std::min(a, b));
    high[static_cast<std::size_t>(axis)] = static_cast<int>(std::max(a, b));
  }
  for (int i = low[0]; i <= high[0]; ++i) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int k = low[2]; k <= high[2]; ++k) cell_of(pile, {i, j, k}) = value;
    }
  }
}

/// Fills a cell beside each edge where filled cells touch across it; true if there was one.
bool fill_touching_edges(BoxPile& pile) {
  bool found = false;
  for_each_cell(pile, [&](const Cell& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (const int step : {-1, 1}) {
        Cell beside = cell, above = cell, across = cell;
        ++beside[u];
        above[v] += step;
        ++across[u];
        across[v] += step;
        if (pile.is_filled(cell) && pile.is_filled(across) && !pile.is_filled(beside) &&
            !pile.is_filled(above)) {
          cell_of(pile, beside) = 1;
          found = true;
        }
      }
    }
  });
  return found;
}

/// A face between a filled cell and an empty one.
struct CellFace {
  Cell cell;  // the filled one
  std::size_t axis;
  int side;  // -1, 1
  [[nodiscard]] int plane() const { return cell[axis] + (side > 0 ? 1 : 0); }
  /// Grid points of its corners, counter-clockwise seen from outside.
  [[nodiscard]] std::array<Cell, 4> corners() const {
    std::array<Cell, 4> result{};
    for (int corner = 0; corner < 4; ++corner) {
      Cell point = cell;
      point[axis] = plane();
      point[(axis + 1) % 3] += corner == 1 || corner == 2 ? 1 : 0;
      point[(axis + 2) % 3] += corner >= 2 ? 1 : 0;
      result[static_cast<std::size_t>(side > 0 ? corner : 3 - corner)] = point;
    }
    return result;
  }
};

template <typename Visit>
void for_each_face(const BoxPile& pile, Visit&& visit) {
  for_each_cell(pile, [&](const Cell& cell) {
    if (!pile.is_filled(cell)) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Cell next = cell;
        next[axis] += side;
        if (!pile.is_filled(next)) visit(CellFace{cell, axis, side});
      }
    }
  });
}

glm::dvec3 point_at(const BoxPile& pile, const Cell& point) {
  return {pile.plane(0, point[0]), pile.plane(1, point[1]), pile.plane(2, point[2])};
}

/// Takes vertices out of a mesh of axis-parallel facets where the surface stays the same: a vertex moves to a
/// neighbour.
class VertexRemoval {
 public:
  explicit VertexRemoval(TriangleMesh& mesh) : mesh_(mesh), facets_of_(mesh.vertices.size()) {
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      for (const VertexIndex vertex : mesh.facets[facet]) facets_of_[vertex].insert(facet);
    }
  }

  void try_removing(VertexIndex vertex, Random& random) {
    std::vector<VertexIndex> around;
    for (const VertexIndex neighbour : neighbours(vertex)) around.push_back(neighbour);
    if (around.size() != facets_of_[vertex].size()) return;  // surfaces touch in it
    random.shuffle(around);
    for (const VertexIndex target : around) {
      if (can_move(vertex, target)) return move(vertex, target);
    }
  }

  /// Drops the facets that are gone.
  void finish() {
    std::erase_if(mesh_.facets, [](const auto& facet) { return facet[0] == facet[1]; });
  }

 private:
  [[nodiscard]] std::set<VertexIndex> neighbours(VertexIndex vertex) const {
    std::set<VertexIndex> result;
    for (const FacetIndex facet : facets_of_[vertex]) {
      result.insert(mesh_.facets[facet].begin(), mesh_.facets[facet].end());
    }
    result.erase(vertex);
    return result;
  }

  [[nodiscard]] glm::dvec3 cross_of(const std::array<VertexIndex, 3>& facet) const {
    const glm::dvec3& a = mesh_.vertices[facet[0]];
    return glm::cross(mesh_.vertices[facet[1]] - a, mesh_.vertices[facet[2]] - a);
  }

  [[nodiscard]] bool can_move(VertexIndex vertex, VertexIndex target) const {
    const std::set<VertexIndex> a = neighbours(vertex), b = neighbours(target);
    if (std::count_if(a.begin(), a.end(), [&](VertexIndex v) { return b.contains(v); }) != 2) return false;
    for (const FacetIndex facet : facets_of_[vertex]) {
      std::array<VertexIndex, 3> moved = mesh_.facets[facet];
      if (std::find(moved.begin(), moved.end(), target) != moved.end()) continue;
      const glm::dvec3 before = cross_of(moved);
      std::replace(moved.begin(), moved.end(), vertex, target);
      const glm::dvec3 after = cross_of(moved);
      // Axis-parallel facets: the other two components are exactly 0.
      for (int axis = 0; axis < 3; ++axis) {
        if ((before[axis] == 0.0) != (after[axis] == 0.0) || before[axis] * after[axis] < 0.0) return false;
      }
      double longest = 0.0;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        longest = std::max(
            longest, glm::distance(mesh_.vertices[moved[corner]], mesh_.vertices[moved[(corner + 1) % 3]]));
      }
      if (glm::length(after) < k_least_height * longest * longest) return false;
    }
    return true;
  }

  void move(VertexIndex vertex, VertexIndex target) {
    for (const FacetIndex facet : facets_of_[vertex]) {
      auto& corners = mesh_.facets[facet];
      if (std::find(corners.begin(), corners.end(), target) != corners.end()) {
        for (const VertexIndex corner : corners) {
          if (corner != vertex) facets_of_[corner].erase(facet);
        }
        corners = {0, 0, 0};
      } else {
        std::replace(corners.begin(), corners.end(), vertex, target);
        facets_of_[target].insert(facet);
      }
    }
    facets_of_[vertex].clear();
  }

  static constexpr double k_least_height = 0.01;  // over the longest side: no needles
  TriangleMesh& mesh_;
  std::vector<std::set<FacetIndex>> facets_of_;
};

TriangleMesh used_vertices_only(const TriangleMesh& mesh) {
  TriangleMesh result;
  std::map<VertexIndex, VertexIndex> number;
  for (auto facet : mesh.facets) {
    for (VertexIndex& vertex : facet) {
      const auto [place, is_new] = number.emplace(vertex, static_cast<VertexIndex>(result.vertices.size()));
      if (is_new) result.vertices.push_back(mesh.vertices[vertex]);
      vertex = place->second;
    }
    result.facets.push_back(facet);
  }
  return result;
}

}  // namespace

bool BoxPile::is_filled(const std::array<int, 3>& cell) const {
  for (int axis = 0; axis < 3; ++axis) {
    const int number = cell[static_cast<std::size_t>(axis)];
    if (number < 0 || number >= cells(axis)) return false;
  }
  return filled[static_cast<std::size_t>((cell[0] * cells(1) + cell[1]) * cells(2) + cell[2])] != 0;
}

double BoxPile::smallest_gap() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& along : planes) {
    for (std::size_t i = 0; i + 1 < along.size(); ++i) smallest = std::min(smallest, along[i + 1] - along[i]);
  }
  return smallest;
}

static void fill_randomly(BoxPile& pile, Random& random, bool edges_touch) {
  pile.filled.assign(static_cast<std::size_t>(pile.cells(0) * pile.cells(1) * pile.cells(2)), 0);
  const std::size_t boxes = 2 + random.below(5), carved = random.below(4);
  for (std::size_t i = 0; i < boxes; ++i) set_random_box(pile, random, 1);
  for (std::size_t i = 0; i < carved; ++i) set_random_box(pile, random, 0);
  if (std::count(pile.filled.begin(), pile.filled.end(), 1) == 0) set_random_box(pile, random, 1);
  while (!edges_touch && fill_touching_edges(pile)) {
  }
}

BoxPile random_pile(std::uint32_t seed, bool edges_touch) {
  Random random(seed);
  BoxPile pile;
  for (auto& along : pile.planes) {
    along.push_back(random.between(-3.0, 3.0));
    const std::size_t cells = 2 + random.below(5);
    for (std::size_t i = 0; i < cells; ++i) {
      along.push_back(along.back() + 0.25 * std::pow(16.0, random.between(0.0, 1.0)));
    }
  }
  fill_randomly(pile, random, edges_touch);
  return pile;
}

BoxPile voxel_pile(int cells, std::uint32_t seed) {
  Random random(seed);
  BoxPile pile;
  for (auto& along : pile.planes) {
    for (int plane = 0; plane <= cells; ++plane) along.push_back(plane);
  }
  fill_randomly(pile, random, false);
  return pile;
}

TriangleMesh pile_mesh(const BoxPile& pile, std::uint32_t seed) {
  Random random(seed);
  TriangleMesh mesh;
  std::map<Cell, VertexIndex> numbers;
  for_each_face(pile, [&](const CellFace& face) {
    std::array<VertexIndex, 4> quad{};
    const std::array<Cell, 4> corners = face.corners();
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const auto [place, is_new] =
          numbers.emplace(corners[corner], static_cast<VertexIndex>(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(point_at(pile, corners[corner]));
      quad[corner] = place->second;
    }
    const std::size_t first = random.below(2);
    mesh.facets.push_back({quad[first], quad[first + 1], quad[first + 2]});
    mesh.facets.push_back({quad[first], quad[first + 2], quad[(first + 3) % 4]});
  });
  const double share = random.between(0.0, 1.0);
  VertexRemoval removal(mesh);
  for (VertexIndex vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    if (random.chance(share)) removal.try_removing(vertex, random);
  }
  removal.finish();
  return used_vertices_only(mesh);
}

std::vector<PlanarFace> pile_faces(const BoxPile& pile) {
  std::vector<PlanarFace> faces;
  for_each_face(pile, [&](const CellFace& face) {
    PlanarFace planar;
    for (const Cell& corner : face.corners()) planar.corners.push_back(point_at(pile, corner));
    planar.normal = glm::dvec3(0.0);
    planar.normal[static_cast<int>(face.axis)] = face.side;
    faces.push_back(planar);
  });
  return faces;
}

std::vector<ConvexBody> pile_bodies(const BoxPile& pile) {
  std::vector<ConvexBody> bodies;
  for_each_cell(pile, [&](const Cell& cell) {
    Cell below = cell;
    --below[2];
    if (!pile.is_filled(cell) || pile.is_filled(below)) return;
    Cell end = cell;  // of the run of filled cells
    while (pile.is_filled(end)) ++end[2];
    ConvexBody body;
    for (int corner = 0; corner < 8; ++corner) {
      body.push_back(point_at(pile, {cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1),
                                     (corner >> 2 & 1) != 0 ? end[2] : cell[2]}));
    }
    bodies.push_back(body);
  });
  return bodies;
}

double clear_lateral_tolerance(const BoxPile& pile, std::uint32_t seed) {
  Random random(seed);
  const double gap = pile.smallest_gap();
  for (;;) {
    const double lateral = gap * 0.1 * std::pow(40.0, random.between(0.0, 1.0));
    bool clear = true;
    for (const auto& along : pile.planes) {
      for (const double a : along) {
        for (const double b : along) clear = clear && std::abs(a + lateral - b) > 0.01 * gap;
      }
    }
    if (clear) return lateral;
  }
}

RegionValues column_areas(const BoxPile& pile, int axis_number, bool along_plus, double lateral) {
  const auto axis = static_cast<std::size_t>(axis_number);
  const auto is_free = [&](Cell cell, int step) {
    for (; cell[axis] >= 0 && cell[axis] < pile.cells(axis_number); cell[axis] += step) {
      if (pile.is_filled(cell)) return false;
    }
    return true;
  };
  const int forward = along_plus ? 1 : -1;
  RegionValues areas;
  for_each_face(pile, [&](const CellFace& face) {
    const std::array<Cell, 4> corners = face.corners();
    const double area = glm::distance(point_at(pile, corners[0]), point_at(pile, corners[1])) *
                        glm::distance(point_at(pile, corners[1]), point_at(pile, corners[2]));
    if (face.axis == axis) {
      Cell above = face.cell;
      above[axis] += face.side;
      const bool free = is_free(above, face.side);
      areas[region_of(free && face.side == forward, free && face.side != forward)] += area;
      return;
    }
    // The cell that holds the points in front of the wall.
    const double place = pile.plane(static_cast<int>(face.axis), face.plane()) + face.side * lateral;
    const auto& planes = pile.planes[face.axis];
    Cell front = face.cell;
    front[face.axis] =
        static_cast<int>(std::upper_bound(planes.begin(), planes.end(), place) - planes.begin()) - 1;
    areas[region_of(is_free(front, forward), is_free(front, -forward))] += area;
  });
  return areas;
}

}  // namespace moldlight::test
