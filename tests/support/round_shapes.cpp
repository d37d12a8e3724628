// The shapes made of regular polygons: spool, sphere, ring, shaft, frustums.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/weld.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight::test {
namespace {

Loop reversed(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

/// Distance of a regular polygon's sides from its center.
double apothem(int sides, double radius) { return radius * std::cos(std::numbers::pi / sides); }

/// Area of the part of a convex polygon with |x| <= half_width.
double area_within(Loop2 loop, double half_width) {
  for (const double side : {1.0, -1.0}) {
    Loop2 kept;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      const double over_a = side * a.x - half_width, over_b = side * b.x - half_width;
      if (over_a <= 0.0) kept.push_back(a);
      if ((over_a < 0.0 && over_b > 0.0) || (over_a > 0.0 && over_b < 0.0)) {
        kept.push_back(a + over_a / (over_a - over_b) * (b - a));
      }
    }
    loop = kept;
  }
  return polygon_area(loop);
}

/// A sphere of trapezoids with vertices on the equator, so that no facet is near-vertical.
TriangleMesh sphere(double radius, int meridians, int bands) {
  CHECK(bands % 2 == 0);
  SolidBuilder solid;
  std::vector<Loop> rings;
  for (int band = 1; band < bands; ++band) {
    const double latitude = std::numbers::pi * (static_cast<double>(band) / bands - 0.5);
    // Every ring turned by the same angle: trapezoids stay planar.
    rings.push_back(
        at_height(regular_polygon(meridians, radius * std::cos(latitude), 7.0), radius * std::sin(latitude)));
  }
  for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring) solid.walls(rings[ring], rings[ring + 1]);
  const glm::dvec3 south(0, 0, -radius), north(0, 0, radius);
  for (std::size_t i = 0; i < rings[0].size(); ++i) {
    const std::size_t next = (i + 1) % rings[0].size();
    solid.face({south, rings.front()[next], rings.front()[i]});
    solid.face({north, rings.back()[i], rings.back()[next]});
  }
  return solid.mesh();
}

Shape frustum(std::string name, double draft_deg, const ShapeSettings& settings) {
  const int sides = 14;
  const double bottom_radius = 15.3, height = 21.8, slope = std::tan(glm::radians(draft_deg));
  const double top_radius = bottom_radius * (1.0 - height * slope / apothem(sides, bottom_radius));
  const Loop2 bottom = regular_polygon(sides, bottom_radius, 4.0),
              top = regular_polygon(sides, top_radius, 4.0);
  SolidBuilder solid;
  solid.face(reversed(at_height(bottom, 0.0)));
  solid.face(at_height(top, height));
  solid.walls(at_height(bottom, 0.0), at_height(top, height));

  const auto wall_area_below = [&](double z) {
    const double share = z / height;
    const double perimeter_at_z = (1.0 - share) * polygon_perimeter(bottom) + share * polygon_perimeter(top);
    return 0.5 * (polygon_perimeter(bottom) + perimeter_at_z) * z * std::sqrt(1.0 + slope * slope);
  };
  RegionValues areas;
  areas[Region::core] = polygon_area(top);
  areas[Region::cavity] = polygon_area(bottom);
  if (draft_deg < settings.tau_deg) {
    // From delta outside, the way down leads into the wall again where there is still delta / slope of it
    // below.
    const double both = wall_area_below(std::min(height, settings.lateral_tolerance / slope));
    areas[Region::both] = both;
    areas[Region::core] += wall_area_below(height) - both;
  } else {
    areas[Region::core] += wall_area_below(height);
  }
  return {std::move(name), solid.mesh(), {0, 0, 1}, areas, settings};
}

}  // namespace

Shape spool(const ShapeSettings& settings) {
  const int sides = 20;
  const double flange = 3.4, waist = 9.7;  // heights
  const Loop2 lower = regular_polygon(sides, 15.6, 2.0), neck = regular_polygon(sides, 5.3, 2.0),
              upper = regular_polygon(sides, 10.9, 2.0);
  const double z1 = flange, z2 = z1 + waist, z3 = z2 + flange;
  SolidBuilder solid;
  solid.face(reversed(at_height(lower, 0.0)));
  solid.walls(at_height(lower, 0.0), at_height(lower, z1));
  solid.face(at_height(lower, z1), {at_height(neck, z1)});
  solid.walls(at_height(neck, z1), at_height(neck, z2));
  solid.face(reversed(at_height(upper, z2)), {at_height(neck, z2)});
  solid.walls(at_height(upper, z2), at_height(upper, z3));
  solid.face(at_height(upper, z3));

  RegionValues areas;
  areas[Region::cavity] = polygon_area(lower);
  areas[Region::core] =
      polygon_area(upper) + (polygon_area(lower) - polygon_area(upper)) + polygon_perimeter(upper) * flange;
  areas[Region::both] = polygon_perimeter(lower) * flange;
  areas[Region::undercut] =
      2.0 * (polygon_area(upper) - polygon_area(neck)) + polygon_perimeter(neck) * waist;
  return {"spool", solid.mesh(), {0, 0, 1}, areas, settings};
}

Shape hollow_sphere(const ShapeSettings& settings) {
  const TriangleMesh outer = sphere(15.2, 18, 12), inner = sphere(8.7, 14, 10);
  std::vector<glm::dvec3> corners;
  for (const auto& facet : outer.facets) {
    for (const VertexIndex vertex : facet) corners.push_back(outer.vertices[vertex]);
  }
  for (const auto& facet : inner.facets) {
    for (const std::size_t corner : {0, 2, 1}) corners.push_back(inner.vertices[facet[corner]]);
  }
  RegionValues areas;
  areas[Region::core] = areas[Region::cavity] = 0.5 * facet_geometry(outer).total_area;
  areas[Region::undercut] = facet_geometry(inner).total_area;
  return {"hollow_sphere", weld_corners(corners), {0, 0, 1}, areas, settings};
}

Shape ring(const ShapeSettings& settings) {
  const int meridians = 24,
            sides = 8;  // corners of the section lie at its widest points: nothing is near-vertical
  std::vector<Loop> loops;
  double core = 0.0;
  for (const glm::dvec2& corner : regular_polygon(sides, 4.6)) {
    loops.push_back(at_height(regular_polygon(meridians, 10.8 + corner.x, 3.0), corner.y));
  }
  SolidBuilder solid;
  for (std::size_t i = 0; i < loops.size(); ++i) solid.walls(loops[i], loops[(i + 1) % loops.size()]);
  const Loop2 section = regular_polygon(sides, 4.6);
  for (std::size_t i = 0; i < sides / 2; ++i) {
    const glm::dvec2 a = section[i] + glm::dvec2(10.8, 0), b = section[i + 1] + glm::dvec2(10.8, 0);
    const double sum_of_apothems = apothem(meridians, a.x) + apothem(meridians, b.x);
    const double slant = std::hypot(b.y - a.y, apothem(meridians, b.x) - apothem(meridians, a.x));
    core += meridians * std::tan(std::numbers::pi / meridians) * sum_of_apothems * slant;
  }
  RegionValues areas;
  areas[Region::core] = areas[Region::cavity] = core;
  return {"ring", solid.mesh(), {0, 0, 1}, areas, settings};
}

Shape stepped_shaft(const ShapeSettings& settings) {
  const int sides = 24;  // corners at the widest points
  constexpr std::array<double, 3> k_radii = {6.2, 9.8, 4.4}, k_lengths = {8.7, 11.9, 10.3};
  const auto section = [&](std::size_t step, double y) {
    Loop loop;
    for (const glm::dvec2& point : regular_polygon(sides, k_radii[step]))
      loop.emplace_back(point.x, y, point.y);
    return loop;  // counter-clockwise seen along +y
  };
  SolidBuilder solid;
  RegionValues areas;
  double y = 0.0;
  solid.face(section(0, 0.0));
  for (std::size_t step = 0; step < 3; ++step) {
    const double next_y = y + k_lengths[step];
    solid.walls(section(step, next_y), section(step, y));
    const double walls = polygon_perimeter(regular_polygon(sides, k_radii[step])) * k_lengths[step];
    areas[Region::core] += 0.5 * walls;
    areas[Region::cavity] += 0.5 * walls;
    if (step < 2) {
      const bool widens = k_radii[step + 1] > k_radii[step];
      const std::size_t wide = widens ? step + 1 : step, narrow = widens ? step : step + 1;
      if (widens) {
        solid.face(section(wide, next_y), {section(narrow, next_y)});
      } else {
        solid.face(reversed(section(wide, next_y)), {section(narrow, next_y)});
      }
      // Beside the narrow shaft the shoulder is open to both sides, above it to the core, below it to the
      // cavity.
      const Loop2 shoulder = regular_polygon(sides, k_radii[wide]);
      const double above_and_below = area_within(shoulder, k_radii[narrow]);
      const double hidden_by_shaft = above_and_below - polygon_area(regular_polygon(sides, k_radii[narrow]));
      areas[Region::core] += 0.5 * hidden_by_shaft;
      areas[Region::cavity] += 0.5 * hidden_by_shaft;
      areas[Region::both] += polygon_area(shoulder) - above_and_below;
    }
    y = next_y;
  }
  solid.face(reversed(section(2, y)));
  areas[Region::both] +=
      polygon_area(regular_polygon(sides, k_radii[0])) + polygon_area(regular_polygon(sides, k_radii[2]));
  return {"stepped_shaft", solid.mesh(), {0, 0, 1}, areas, settings};
}

Shape frustum_under_tau(const ShapeSettings& settings) {
  return frustum("frustum_under_tau", 0.98 * settings.tau_deg, settings);
}

Shape frustum_over_tau(const ShapeSettings& settings) {
  return frustum("frustum_over_tau", 1.02 * settings.tau_deg, settings);
}

}  // namespace moldlight::test
