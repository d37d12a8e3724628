#include "support/curved_solids.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace moldlight::test {

namespace {

using Index = VertexIndex;

void add_quad(TriangleMesh& mesh, Index a, Index b, Index c, Index d) {
  mesh.facets.push_back({a, b, c});
  mesh.facets.push_back({a, c, d});
}

}  // namespace

TriangleMesh tube_mesh(const TubeShape& tube) {
  const auto sections = static_cast<Index>(tube.centres.size()), sides = static_cast<Index>(tube.sides);
  const bool hollow = tube.inner_radius > 0.0;
  TriangleMesh mesh;
  const auto add_skin = [&](double radius) {
    const auto first = static_cast<Index>(mesh.vertices.size());
    for (Index s = 0; s < sections; ++s) {
      const std::size_t before = tube.ring ? (s + sections - 1) % sections : s == 0 ? 0 : s - 1;
      const std::size_t after = tube.ring ? (s + 1) % sections : s + 1 == sections ? s : s + 1;
      const glm::dvec3 along = glm::normalize(tube.centres[after] - tube.centres[before]);
      const glm::dvec3 side = glm::cross(along, tube.normal);
      for (Index k = 0; k < sides; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / tube.sides;
        mesh.vertices.push_back(tube.centres[s] +
                                radius * (std::cos(angle) * tube.normal + std::sin(angle) * side));
      }
    }
    return first;
  };
  const auto at = [&](Index first, Index s, Index k) { return first + s % sections * sides + k % sides; };
  const Index outer = add_skin(tube.radius), inner = hollow ? add_skin(tube.inner_radius) : outer;
  for (Index s = 0; s + (tube.ring ? 0 : 1) < sections; ++s) {
    for (Index k = 0; k < sides; ++k) {
      add_quad(mesh, at(outer, s, k), at(outer, s + 1, k), at(outer, s + 1, k + 1), at(outer, s, k + 1));
      if (hollow)
        add_quad(mesh, at(inner, s, k), at(inner, s, k + 1), at(inner, s + 1, k + 1), at(inner, s + 1, k));
    }
  }
  if (tube.ring) return mesh;
  const Index last = sections - 1;
  for (Index k = 0; k < sides; ++k) {
    if (hollow) {
      add_quad(mesh, at(outer, 0, k), at(outer, 0, k + 1), at(inner, 0, k + 1), at(inner, 0, k));
      add_quad(mesh, at(outer, last, k + 1), at(outer, last, k), at(inner, last, k), at(inner, last, k + 1));
    } else if (k >= 1 && k + 1 < sides) {
      mesh.facets.push_back({at(outer, 0, 0), at(outer, 0, k), at(outer, 0, k + 1)});
      mesh.facets.push_back({at(outer, last, 0), at(outer, last, k + 1), at(outer, last, k)});
    }
  }
  return mesh;
}

TriangleMesh torus_mesh(double radius, double tube_radius, int around, int sides) {
  TubeShape tube{.centres = {}, .radius = tube_radius, .normal = {0, 0, 1}, .sides = sides, .ring = true};
  for (int k = 0; k < around; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / around;
    tube.centres.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return tube_mesh(tube);
}

TriangleMesh sheet_mesh(int corners, double radius, double thickness,
                        const std::function<double(double, double)>& height) {
  TriangleMesh mesh;
  const auto n = static_cast<Index>(corners);
  for (const double lift : {0.0, thickness}) {
    mesh.vertices.emplace_back(0.0, 0.0, height(0.0, 0.0) + lift);
    for (Index k = 0; k < n; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / corners;
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      mesh.vertices.emplace_back(x, y, height(x, y) + lift);
    }
  }
  const Index top = n + 1;
  for (Index k = 0; k < n; ++k) {
    const Index a = 1 + k, b = 1 + (k + 1) % n;
    mesh.facets.push_back({0, b, a});
    mesh.facets.push_back({top, top + a, top + b});
    add_quad(mesh, a, b, top + b, top + a);
  }
  return mesh;
}

TriangleMesh plate_with_holes(int rows, int columns, double thickness) {
  // A grid of cells, of which every ninth of a square of 10 is left out.
  const int across = 3 * columns, along = 3 * rows;
  const auto place = [](int k) { return 10.0 * (k / 3) + (k % 3 == 0 ? 0.0 : k % 3 == 1 ? 3.0 : 7.0); };
  const auto is_solid = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < across && y < along && (x % 3 != 1 || y % 3 != 1);
  };
  const auto layer = static_cast<Index>((across + 1) * (along + 1));
  const auto at = [&](int x, int y) { return static_cast<Index>(y * (across + 1) + x); };
  TriangleMesh mesh;
  for (const double z : {0.0, thickness}) {
    for (int y = 0; y <= along; ++y) {
      for (int x = 0; x <= across; ++x) mesh.vertices.emplace_back(place(x), place(y), z);
    }
  }
  const auto add_wall = [&](Index a, Index b) { add_quad(mesh, a, b, layer + b, layer + a); };
  for (int y = 0; y < along; ++y) {
    for (int x = 0; x < across; ++x) {
      if (!is_solid(x, y)) continue;
      const Index a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), d = at(x, y + 1);
      add_quad(mesh, a, d, c, b);
      add_quad(mesh, layer + a, layer + b, layer + c, layer + d);
      if (!is_solid(x, y - 1)) add_wall(a, b);
      if (!is_solid(x + 1, y)) add_wall(b, c);
      if (!is_solid(x, y + 1)) add_wall(c, d);
      if (!is_solid(x - 1, y)) add_wall(d, a);
    }
  }
  return mesh;
}

}  // namespace moldlight::test
