// The shapes that are a profile in the xz-plane, extruded along y: rib, notch, hooks, brackets, slots,
// ledges.
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight::test {
namespace {

constexpr double k_length = 23.7;

/// Areas are given per unit of length; the two ends of the profile face sideways and are open to both sides.
Shape extruded(std::string name, const Loop2& profile, RegionValues areas, const ShapeSettings& settings) {
  for (double& area : areas.values) area *= k_length;
  areas[Region::both] += 2.0 * polygon_area(profile);
  SolidBuilder solid;
  solid.extrude(profile, {}, k_length);
  return {std::move(name), solid.mesh(), {0, 0, 1}, areas, settings};
}

Shape with_ledge(std::string name, double ledge, bool hides_wall, const ShapeSettings& settings) {
  const double width = 28.4, low = 7.9, high = 19.3;
  const Loop2 profile = {{0, 0},   {width, 0}, {width, low}, {width - ledge, low}, {width - ledge, high},
                         {0, high}};
  RegionValues areas;
  areas[Region::core] = width + (hides_wall ? high - low : 0.0);
  areas[Region::cavity] = width;
  areas[Region::both] = low + high + (hides_wall ? 0.0 : high - low);
  return extruded(std::move(name), profile, areas, settings);
}

}  // namespace

Shape thin_rib(const ShapeSettings& settings) {
  const double width = 31.3, plate = 2.7, rib_x = 11.6, rib = 0.6, height = 14.2;
  const Loop2 profile = {
      {0, 0},          {width, 0},     {width, plate}, {rib_x + rib, plate}, {rib_x + rib, height},
      {rib_x, height}, {rib_x, plate}, {0, plate}};
  RegionValues areas;
  areas[Region::core] = width + 2.0 * (height - plate);
  areas[Region::cavity] = width;
  areas[Region::both] = 2.0 * plate;
  return extruded("thin_rib", profile, areas, settings);
}

Shape v_notch(const ShapeSettings& settings) {
  const double width = 27.9, height = 21.4, low = 6.3, tip_z = 12.2, high = 15.9, depth = 9.4;
  const Loop2 profile = {{0, 0},        {width, 0},      {width, low}, {width - depth, tip_z},
                         {width, high}, {width, height}, {0, height}};
  RegionValues areas;
  areas[Region::core] = areas[Region::cavity] = width;
  areas[Region::both] = height + low + (height - high);
  areas[Region::undercut] = std::hypot(depth, tip_z - low) + std::hypot(depth, high - tip_z);
  return extruded("v_notch", profile, areas, settings);
}

Shape snap_hook(const ShapeSettings& settings) {
  const double width = 29.2, plate = 2.9, beam_x = 10.4, beam = 2.1, catch_z = 15.6, catch_width = 3.3,
               land = 1.7, top = 21.9;
  // Up the beam's right side, out along the catch, up the land, and back over the lead-in slope to the beam's
  // left.
  const Loop2 profile = {{0, 0},
                         {width, 0},
                         {width, plate},
                         {beam_x + beam, plate},
                         {beam_x + beam, catch_z},
                         {beam_x + beam + catch_width, catch_z},
                         {beam_x + beam + catch_width, catch_z + land},
                         {beam_x, top},
                         {beam_x, plate},
                         {0, plate}};
  RegionValues areas;
  areas[Region::cavity] = width;
  areas[Region::both] = 2.0 * plate;
  areas[Region::undercut] = 2.0 * catch_width + (catch_z - plate);
  areas[Region::core] = (width - beam - catch_width) + land +
                        std::hypot(beam + catch_width, top - catch_z - land) + (top - plate);
  return extruded("snap_hook", profile, areas, settings);
}

Shape snap_hook_past_edge(const ShapeSettings& settings) {
  // The same hook at the edge of the plate: the mold half below reaches the catch past the plate's end.
  const double width = 18.6, plate = 2.9, beam = 2.1, catch_z = 15.6, catch_width = 3.3, land = 1.7,
               top = 21.9;
  const double beam_x = width - beam;
  const Loop2 profile = {{0, 0},
                         {width, 0},
                         {width, catch_z},
                         {width + catch_width, catch_z},
                         {width + catch_width, catch_z + land},
                         {beam_x, top},
                         {beam_x, plate},
                         {0, plate}};
  RegionValues areas;
  areas[Region::cavity] = width + catch_width + catch_z;
  areas[Region::both] = plate + land;
  areas[Region::core] = beam_x + (top - plate) + std::hypot(beam + catch_width, top - catch_z - land);
  return extruded("snap_hook_past_edge", profile, areas, settings);
}

Shape l_bracket(const ShapeSettings& settings) {
  const double width = 26.8, plate = 3.1, wall = 2.6, height = 19.7;
  const Loop2 profile = {
      {0, 0}, {width, 0}, {width, height}, {width - wall, height}, {width - wall, plate}, {0, plate}};
  RegionValues areas;
  areas[Region::core] = width + (height - plate);
  areas[Region::cavity] = width;
  areas[Region::both] = plate + height;
  return extruded("l_bracket", profile, areas, settings);
}

Shape oblique_l_bracket(const ShapeSettings& settings) {
  const double width = 26.8, plate = 3.1, wall = 2.6, height = 19.7, tilt = glm::radians(20.0);
  Shape shape = l_bracket(settings);
  shape.name = "oblique_l_bracket";
  shape.direction = {std::sin(tilt), 0.0, std::cos(tilt)};
  // The wall leans over the floor: it hides a strip of it from +d, and the floor hides the wall's inner side
  // from -d.
  const double shadow = (height - plate) * std::tan(tilt);
  RegionValues areas;
  areas[Region::undercut] = k_length * (shadow + height - plate);
  areas[Region::core] = k_length * (width - wall - shadow + wall + height);
  areas[Region::cavity] = k_length * (width + plate);
  areas[Region::both] = shape.expected[Region::both] - k_length * (plate + height);
  shape.expected = areas;
  return shape;
}

Shape t_bar(const ShapeSettings& settings) {
  const double width = 25.6, web_x = 11.9, web = 2.8, under = 16.4, height = 19.5;
  const Loop2 profile = {{web_x, 0},      {web_x + web, 0}, {web_x + web, under}, {width, under},
                         {width, height}, {0, height},      {0, under},           {web_x, under}};
  RegionValues areas;
  areas[Region::core] = width;
  areas[Region::cavity] = width + 2.0 * under;
  areas[Region::both] = 2.0 * (height - under);
  return extruded("t_bar", profile, areas, settings);
}

Shape t_slot(const ShapeSettings& settings) {
  const double width = 31.2, height = 20.6, floor = 4.3, shelf = 11.7;
  const double wide_low = 6.1, neck_low = 11.9, neck_high = 18.4, wide_high = 25.8;
  const Loop2 profile = {{0, 0},
                         {width, 0},
                         {width, height},
                         {neck_high, height},
                         {neck_high, shelf},
                         {wide_high, shelf},
                         {wide_high, floor},
                         {wide_low, floor},
                         {wide_low, shelf},
                         {neck_low, shelf},
                         {neck_low, height},
                         {0, height}};
  const double neck = neck_high - neck_low, hidden = wide_high - wide_low - neck;
  RegionValues areas;
  areas[Region::cavity] = width;
  areas[Region::core] = (width - neck) + 2.0 * (height - shelf) + neck;
  areas[Region::both] = 2.0 * height;
  areas[Region::undercut] = 2.0 * hidden + 2.0 * (shelf - floor);
  return extruded("t_slot", profile, areas, settings);
}

Shape dovetail_slot(const ShapeSettings& settings) {
  const double width = 30.4, height = 17.2, floor = 6.6;
  const double low = 5.7, neck_low = 11.3, neck_high = 19.9, high = 25.1;
  const Loop2 profile = {{0, 0},        {width, 0},   {width, height},    {neck_high, height},
                         {high, floor}, {low, floor}, {neck_low, height}, {0, height}};
  RegionValues areas;
  areas[Region::cavity] = width;
  areas[Region::core] = width;  // the floor under the neck makes up for the neck
  areas[Region::both] = 2.0 * height;
  areas[Region::undercut] = (neck_low - low) + (high - neck_high) +
                            std::hypot(neck_low - low, height - floor) +
                            std::hypot(high - neck_high, height - floor);
  return extruded("dovetail_slot", profile, areas, settings);
}

Shape narrow_ledge(const ShapeSettings& settings) {
  return with_ledge("narrow_ledge", 0.5 * settings.lateral_tolerance, false, settings);
}

Shape wide_ledge(const ShapeSettings& settings) {
  return with_ledge("wide_ledge", 2.0 * settings.lateral_tolerance, true, settings);
}

}  // namespace moldlight::test
