// Bodies that overlap, united: area and volume are those of the cells that any of them fills.
#include "mold/exact/united_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mesh/weld.hpp"
#include "support/boxes.hpp"
#include "support/exact_model.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"

namespace moldlight {
namespace {

struct Box {
  glm::dvec3 low, high;
};

struct Figures {
  double area = 0.0, volume = 0.0;
};

/// Of the union, by the grid of all planes of the boxes.
Figures union_figures(const std::vector<Box>& boxes) {
  std::array<std::vector<double>, 3> planes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Box& box : boxes) planes[axis].insert(planes[axis].end(), {box.low[axis], box.high[axis]});
    std::ranges::sort(planes[axis]);
    planes[axis].erase(std::unique(planes[axis].begin(), planes[axis].end()), planes[axis].end());
  }
  const auto filled = [&](const std::array<std::size_t, 3>& cell) {
    glm::dvec3 middle(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      if (cell[axis] >= planes[axis].size() - 1) return false;
      middle[axis] = 0.5 * (planes[axis][cell[axis]] + planes[axis][cell[axis] + 1]);
    }
    return std::ranges::any_of(boxes, [&](const Box& box) {
      return glm::all(glm::lessThanEqual(box.low, middle)) && glm::all(glm::lessThanEqual(middle, box.high));
    });
  };
  Figures figures;
  for (std::size_t i = 0; i + 1 < planes[0].size(); ++i) {
    for (std::size_t j = 0; j + 1 < planes[1].size(); ++j) {
      for (std::size_t k = 0; k + 1 < planes[2].size(); ++k) {
        const std::array<std::size_t, 3> cell = {i, j, k};
        if (!filled(cell)) continue;
        glm::dvec3 size(0.0);
        for (int axis = 0; axis < 3; ++axis)
          size[axis] = planes[axis][cell[axis] + 1] - planes[axis][cell[axis]];
        figures.volume += size.x * size.y * size.z;
        for (int axis = 0; axis < 3; ++axis) {
          for (const int step : {-1, 1}) {
            std::array<std::size_t, 3> beside = cell;
            beside[axis] += static_cast<std::size_t>(step);  // wraps to what is not filled
            if (!filled(beside)) figures.area += size[(axis + 1) % 3] * size[(axis + 2) % 3];
          }
        }
      }
    }
  }
  return figures;
}

Part part_of(const TriangleMesh& mesh) {
  Part part;
  part.file = "test";
  part.mesh = weld_vertices(mesh);
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  return part;
}

TriangleMesh mesh_of(const std::vector<Box>& boxes) {
  TriangleMesh mesh;
  for (const Box& box : boxes) mesh = test::joined(mesh, test::box_mesh(box.low, box.high));
  return mesh;
}

void expect_united(Part part, const Figures& figures, const std::string& what) {
  SCOPED_TRACE(what);
  mend_part(part, {.level = RepairLevel::unite}, {});
  const FacetGeometry geometry = facet_geometry(part.mesh);
  const HealthReport health = health_report(part.mesh, geometry);
  EXPECT_EQ(health.open_edges, 0u);
  EXPECT_NEAR(health.area, figures.area, 1e-9 * figures.area);
  EXPECT_NEAR(health.volume, figures.volume, 1e-9 * figures.volume);
  const test::ExactModel model(part.mesh);
  EXPECT_TRUE(model.part().closed());
  test::ShapeSettings settings = model.default_settings();
  for (const glm::dvec3& direction : test::five_directions()) {
    const ExactAreas areas = model.areas(direction, settings);
    EXPECT_NEAR(areas.projected_core, areas.projected_cavity,
                areas.projected_doubt + 1e-9 * areas.projected_core);
  }
}

std::vector<Box> random_boxes(std::uint32_t seed, std::size_t count, bool in_lattice) {
  test::Random random(seed);
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < count; ++k) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = in_lattice ? static_cast<double>(random.below(6)) : random.between(0.0, 6.0);
      box.high[axis] =
          box.low[axis] + (in_lattice ? static_cast<double>(1 + random.below(3)) : random.between(0.5, 3.0));
    }
    boxes.push_back(box);
  }
  return boxes;
}

TEST(UnitedBodies, BoxesAnywhere) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    const std::vector<Box> boxes = random_boxes(seed, 3 + 2 * seed, false);
    expect_united(part_of(mesh_of(boxes)), union_figures(boxes), std::to_string(seed));
  }
}

TEST(UnitedBodies, BoxesThatTouchAndCoincide) {
  for (std::uint32_t seed = 1; seed <= 24; ++seed) {
    const std::vector<Box> boxes = random_boxes(seed, 2 + 2 * seed, true);
    expect_united(part_of(mesh_of(boxes)), union_figures(boxes), std::to_string(seed));
  }
}

TEST(UnitedBodies, TurnedBoxesCrossByRounding) {
  const glm::dvec3 x = glm::normalize(glm::dvec3(0.6, 0.5, -0.3));
  const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(0.1, 0.7, 0.2), x)), z = glm::cross(x, y);
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    const std::vector<Box> boxes = random_boxes(seed, 10, seed % 2 == 0);
    TriangleMesh mesh = mesh_of(boxes);
    for (glm::dvec3& vertex : mesh.vertices) vertex = vertex.x * x + vertex.y * y + vertex.z * z;
    expect_united(part_of(mesh), union_figures(boxes), std::to_string(seed));
  }
}

TEST(UnitedBodies, AVoidStaysAndABodyInsideGoes) {
  // A box with a void, in which lies a smaller box; another one lies in the material.
  TriangleMesh hollow = test::box_mesh({2, 2, 2}, {8, 8, 8});
  for (FacetIndex facet = 0; facet < hollow.facets.size(); ++facet) test::reverse_facet(hollow, facet);
  TriangleMesh mesh = test::joined(test::box_mesh({0, 0, 0}, {10, 10, 10}), hollow);
  const auto with_void = static_cast<FacetIndex>(mesh.facets.size());
  mesh = test::joined(mesh, test::box_mesh({4, 4, 4}, {5, 5, 5}));
  mesh = test::joined(mesh, test::box_mesh({0.5, 0.5, 0.5}, {1, 1, 1}));
  Part part = part_of(mesh);
  part.bodies = {{"hollow", 0, with_void}, {"in the void", with_void, 12}, {"inside", with_void + 12, 12}};
  mend_part(part, {.level = RepairLevel::unite}, {});
  ASSERT_EQ(part.bodies.size(), 2u);
  EXPECT_EQ(part.bodies[1].name, "in the void");
  EXPECT_EQ(part.mesh.facets.size(), 36u);
  EXPECT_EQ(part.file_facets.back(), with_void + 11);
  const HealthReport health = health_report(part.mesh, facet_geometry(part.mesh));
  EXPECT_NEAR(health.volume, 1000.0 - 216.0 + 1.0, 1e-9);
}

TEST(UnitedBodies, FoldsOfNoThicknessGo) {
  // The top of a box, once more forth and back: a strip of it lies there three times.
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {4, 4, 1});
  const auto at = [&](double px, double py) {
    mesh.vertices.emplace_back(px, py, 1.0);
    return static_cast<VertexIndex>(mesh.vertices.size() - 1);
  };
  std::erase_if(mesh.facets, [&](const std::array<VertexIndex, 3>& facet) {
    return std::ranges::all_of(facet, [&](VertexIndex k) { return mesh.vertices[k].z == 1.0; });
  });
  // From x = 0 to 3, back to 1, and on to 4.
  std::array<std::array<VertexIndex, 2>, 4> rows{};
  const std::array<double, 4> steps = {0.0, 3.0, 1.0, 4.0};
  for (std::size_t k = 0; k < 4; ++k) rows[k] = {at(steps[k], 0.0), at(steps[k], 4.0)};
  for (std::size_t k = 0; k < 3; ++k) {
    mesh.facets.push_back({rows[k][0], rows[k + 1][0], rows[k + 1][1]});
    mesh.facets.push_back({rows[k][0], rows[k + 1][1], rows[k][1]});
  }
  for (const double side : {0.0, 4.0}) {  // of the walls beside: to the folds, forth and back
    const bool first = side == 0.0;
    const std::size_t end = first ? 0 : 1;
    const VertexIndex a = rows[0][end], b = rows[1][end], c = rows[2][end], d = rows[3][end];
    mesh.facets.push_back(first ? std::array{a, d, b} : std::array{a, b, d});
    mesh.facets.push_back(first ? std::array{b, d, c} : std::array{b, c, d});
  }
  Part part = part_of(mesh);
  ASSERT_EQ(health_report(part.mesh, facet_geometry(part.mesh)).open_edges, 0u);
  mend_part(part, {.level = RepairLevel::unite}, {});
  const HealthReport health = health_report(part.mesh, facet_geometry(part.mesh));
  EXPECT_EQ(health.open_edges, 0u);
  EXPECT_NEAR(health.area, 2 * 16.0 + 16.0, 1e-9);
  EXPECT_NEAR(health.volume, 16.0, 1e-9);
}

TEST(UnitedBodies, OpenBodiesAndTooManyCrossingsAreRefused) {
  TriangleMesh open = test::box_mesh({0, 0, 0}, {1, 1, 1});
  open.facets.pop_back();
  Part part = part_of(open);
  EXPECT_THROW(mend_part(part, {.level = RepairLevel::unite}, {}), Error);
  test::Random random(5);
  TriangleMesh loose;  // flat bodies as large as the part
  for (VertexIndex k = 0; k < 6000; k += 3) {
    for (int corner = 0; corner < 3; ++corner) loose.vertices.push_back(random.in_cube(1.0));
    loose.facets.push_back({k, k + 1, k + 2});
    loose.facets.push_back({k, k + 2, k + 1});
  }
  part = part_of(loose);
  EXPECT_THROW(unite_bodies(part, {}), Error);
}

}  // namespace
}  // namespace moldlight
