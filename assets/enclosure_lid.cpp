// The open side looks up (+z): the core forms the inside, the cavity the outside.
#include "demo_parts.hpp"
#include "modelling.hpp"

namespace moldlight::demo {
namespace {

constexpr double k_lid_height = 22.0, k_wall = 2.0, k_floor = 2.0, k_draft_deg = 1.5;

TopoDS_Shape shell() {
  const Rectangle outside{.width = 84.0, .depth = 56.0, .radius = 8.0}, inside = grown(outside, -k_wall);
  const TopoDS_Shape body =
      rounded(drafted_block(outside, 0.0, k_lid_height, k_draft_deg), 2.5, edges_at_height(0.0));
  const TopoDS_Shape hollow =
      rounded(drafted_block(inside, k_floor, k_lid_height + 1.0, k_draft_deg), 1.2, edges_at_height(k_floor));
  // A groove along the rim takes the lip of the other half.
  const TopoDS_Shape groove =
      drafted_block(grown(inside, 1.35), k_lid_height - 1.6, k_lid_height + 1.0, k_draft_deg);
  return cut(body, {hollow, groove});
}

std::vector<TopoDS_Shape> ribs() {
  std::vector<TopoDS_Shape> ribs;
  for (const double x : {-27.0, -13.5, 13.5, 27.0}) {
    ribs.push_back(drafted_block({.x = x, .width = 1.5, .depth = 53.0}, 1.0, 7.5, -1.0));
  }
  for (const double y : {-13.0, 13.0}) {
    ribs.push_back(drafted_block({.y = y, .width = 81.0, .depth = 1.5}, 1.0, 6.0, -1.0));
  }
  return ribs;
}

template <typename Visit>
void at_bosses(Visit visit) {
  for (const double x : {-33.0, 33.0}) {
    for (const double y : {-20.0, 20.0}) visit(x, y);
  }
}

/// A spring hook along the long wall at side = +1 or -1: its catch looks outward, over the rim.
TopoDS_Shape snap_hook(double x, double side) {
  constexpr double k_width = 9.0;
  const auto at = [&](double y, double z) { return gp_Pnt(x - 0.5 * k_width, side * y, z); };
  return prism({at(21.0, 1.0), at(23.0, 1.0), at(23.0, 23.2), at(25.4, 23.2), at(25.4, 24.2), at(23.0, 28.0),
                at(21.6, 28.0)},
               gp_Vec(k_width, 0.0, 0.0));
}

/// What the two revisions differ in.
struct Revision {
  double connector_width = 15.0;
  double boss_shift = 0.0;        // of one screw boss, along x
  bool window_at_corner = false;  // below the hook at x = 20, y < 0, too
};

TopoDS_Shape lid(const Revision& revision) {
  std::vector<TopoDS_Shape> added = ribs(), removed;
  at_bosses([&](double x, double y) {
    if (x > 0.0 && y > 0.0) x -= revision.boss_shift;
    added.push_back(pin(x, y, 1.0, 15.0, 3.9, -1.0));
    // Webs to the walls.
    added.push_back(
        drafted_block({.x = x > 0 ? x + 4.0 : x - 4.0, .y = y, .width = 7.5, .depth = 1.3}, 1.0, 12.0, -1.0));
    removed.push_back(pin(x, y, 4.0, 15.5, 1.35, 0.5));
  });
  for (const double x : {-20.0, 20.0}) {
    for (const double side : {-1.0, 1.0}) added.push_back(snap_hook(x, side));
  }
  // Windows under the two hooks of one side let the cavity half form their catches.
  for (const double x : {-20.0, 20.0}) {
    removed.push_back(drafted_block({.x = x, .y = 24.2, .width = 9.4, .depth = 2.6}, -1.0, 3.5, 0.0));
  }
  if (revision.window_at_corner)
    removed.push_back(drafted_block({.x = 20.0, .y = -24.2, .width = 9.4, .depth = 2.6}, -1.0, 3.5, 0.0));
  for (const double x : {-7.5, -4.5, -1.5, 1.5, 4.5, 7.5}) {
    removed.push_back(drafted_block({.x = x, .width = 1.5, .depth = 17.0, .radius = 0.7}, -1.0, 3.5, 1.0));
  }
  // A connector's window through the short wall: a side action, or undercut.
  const TopoDS_Shape upright =
      drafted_block({.width = revision.connector_width, .depth = 7.0, .radius = 1.8}, 0.0, 8.0, 0.0);
  removed.push_back(moved(upright, gp_Pnt(-46.0, 0.0, 12.5), gp_Dir(1, 0, 0), gp_Dir(0, 1, 0)));
  return cut(fused(shell(), added), removed);
}

}  // namespace

TopoDS_Shape enclosure_lid() { return lid({}); }

TopoDS_Shape enclosure_lid_b() {
  return lid({.connector_width = 18.0, .boss_shift = 2.0, .window_at_corner = true});
}

}  // namespace moldlight::demo
