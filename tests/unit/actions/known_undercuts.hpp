// Parts whose undercuts are released in a way that is known in closed form.
#pragma once

#include <algorithm>
#include <memory>

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "actions/side_action.hpp"
#include "support/mesh_edits.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {

using test::at_height;
using test::box_face;
using test::Loop2;
using test::regular_polygon;
using test::SolidBuilder;

inline constexpr double k_tau_deg = 1.0;

struct Planned {
  std::shared_ptr<const PartModel> model;
  Classification result;
  ActionPlan plan;
};

inline Planned plan_of(const TriangleMesh& mesh, const ActionSettings& settings = {},
                       const glm::dvec3& direction = {0, 0, 1}) {
  Planned planned;
  Part part;
  part.unit = "mm";
  part.mesh = mesh;
  part.bodies = {{"", 0, static_cast<FacetIndex>(mesh.facets.size())}};
  planned.model = prepare_part(std::move(part), Progress());
  Query query;
  query.direction = direction;
  planned.result = classify_exact(*planned.model, query, Progress(), true);
  planned.plan = find_actions(*planned.model, planned.result, settings, Progress());
  return planned;
}

/// Lifters that stand on nothing, where something else about them is looked at.
inline ActionSettings without_stems() {
  ActionSettings settings;
  settings.lifter_section_mm = 0.0;
  return settings;
}

struct Hole {
  double draft_deg = 0.0;
  bool through = false;
  double depth = 14.0, radius = 5.0;
  int sides = 32;
  double turn_deg = 0.0;
  double lean_deg = 0.0;  // of its axis, towards +y
};

/// A block with a hole from its +z face, wider there by the draft.
inline TriangleMesh block_with_hole(const Hole& hole) {
  const glm::dvec3 low(-14, -12, 0), high(14, 12, 22);
  const double depth = hole.through ? high.z : hole.depth;
  const double narrow = hole.radius - depth * std::tan(glm::radians(hole.draft_deg));
  const Loop2 outer = regular_polygon(hole.sides, hole.radius, hole.turn_deg);
  Loop2 inner = regular_polygon(hole.sides, narrow, hole.turn_deg);
  for (glm::dvec2& corner : inner) corner.y -= depth * std::tan(glm::radians(hole.lean_deg));
  SolidBuilder solid;
  if (hole.through) {
    solid.box(low, high, {4, 5});
    solid.face(box_face(low, high, 4), {at_height(inner, low.z)});
  } else {
    solid.box(low, high, {5});
    solid.face(at_height(inner, high.z - depth));
  }
  solid.face(box_face(low, high, 5), {at_height(outer, high.z)});
  const Loop2 in_outer(outer.rbegin(), outer.rend()), in_inner(inner.rbegin(), inner.rend());
  solid.walls(at_height(in_inner, high.z - depth), at_height(in_outer, high.z));
  return solid.mesh();
}

/// Its z axis laid into the plane across z, at this azimuth.
inline TriangleMesh laid(const TriangleMesh& mesh, double azimuth_deg) {
  const glm::dquat down = glm::angleAxis(glm::radians(90.0), glm::dvec3(0, 1, 0));
  const glm::dquat round = glm::angleAxis(glm::radians(azimuth_deg), glm::dvec3(0, 0, 1));
  return test::rotated(mesh, round * down);
}

/// A block with a cavity, open above, whose profile in the xz-plane (counter-clockwise, from and to the top's
/// opening) goes from y = 0 to `length`; its ends are closed.
inline TriangleMesh block_with_cavity(const Loop2& profile, const glm::dvec2& size, double length) {
  const glm::dvec3 low(0, -2, 0), high(size.x, length + 2.0, size.y);
  SolidBuilder solid;
  solid.box(low, high, {5});
  const auto at = [](const glm::dvec2& point, double y) { return glm::dvec3(point.x, y, point.y); };
  for (std::size_t k = 0; k + 1 < profile.size(); ++k)
    solid.face(
        {at(profile[k], 0), at(profile[k + 1], 0), at(profile[k + 1], length), at(profile[k], length)});
  test::Loop near, far;
  for (const glm::dvec2& point : profile) far.push_back(at(point, length));
  for (auto point = profile.rbegin(); point != profile.rend(); ++point) near.push_back(at(*point, 0));
  solid.face(near);
  solid.face(far);
  const double left = profile.front().x, right = profile.back().x;
  solid.face(box_face(low, high, 5),
             {{{left, 0, size.y}, {right, 0, size.y}, {right, length, size.y}, {left, length, size.y}}});
  return solid.mesh();
}

/// Width of the hook below.
inline constexpr double k_hook_width = 6.0;

/// A box open above, `across` wide, with hooks that stick out by `length` from the wall at x = 2, `ahead`
/// from the wall across; `starts` is where each begins along its wall.
inline TriangleMesh box_with_hooks(double length, double ahead, double across,
                                   const std::vector<double>& starts) {
  const glm::dvec3 in_low(2, 2, 2), in_high(2 + length + ahead, 2 + across, 20);
  const glm::dvec3 low(0, 0, 0), high(in_high.x + 2.0, in_high.y + 2.0, 20);
  SolidBuilder solid;
  solid.box(low, high, {5});
  solid.face(box_face(low, high, 5), {box_face(in_low, in_high, 5)});
  solid.box(in_low, in_high, {0, 5}, true);
  test::Loop wall = box_face(in_low, in_high, 0);
  std::ranges::reverse(wall);
  std::vector<test::Loop> roots;
  for (const double start : starts) {
    const glm::dvec3 hook_low(2, 2 + start, 14), hook_high(2 + length, 2 + start + k_hook_width, 16);
    roots.push_back(box_face(hook_low, hook_high, 0));
    std::ranges::reverse(roots.back());
    solid.box(hook_low, hook_high, {0});
  }
  solid.face(wall, roots);
  return solid.mesh();
}

/// One hook, `beside` from the walls to its sides.
inline TriangleMesh box_with_hook(double length, double ahead, double beside) {
  return box_with_hooks(length, ahead, k_hook_width + 2.0 * beside, {beside});
}

inline TriangleMesh box_with_hook(double length) { return box_with_hook(length, 36.0 - length, 12.0); }

/// The sides at x = 40 and y = 0 of a block 20 high, with holes, and a notch in the edge between, which
/// leaves to either side.
inline void add_notched_sides(SolidBuilder& solid, const std::vector<test::Loop>& at_x,
                              const std::vector<test::Loop>& at_y) {
  solid.face(
      {{40, 0, 0}, {40, 40, 0}, {40, 40, 20}, {40, 0, 20}, {40, 0, 12}, {40, 8, 12}, {40, 8, 8}, {40, 0, 8}},
      at_x);
  solid.face(
      {{0, 0, 0}, {40, 0, 0}, {40, 0, 8}, {32, 0, 8}, {32, 0, 12}, {40, 0, 12}, {40, 0, 20}, {0, 0, 20}},
      at_y);
  solid.box({32, 0, 8}, {40, 8, 12}, {1, 2}, true);
}

/// A block with that notch, and a pocket in the one side or in the other.
inline TriangleMesh block_with_corner_notch(bool pocket_at_x) {
  const glm::dvec3 pocket_low = pocket_at_x ? glm::dvec3(32, 20, 8) : glm::dvec3(12, 0, 8);
  const glm::dvec3 pocket_high = pocket_low + glm::dvec3(8, 8, 4);
  const int side = pocket_at_x ? 1 : 2;
  SolidBuilder solid;
  solid.box({0, 0, 0}, {40, 40, 20}, {1, 2});
  std::vector<test::Loop> at_x, at_y;
  (pocket_at_x ? at_x : at_y).push_back(box_face(pocket_low, pocket_high, side));
  add_notched_sides(solid, at_x, at_y);
  solid.box(pocket_low, pocket_high, {side}, true);
  return solid.mesh();
}

/// A block with that notch; the edge across from it is cut off, by a wall along which the notch leaves, too.
inline TriangleMesh chamfered_block_with_notch() {
  SolidBuilder solid;
  solid.face({{0, 0, 0}, {0, 20, 0}, {20, 40, 0}, {40, 40, 0}, {40, 0, 0}});
  solid.face({{0, 0, 20}, {40, 0, 20}, {40, 40, 20}, {20, 40, 20}, {0, 20, 20}});
  solid.face({{0, 0, 0}, {0, 0, 20}, {0, 20, 20}, {0, 20, 0}});
  solid.face({{20, 40, 0}, {20, 40, 20}, {40, 40, 20}, {40, 40, 0}});
  solid.face({{0, 20, 0}, {0, 20, 20}, {20, 40, 20}, {20, 40, 0}});
  add_notched_sides(solid, {}, {});
  return solid.mesh();
}

/// Thickness of the walls and the floor of the box below.
inline constexpr double k_vented_wall = 5.0;

/// A box open above with a window in each of its four walls, across from each other.
inline TriangleMesh box_with_vents(const glm::dvec2& size = {60, 90}) {
  const glm::dvec3 low(0, 0, 0), high(size, 40), in_low(low + k_vented_wall);
  const glm::dvec3 in_high(size - k_vented_wall, 40);
  SolidBuilder solid;
  solid.box(low, high, {0, 1, 2, 3, 5});
  solid.face(box_face(low, high, 5), {box_face(in_low, in_high, 5)});
  solid.box(in_low, in_high, {0, 1, 2, 3, 5}, true);
  for (const int face : {0, 1, 2, 3}) {
    const int across = face / 2, along = 1 - across;
    glm::dvec3 window_low(0, 0, 15), window_high(0, 0, 23);
    window_low[along] = 0.5 * size[along] - 8.0;
    window_high[along] = 0.5 * size[along] + 8.0;
    window_low[across] = face % 2 == 0 ? low[across] : in_high[across];
    window_high[across] = window_low[across] + k_vented_wall;
    solid.box(window_low, window_high, {2 * across, 2 * across + 1}, true);
    solid.face(box_face(low, high, face), {box_face(window_low, window_high, face)});
    test::Loop inner = box_face(in_low, in_high, face);
    std::ranges::reverse(inner);
    solid.face(inner, {box_face(window_low, window_high, face % 2 == 0 ? face + 1 : face - 1)});
  }
  return solid.mesh();
}

/// A small box with a window in each of two opposite walls, and in one of them another, lower and aside.
inline TriangleMesh box_with_a_window_aside() {
  const glm::dvec3 low(0, 0, 0), high(24, 24, 18), in_low(low + 2.0), in_high(22, 22, 18);
  SolidBuilder solid;
  solid.box(low, high, {0, 1, 5});
  solid.face(box_face(low, high, 5), {box_face(in_low, in_high, 5)});
  solid.box(in_low, in_high, {0, 1, 5}, true);
  for (const bool far : {false, true}) {
    std::vector<std::pair<glm::dvec3, glm::dvec3>> windows = {{{0, 8, 12}, {2, 16, 14}}};
    if (far) windows = {{{22, 8, 12}, {24, 16, 14}}, {{22, 17, 4}, {24, 20, 6}}};
    std::vector<test::Loop> outer, inner;
    for (const auto& [window_low, window_high] : windows) {
      solid.box(window_low, window_high, {0, 1}, true);
      outer.push_back(box_face(window_low, window_high, far ? 1 : 0));
      inner.push_back(box_face(window_low, window_high, far ? 0 : 1));
    }
    solid.face(box_face(low, high, far ? 1 : 0), outer);
    test::Loop wall = box_face(in_low, in_high, far ? 1 : 0);
    std::ranges::reverse(wall);
    solid.face(wall, inner);
  }
  return solid.mesh();
}

/// A tube's end with two flanges: along its axis the space between them is undercut all round.
inline TriangleMesh spool(int sides, double turn_deg) {
  const auto ring = [&](double radius) { return regular_polygon(sides, radius, turn_deg); };
  const auto reversed = [](const Loop2& loop) { return Loop2(loop.rbegin(), loop.rend()); };
  const Loop2 flange = ring(20.0), drum = ring(8.0), bore = ring(4.0);
  SolidBuilder solid;
  solid.face(at_height(reversed(flange), 0.0), {at_height(bore, 0.0)});
  solid.walls(at_height(flange, 0.0), at_height(flange, 3.0));
  solid.face(at_height(flange, 3.0), {at_height(drum, 3.0)});
  solid.walls(at_height(drum, 3.0), at_height(drum, 17.0));
  solid.face(at_height(reversed(flange), 17.0), {at_height(drum, 17.0)});
  solid.walls(at_height(flange, 17.0), at_height(flange, 20.0));
  solid.face(at_height(flange, 20.0), {at_height(bore, 20.0)});
  solid.walls(at_height(reversed(bore), 0.0), at_height(reversed(bore), 20.0));
  return solid.mesh();
}

/// A pocket in either end of a block, and a bore through the wall between, nearer to the lower end.
inline TriangleMesh block_with_pockets_and_bore() {
  const glm::dvec3 low(-14, -12, 0), high(14, 12, 27);
  const Loop2 pocket = {{-10, -8}, {10, -8}, {10, 8}, {-10, 8}}, bore = regular_polygon(24, 3.0);
  const Loop2 in_pocket(pocket.rbegin(), pocket.rend()), in_bore(bore.rbegin(), bore.rend());
  const double under = 3.0, over = 4.5;  // the wall
  SolidBuilder solid;
  solid.box(low, high, {4, 5});
  solid.face(box_face(low, high, 4), {at_height(pocket, low.z)});
  solid.face(box_face(low, high, 5), {at_height(pocket, high.z)});
  solid.walls(at_height(in_pocket, low.z), at_height(in_pocket, under));
  solid.walls(at_height(in_pocket, over), at_height(in_pocket, high.z));
  solid.face(at_height(in_pocket, under), {at_height(bore, under)});
  solid.face(at_height(pocket, over), {at_height(bore, over)});
  solid.walls(at_height(in_bore, under), at_height(in_bore, over));
  return solid.mesh();
}

/// Two pockets in one side of a long block.
inline TriangleMesh block_with_pockets(double apart) {
  const glm::dvec3 low(0, 0, 0), high(40, 40 + apart, 20);
  const glm::dvec3 a_low(20, 10, 5), a_high(40, 20, 15), b_low(20, 20 + apart, 5), b_high(40, 30 + apart, 15);
  SolidBuilder solid;
  solid.box(low, high, {1});
  solid.box(a_low, a_high, {1}, true);
  solid.box(b_low, b_high, {1}, true);
  solid.face(box_face(low, high, 1), {box_face(a_low, a_high, 1), box_face(b_low, b_high, 1)});
  return solid.mesh();
}

}  // namespace moldlight
