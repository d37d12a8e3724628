// The shapes made of boxes, and what is done with all shapes.
#include "support/shapes.hpp"

#include <utility>

#include <glm/geometric.hpp>

#include "support/mesh_edits.hpp"
#include "support/solid_builder.hpp"

namespace moldlight::test {
namespace {

Shape made(std::string name, const SolidBuilder& solid, const RegionValues& expected,
           const ShapeSettings& settings) {
  return {std::move(name), solid.mesh(), {0, 0, 1}, expected, settings};
}

/// Outer and inner size of the cups: the cavity opens upward.
struct CupSize {
  glm::dvec3 outer_high{31.7, 24.3, 18.9};
  glm::dvec3 inner_low{2.3, 1.9, 3.1};
  glm::dvec3 inner_high{28.9, 21.7, 18.9};
};

RegionValues cup_areas(const CupSize& size) {
  const glm::dvec3 inner = size.inner_high - size.inner_low;
  const double footprint = size.outer_high.x * size.outer_high.y;
  RegionValues areas;
  areas[Region::cavity] = footprint;
  areas[Region::core] =
      footprint + 2.0 * (inner.x + inner.y) * inner.z;  // rim and floor make up the footprint
  areas[Region::both] = 2.0 * (size.outer_high.x + size.outer_high.y) * size.outer_high.z;
  return areas;
}

void add_cup_rim(SolidBuilder& solid, const CupSize& size) {
  solid.face(box_face({0, 0, 0}, size.outer_high, 5), {box_face(size.inner_low, size.inner_high, 5)});
}

}  // namespace

Shape box_shape(const ShapeSettings& settings) {
  const glm::dvec3 size(31.7, 24.3, 12.1);
  SolidBuilder solid;
  solid.box({0, 0, 0}, size);
  RegionValues areas;
  areas[Region::core] = areas[Region::cavity] = size.x * size.y;
  areas[Region::both] = 2.0 * (size.x + size.y) * size.z;
  return made("box", solid, areas, settings);
}

Shape cup(const ShapeSettings& settings) {
  const CupSize size;
  SolidBuilder solid;
  solid.box({0, 0, 0}, size.outer_high, {5});
  solid.box(size.inner_low, size.inner_high, {5}, true);
  add_cup_rim(solid, size);
  return made("cup", solid, cup_areas(size), settings);
}

Shape cup_with_side_hole(const ShapeSettings& settings) {
  const CupSize size;
  const glm::dvec3 low(size.inner_high.x, 6.7, 7.3), high(size.outer_high.x, 15.2, 13.6), hole = high - low;
  SolidBuilder solid;
  solid.box({0, 0, 0}, size.outer_high, {1, 5});
  solid.box(size.inner_low, size.inner_high, {1, 5}, true);
  solid.box(low, high, {0, 1}, true);
  solid.face(box_face({0, 0, 0}, size.outer_high, 1), {box_face(low, high, 1)});
  const Loop inner_wall = box_face(size.inner_low, size.inner_high, 1);
  solid.face({inner_wall.rbegin(), inner_wall.rend()},
             {box_face({0, low.y, low.z}, low + glm::dvec3(0, hole.y, hole.z), 1)});
  add_cup_rim(solid, size);

  RegionValues areas = cup_areas(size);
  areas[Region::core] -= hole.y * hole.z;
  areas[Region::both] -= hole.y * hole.z;
  areas[Region::undercut] = 2.0 * (hole.y + hole.z) * hole.x;
  return made("cup_with_side_hole", solid, areas, settings);
}

Shape plate_with_side_pocket(const ShapeSettings& settings) {
  const glm::dvec3 size(31.7, 24.3, 12.1), low(23.8, 5.9, 3.7), high(31.7, 17.3, 8.8), pocket = high - low;
  SolidBuilder solid;
  solid.box({0, 0, 0}, size, {1});
  solid.box(low, high, {1}, true);
  solid.face(box_face({0, 0, 0}, size, 1), {box_face(low, high, 1)});
  RegionValues areas;
  areas[Region::core] = areas[Region::cavity] = size.x * size.y;
  areas[Region::both] = 2.0 * (size.x + size.y) * size.z - pocket.y * pocket.z;
  areas[Region::undercut] = pocket.y * pocket.z + 2.0 * (pocket.y + pocket.z) * pocket.x;
  return made("plate_with_side_pocket", solid, areas, settings);
}

Shape plate_with_through_hole(const ShapeSettings& settings) {
  const glm::dvec3 size(31.7, 24.3, 12.1);
  Loop2 hole = regular_polygon(17, 6.3, 5.0);
  for (glm::dvec2& point : hole) point += glm::dvec2(13.4, 11.2);
  SolidBuilder solid;
  solid.box({0, 0, 0}, size, {4, 5});
  solid.face(box_face({0, 0, 0}, size, 4), {at_height(hole, 0.0)});
  solid.face(box_face({0, 0, 0}, size, 5), {at_height(hole, size.z)});
  const Loop2 inward(hole.rbegin(), hole.rend());
  solid.walls(at_height(inward, 0.0), at_height(inward, size.z));
  RegionValues areas;
  areas[Region::core] = areas[Region::cavity] = size.x * size.y - polygon_area(hole);
  areas[Region::both] = (2.0 * (size.x + size.y) + polygon_perimeter(hole)) * size.z;
  return made("plate_with_through_hole", solid, areas, settings);
}

Shape block_with_crossing_hole(const ShapeSettings& settings) {
  const double width = 31.7, length = 24.3, height = 22.6;
  Loop2 hole = regular_polygon(22, 7.1, 3.0);
  for (glm::dvec2& point : hole) point += glm::dvec2(14.2, 11.9);
  SolidBuilder solid;
  solid.extrude({{0, 0}, {width, 0}, {width, height}, {0, height}}, {hole}, length);
  RegionValues areas;
  areas[Region::core] = areas[Region::cavity] = width * length;
  areas[Region::both] = 2.0 * (width + length) * height - 2.0 * polygon_area(hole);
  areas[Region::undercut] = polygon_perimeter(hole) * length;
  return made("block_with_crossing_hole", solid, areas, settings);
}

Shape turned(Shape shape, const glm::dquat& rotation) {
  shape.name += "_turned";
  shape.mesh = rotated(std::move(shape.mesh), rotation);
  shape.direction = glm::normalize(rotation * shape.direction);
  return shape;
}

Shape refined(Shape shape, std::size_t target_facets) {
  shape.mesh = subdivided(std::move(shape.mesh), target_facets);
  return shape;
}

std::vector<Shape> all_shapes(const ShapeSettings& settings) {
  using Maker = Shape (*)(const ShapeSettings&);
  constexpr Maker k_makers[] = {box_shape,
                                cup,
                                cup_with_side_hole,
                                plate_with_side_pocket,
                                plate_with_through_hole,
                                block_with_crossing_hole,
                                spool,
                                hollow_sphere,
                                ring,
                                stepped_shaft,
                                frustum_under_tau,
                                frustum_over_tau,
                                thin_rib,
                                v_notch,
                                snap_hook,
                                snap_hook_past_edge,
                                l_bracket,
                                oblique_l_bracket,
                                t_bar,
                                t_slot,
                                dovetail_slot,
                                narrow_ledge,
                                wide_ledge};
  std::vector<Shape> shapes;
  std::uint32_t seed = 1;
  for (const Maker maker : k_makers) {
    Shape shape = maker(settings);
    const std::size_t facets = 2 * (100 + shape.mesh.facets.size() / 2 * 2);
    shapes.push_back(refined(std::move(shape), facets));
    shapes.push_back(turned(shapes.back(), random_rotation(seed++)));
  }
  return shapes;
}

}  // namespace moldlight::test
