#include "parting/lifter_bars.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "mesh/health.hpp"
#include "parting/halves/bodies.hpp"
#include "parting/mold_files.hpp"
#include "parting/slide_blank.hpp"

namespace moldlight {

namespace {

/// An insert with this corner goes.
void take_out(const glm::dvec3& corner, double unit, MoldHalves& put) {
  constexpr double k_same = 1e-4;  // of the unit
  const auto insert = std::ranges::find_if(put.inserts, [&](const MoldBody& body) {
    return body.kind == PieceKind::insert &&
           has_corner(body.mesh.vertices, body.mesh.facets, corner * unit, k_same * unit);
  });
  if (insert == put.inserts.end()) return;
  put.insert_volume -= insert->volume;
  put.written.bodies.erase(put.written.bodies.begin() + 2 + (insert - put.inserts.begin()));
  put.inserts.erase(insert);
}

}  // namespace

std::vector<LiftedInsert> LifterBars::lifted() const {
  std::vector<LiftedInsert> all;
  for (const Bar& bar : bars_) {
    for (const std::size_t insert : bar.inserts) all.push_back(lifted(insert, bar));
  }
  return all;
}

/// The inserts that lifters of its half alone form, this one among them; none, and why, where there are no
/// such.
std::vector<std::size_t> LifterBars::lifted_by(std::size_t lifter, std::string& why) const {
  const auto& actions = plain_.wish.plan.actions;
  std::vector<std::size_t> lifted;
  for (std::size_t k = 0; k < plain_.of_inserts.size(); ++k) {
    const InsertActions& of = plain_.of_inserts[k];
    if (std::ranges::find(of.actions, lifter) == of.actions.end()) continue;
    lifted.push_back(k);
    const bool alone = of.unreleased == 0 && std::ranges::all_of(of.actions, [&](std::size_t action) {
                         return actions[action].kind == ActionKind::lifter &&
                                actions[action].core_side == actions[lifter].core_side;
                       });
    if (!alone) why = "other actions share the surface that it forms";
  }
  if (lifted.empty()) why = "no body between the halves is its own";
  if (actions[lifter].stems.empty()) why = "it has no stem";
  return lifted;
}

LiftedInsert LifterBars::lifted(std::size_t insert, const Bar& bar) const {
  return {plain_.inserts[insert].vertices.front(), core_side(bar)};
}

/// Takes a bar back, and those that form something with it.
void LifterBars::drop(std::size_t number, const std::string& why) {
  std::vector<Bar> left;
  for (const Bar& bar : bars_) {
    const bool shares = std::ranges::any_of(bar.inserts, [&](std::size_t insert) {
      return std::ranges::find(bars_[number].inserts, insert) != bars_[number].inserts.end();
    });
    if (shares) {
      unmade_.push_back({bar.action, why});
    } else {
      left.push_back(bar);
    }
  }
  bars_ = std::move(left);
}

/// Why a lifter cannot be cut out; empty where it was.
std::string LifterBars::put_one(const Bar& bar, std::size_t number, double unit, MoldHalves& put,
                                std::vector<Bounds>& rooms) const {
  TriangleMesh& steel = put.with_lifted[core_side(bar) ? 0 : 1];
  BarRoom room = bar.room;
  for (HalfSpace& side : room.sides) side.offset *= unit;
  auto cut = steel.facets.empty() ? std::nullopt : cut_by_bar(steel, room, unit);
  if (!cut) return "its half does not close around it";
  if (connected_bodies(cut->inside.vertices.size(), cut->inside.facets).size() != 1)
    return "its bar is not of one piece";
  if (std::string why = fault_of(bar, plain_.as_in_part(cut->inside), rooms); !why.empty()) return why;
  MoldBody body = mold_body(std::move(cut->inside));
  body.name = fmt::format("lifter_{}", number);
  body.kind = PieceKind::lifter;
  body.action = bar.action;
  put.insert_volume += body.volume;
  if (!put_body(put, 2 + put.inserts.size(), std::move(body), k_needle * unit, progress_))
    return "facets of it cross each other by rounding";
  steel = std::move(cut->outside);
  return {};
}

/// Why a bar is no lifter: it moves sideways as it is driven out with the part, which is then taken off it.
std::string LifterBars::fault_of(const Bar& bar, TriangleMesh mesh, std::vector<Bounds>& rooms) const {
  const glm::dvec3 travel = plain_.way_of(bar.action), off(0, 0, core_side(bar) ? 1.0 : -1.0);
  const double length = plain_.wish.plan.actions[bar.action].travel / plain_.wish.model.frame.diagonal;
  const WayOut aside = way_out(mesh, plain_.part, travel, length, k_way_slack);
  if (aside.blocked > k_way_slack) return plain_.stands_text("the part", aside.place);
  Bounds room;
  for (glm::dvec3& vertex : mesh.vertices) {
    room.add(vertex);
    vertex += length * travel;
    room.add(vertex);
  }
  if (const WayOut up = way_out(mesh, plain_.part, off, INFINITY, k_way_slack); up.blocked > k_way_slack)
    return plain_.stands_text("the part", up.place);
  if (room.min.x <= plain_.wish.plain.block_low.x || room.min.y <= plain_.wish.plain.block_low.y ||
      room.max.x >= plain_.wish.plain.block_high.x || room.max.y >= plain_.wish.plain.block_high.y)
    return "it would leave the block at its side";
  const bool meets = std::ranges::any_of(rooms, [&](const Bounds& other) {
    return glm::all(glm::lessThan(room.min, other.max)) && glm::all(glm::lessThan(other.min, room.max));
  });
  if (meets) return "it would run into another lifter";
  rooms.push_back(room);
  return {};
}

void LifterBars::add(std::size_t number) {
  constexpr double k_bar_beside = 0.1, k_bar_behind = 0.05;  // of the stem's width, around what it forms
  const SideAction& action = plain_.wish.plan.actions[number];
  std::string why;
  std::vector<std::size_t> inserts = lifted_by(number, why);
  if (!why.empty()) {
    unmade_.push_back({number, std::move(why)});
    return;
  }
  const SheetFrame& frame = plain_.frame;
  const glm::dvec3 travel = plain_.way_of(number), across = glm::cross(glm::dvec3(0, 0, 1), travel),
                   way = plain_.wish.plain.frame.to_mold(action.stems.front().way),
                   down(0, 0, action.core_side ? 1.0 : -1.0);
  const double lean = -glm::dot(way, travel) / glm::dot(way, down);  // back against the travel, downward
  double end = -INFINITY;
  const TriangleMesh half =
      plain_.as_in_part(action.core_side ? plain_.wish.plain.core.mesh : plain_.wish.plain.cavity.mesh);
  for (const glm::dvec3& vertex : half.vertices) end = std::max(end, glm::dot(vertex, down));
  double ahead = -INFINITY, left = INFINITY, right = -INFINITY, back = -INFINITY;
  // Ahead and back are those of its section at the end.
  const auto ahead_of = [&](const glm::dvec3& at) {
    return glm::dot(at, travel) - lean * (end - glm::dot(at, down));
  };
  const auto add = [&](const glm::dvec3& at, double beside) {
    ahead = std::max(ahead, ahead_of(at) + beside);
    left = std::min(left, glm::dot(at, across) - beside);
    right = std::max(right, glm::dot(at, across) + beside);
  };
  const double width = action.stems.front().width / frame.diagonal;
  for (const Stem& stem : action.stems) {
    const glm::dvec3 top = frame.in_mold(stem.top);
    add(top, 0.5 * width);
    back = std::max(back, 0.5 * width - ahead_of(top));
  }
  double slope = lean;
  std::vector<glm::dvec3> formed = plain_.released_by(number);
  if (inserts.size() == 1 && plain_.of_inserts[inserts.front()].actions.size() == 1)
    formed = plain_.inserts[inserts.front()].vertices;
  for (const glm::dvec3& vertex : formed) {
    add(vertex, k_bar_beside * width);
    slope = std::min(
        slope, (back + glm::dot(vertex, travel) - k_bar_behind * width) / (end - glm::dot(vertex, down)));
  }
  const auto side = [](const glm::dvec3& normal, double offset) {
    const double length = glm::length(normal);
    return HalfSpace{normal / length, offset / length};
  };
  bars_.push_back({.action = number,
                   .inserts = std::move(inserts),
                   .room = {.along = way,
                            .sides = {side(-travel - slope * down, back - slope * end), side(-across, -left),
                                      side(travel + lean * down, ahead + lean * end), side(across, right)}}});
}

void LifterBars::give_up(const std::string& why) {
  for (const Bar& bar : bars_) unmade_.push_back({bar.action, why});
  bars_.clear();
}

bool LifterBars::put(MoldHalves& halves) {
  const double unit = plain_.wish.model.frame.diagonal * halves.scale, thinnest = k_needle * unit;
  MoldHalves with = halves;
  for (const Bar& bar : bars_) {
    for (const std::size_t insert : bar.inserts) take_out(lifted(insert, bar).corner, unit, with);
  }
  std::vector<Bounds> rooms;
  for (std::size_t k = 0; k < bars_.size(); ++k) {
    const std::string why = put_one(bars_[k], k + 1, unit, with, rooms);
    if (why.empty()) continue;
    drop(k, why);
    return false;
  }
  for (const std::size_t half : {0U, 1U}) {
    MoldBody body = half == 0 ? with.core : with.cavity;
    if (with.with_lifted[half].facets.empty()) continue;
    body.mesh = with.with_lifted[half];
    body.volume = signed_volume(body.mesh);
    const glm::dvec3 pull(0, 0, half == 0 ? 1.0 : -1.0);
    std::string why;
    if (const WayOut out = way_out(plain_.as_in_part(body.mesh), plain_.part, pull, INFINITY, k_way_slack);
        out.blocked > k_way_slack)
      why = "the bars leave some of what they form to their half";
    if (why.empty() && !put_body(with, half, std::move(body), thinnest, progress_))
      why = "around it its half would cross itself by rounding";
    if (why.empty()) continue;
    drop(static_cast<std::size_t>(
             std::ranges::find_if(bars_, [&](const Bar& bar) { return core_side(bar) == (half == 0); }) -
             bars_.begin()),
         why);
    return false;
  }
  with.volume_gap = with.share_left();
  if (std::abs(with.volume_gap) > k_most_gap_of_pieces) {
    give_up("halves, lifters and part do not fill the block");
    return false;
  }
  with.with_lifted = {};
  set_in_order(with);
  halves = std::move(with);
  return true;
}

}  // namespace moldlight
