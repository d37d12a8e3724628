#include "parting/mold_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "classify/figure_table.hpp"
#include "mesh/health.hpp"
#include "parting/bar_cut.hpp"
#include "parting/halves/bodies.hpp"
#include "parting/halves/depth_columns.hpp"
#include "parting/make_halves.hpp"
#include "parting/mold_files.hpp"
#include "parting/sheet_frame.hpp"
#include "parting/slide_blank.hpp"
#include "parting/swept_out.hpp"

namespace moldlight {

namespace {

constexpr double k_near = 1e-4;  // of the diagonal: corners of the part and of an insert are one

using Cell = std::array<std::int64_t, 3>;

/// The lateral tolerance, in diagonals: what moves out may come so near to what stands still.
constexpr double k_way_slack = 1.0 / 2048.0;
/// A way that leaves the plane across the direction by more, as a sine, is inclined.
constexpr double k_inclined = 1e-3;

/// Land around what a slide forms, in shares of the usual one: the first that goes.
constexpr double k_lands[] = {1.0, 0.3, 0.05};

/// Twice the lateral tolerance may be thick on average what slides that share a body leave to the plastic.
constexpr double k_rest_of_shared = 4.0;

struct Tried {
  SlideBlank blank;
  std::size_t action = 0;
};

/// A lifter's bar, in the mold's frame about the part's centre, in diagonals.
struct Bar {
  std::size_t action = 0;
  std::vector<std::size_t> inserts;  // that it forms, of the halves without slides
  BarRoom room;
};

class PieceMaker {
 public:
  PieceMaker(const PiecesWish& wish, const Progress& progress)
      : wish_(wish),
        progress_(progress),
        part_(in_mold(wish.plain, wish.model.part.mesh, wish.model.frame.diagonal)) {
    for (const MoldBody& insert : wish.plain.inserts) inserts_.push_back(as_in_part(insert.mesh));
    of_plain_ = actions_of_inserts(wish.plain, wish.split, wish.plan);
  }

  MoldPieces run() {
    std::vector<Tried> all;
    for (std::size_t action = 0; action < wish_.plan.actions.size(); ++action) {
      const ActionKind kind = wish_.plan.actions[action].kind;
      if (kind == ActionKind::lifter) add_bar(action);
      if (!is_slide(kind)) continue;
      SlideBlank blank = blank_of(action, k_lands[0]);
      if (blank.refusal.empty()) {
        all.push_back({std::move(blank), action});
      } else {
        unmade_.push_back({action, std::move(blank.refusal)});
      }
    }
    std::string why;
    std::optional<MoldHalves> made = all.empty() ? std::nullopt : attempt(all, why);
    if (made) blanks_ = all;
    for (std::size_t k = 0; k < all.size() && blanks_.size() < all.size(); ++k) {
      if (auto more = with_one_more(all[k])) made = std::move(more);
    }
    if (!made && !bars_.empty()) made = halves_with({});
    while (!bars_.empty() && !put_lifters(*made)) made = halves_with(blanks_);
    MoldPieces pieces{
        .halves = made ? std::move(*made) : wish_.plain, .of_inserts = {}, .unmade = std::move(unmade_)};
    for (MoldBody& body : pieces.halves.inserts) {
      if (!body.blanks.empty()) body.action = blanks_[body.blanks.front()].action;
    }
    pieces.of_inserts = actions_of_inserts(pieces.halves, wish_.split, wish_.plan);
    for (std::size_t k = 0; k < pieces.of_inserts.size(); ++k) {
      const MoldBody& body = pieces.halves.inserts[k];
      if (body.kind != PieceKind::insert) pieces.of_inserts[k] = {.actions = {body.action}, .unreleased = 0};
    }
    std::ranges::sort(pieces.unmade, {}, &UnmadeAction::action);
    return pieces;
  }

 private:
  [[nodiscard]] TriangleMesh as_in_part(const TriangleMesh& body) const {
    return unscaled(wish_.plain, body, wish_.model.frame.diagonal);
  }
  [[nodiscard]] glm::dvec3 way_of(std::size_t action) const {
    glm::dvec3 way = wish_.plain.frame.to_mold(wish_.plan.actions[action].direction);
    way.z = 0.0;
    for (const int axis : {0, 1}) {
      if (std::abs(way[axis]) < k_inclined) way[axis] = 0.0;
    }
    return glm::normalize(way);
  }

  /// The inserts that lifters of its half alone form, this one among them; none, and why, where there are no
  /// such.
  [[nodiscard]] std::vector<std::size_t> lifted_by(std::size_t lifter, std::string& why) const {
    const auto& actions = wish_.plan.actions;
    std::vector<std::size_t> lifted;
    for (std::size_t k = 0; k < of_plain_.size(); ++k) {
      const InsertActions& of = of_plain_[k];
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

  /// Corners of what an action releases, in the mold's frame about the part's centre, in diagonals.
  [[nodiscard]] std::vector<glm::dvec3> released_by(std::size_t action) const {
    const SheetFrame frame{wish_.plain.frame, wish_.plain.centre, wish_.model.frame.diagonal};
    std::vector<glm::dvec3> corners;
    for (std::size_t piece = 0; piece < wish_.split.pieces.size(); ++piece) {
      if (wish_.plan.action_of_piece[piece] != static_cast<std::int32_t>(action)) continue;
      for (std::size_t k = 0; k < 3; ++k) corners.push_back(frame.in_mold(wish_.split.corner(piece, k)));
    }
    return corners;
  }

  /// A straight bar along the lifter's stem, as wide as it and as what it forms; towards its end on the side
  /// of that it narrows to the stem, so that it stands in the part's wall there, not behind it.
  void add_bar(std::size_t number) {
    constexpr double k_bar_beside = 0.1, k_bar_behind = 0.05;  // of the stem's width, around what it forms
    const SideAction& action = wish_.plan.actions[number];
    std::string why;
    std::vector<std::size_t> inserts = lifted_by(number, why);
    if (!why.empty()) {
      unmade_.push_back({number, std::move(why)});
      return;
    }
    const SheetFrame frame{wish_.plain.frame, wish_.plain.centre, wish_.model.frame.diagonal};
    const glm::dvec3 travel = way_of(number), across = glm::cross(glm::dvec3(0, 0, 1), travel),
                     way = wish_.plain.frame.to_mold(action.stems.front().way),
                     down(0, 0, action.core_side ? 1.0 : -1.0);
    const double lean = -glm::dot(way, travel) / glm::dot(way, down);  // back against the travel, downward
    double end = -INFINITY;
    const TriangleMesh half = as_in_part(action.core_side ? wish_.plain.core.mesh : wish_.plain.cavity.mesh);
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
    std::vector<glm::dvec3> formed = released_by(number);
    if (inserts.size() == 1 && of_plain_[inserts.front()].actions.size() == 1)
      formed = inserts_[inserts.front()].vertices;
    for (const glm::dvec3& vertex : formed) {
      add(vertex, k_bar_beside * width);
      slope = std::min(
          slope, (back + glm::dot(vertex, travel) - k_bar_behind * width) / (end - glm::dot(vertex, down)));
    }
    const auto side = [](const glm::dvec3& normal, double offset) {
      const double length = glm::length(normal);
      return HalfSpace{normal / length, offset / length};
    };
    bars_.push_back(
        {.action = number,
         .inserts = std::move(inserts),
         .room = {.along = way,
                  .sides = {side(-travel - slope * down, back - slope * end), side(-across, -left),
                            side(travel + lean * down, ahead + lean * end), side(across, right)}}});
  }

  [[nodiscard]] bool core_side(const Bar& bar) const { return wish_.plan.actions[bar.action].core_side; }
  [[nodiscard]] LiftedInsert lifted(std::size_t insert, const Bar& bar) const {
    return {inserts_[insert].vertices.front(), core_side(bar)};
  }

  /// Takes a bar back, and those that form something with it.
  void drop_bar(std::size_t number, const std::string& why) {
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

  /// Cuts the lifters out of their halves. False, and some bars less, where one cannot be.
  bool put_lifters(MoldHalves& halves) {
    const double unit = wish_.model.frame.diagonal * halves.scale, thinnest = k_needle * unit;
    MoldHalves put = halves;
    for (const Bar& bar : bars_) {
      for (const std::size_t insert : bar.inserts) take_out(lifted(insert, bar).corner * unit, put);
    }
    std::vector<Bounds> rooms;
    for (std::size_t k = 0; k < bars_.size(); ++k) {
      const std::string why = put_lifter(bars_[k], k + 1, unit, put, rooms);
      if (why.empty()) continue;
      drop_bar(k, why);
      return false;
    }
    for (const std::size_t half : {0U, 1U}) {
      MoldBody body = half == 0 ? put.core : put.cavity;
      if (put.with_lifted[half].facets.empty()) continue;
      body.mesh = put.with_lifted[half];
      body.volume = signed_volume(body.mesh);
      const glm::dvec3 pull(0, 0, half == 0 ? 1.0 : -1.0);
      std::string why;
      if (const WayOut out = way_out(as_in_part(body.mesh), part_, pull, INFINITY, k_way_slack);
          out.blocked > k_way_slack)
        why = "the bars leave some of what they form to their half";
      if (why.empty() && !put_body(put, half, std::move(body), thinnest, progress_))
        why = "around it its half would cross itself by rounding";
      if (why.empty()) continue;
      drop_bar(
          static_cast<std::size_t>(
              std::ranges::find_if(bars_, [&](const Bar& bar) { return core_side(bar) == (half == 0); }) -
              bars_.begin()),
          why);
      return false;
    }
    set_in_order(put);
    halves = std::move(put);
    return true;
  }

  /// An insert with this corner goes.
  static void take_out(const glm::dvec3& corner, MoldHalves& put) {
    constexpr double k_same = 1e-6;
    const auto insert = std::ranges::find_if(put.inserts, [&](const MoldBody& body) {
      return body.kind == PieceKind::insert &&
             std::ranges::any_of(body.mesh.vertices, [&](const glm::dvec3& vertex) {
               return glm::distance(vertex, corner) < k_same * glm::length(corner);
             });
    });
    if (insert == put.inserts.end()) return;
    put.insert_volume -= insert->volume;
    put.written.bodies.erase(put.written.bodies.begin() + 2 + (insert - put.inserts.begin()));
    put.inserts.erase(insert);
  }

  /// Slides, lifters, inserts.
  static void set_in_order(MoldHalves& put) {
    std::vector<std::size_t> order(put.inserts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return put.inserts[k].kind; });
    std::vector<MoldBody> bodies;
    std::vector<WrittenBody> written = {put.written.bodies[0], put.written.bodies[1]};
    for (const std::size_t k : order) {
      bodies.push_back(std::move(put.inserts[k]));
      written.push_back(std::move(put.written.bodies[k + 2]));
    }
    put.inserts = std::move(bodies);
    put.written.bodies = std::move(written);
    std::size_t loose = 0;
    for (std::size_t k = 0; k < put.inserts.size(); ++k) {
      if (put.inserts[k].kind != PieceKind::insert) continue;
      put.inserts[k].name = put.written.bodies[k + 2].name = fmt::format("insert_{}", ++loose);
    }
  }

  /// Why a lifter cannot be cut out; empty where it was.
  std::string put_lifter(const Bar& bar, std::size_t number, double unit, MoldHalves& put,
                         std::vector<Bounds>& rooms) const {
    TriangleMesh& steel = put.with_lifted[core_side(bar) ? 0 : 1];
    BarRoom room = bar.room;
    for (HalfSpace& side : room.sides) side.offset *= unit;
    auto cut = steel.facets.empty() ? std::nullopt : cut_by_bar(steel, room, unit);
    if (!cut) return "its half does not close around it";
    if (connected_bodies(cut->inside.vertices.size(), cut->inside.facets).size() != 1)
      return "its bar is not of one piece";
    if (std::string why = fault_of_bar(bar, as_in_part(cut->inside), rooms); !why.empty()) return why;
    MoldBody body{.mesh = std::move(cut->inside),
                  .name = fmt::format("lifter_{}", number),
                  .kind = PieceKind::lifter,
                  .action = bar.action};
    body.volume = signed_volume(body.mesh);
    body.thinnest = thinnest_of(body.mesh);
    put.insert_volume += body.volume;
    if (!put_body(put, 2 + put.inserts.size(), std::move(body), k_needle * unit, progress_))
      return "facets of it cross each other by rounding";
    steel = std::move(cut->outside);
    return {};
  }

  /// Why a bar is no lifter: it moves sideways as it is driven out with the part, which is then taken off it.
  [[nodiscard]] std::string fault_of_bar(const Bar& bar, TriangleMesh mesh,
                                         std::vector<Bounds>& rooms) const {
    const glm::dvec3 travel = way_of(bar.action), off(0, 0, core_side(bar) ? 1.0 : -1.0);
    const double length = wish_.plan.actions[bar.action].travel / wish_.model.frame.diagonal;
    const auto stands = [&](const WayOut& out) {
      return fmt::format(
          "the part stands in its way, near {}",
          FigureStyle(wish_.model)
              .point(wish_.plain.centre + wish_.model.frame.diagonal * wish_.plain.frame.to_part(out.place)));
    };
    const WayOut aside = way_out(mesh, part_, travel, length, k_way_slack);
    if (aside.blocked > k_way_slack) return stands(aside);
    Bounds room;
    for (glm::dvec3& vertex : mesh.vertices) {
      room.add(vertex);
      vertex += length * travel;
      room.add(vertex);
    }
    if (const WayOut up = way_out(mesh, part_, off, INFINITY, k_way_slack); up.blocked > k_way_slack)
      return stands(up);
    if (room.min.x <= wish_.plain.block_low.x || room.min.y <= wish_.plain.block_low.y ||
        room.max.x >= wish_.plain.block_high.x || room.max.y >= wish_.plain.block_high.y)
      return "it would leave the block at its side";
    const bool meets = std::ranges::any_of(rooms, [&](const Bounds& other) {
      return glm::all(glm::lessThan(room.min, other.max)) && glm::all(glm::lessThan(other.min, room.max));
    });
    if (meets) return "it would run into another lifter";
    rooms.push_back(room);
    return {};
  }

  /// With this share of the usual land around what the action forms.
  [[nodiscard]] SlideBlank blank_of(std::size_t number, double land) const {
    const auto refused = [](std::string why) {
      SlideBlank none;
      none.refusal = std::move(why);
      return none;
    };
    const SideAction& action = wish_.plan.actions[number];
    if (std::abs(wish_.plain.frame.to_mold(action.direction).z) > k_inclined)
      return refused("it moves at an angle to the plane across the direction");
    std::vector<const TriangleMesh*> inserts;
    bool alone = true;
    for (std::size_t k = 0; k < of_plain_.size(); ++k) {
      const InsertActions& of = of_plain_[k];
      if (std::ranges::find(of.actions, number) == of.actions.end()) continue;
      inserts.push_back(&inserts_[k]);
      alone = alone && of.actions.size() == 1 && of.unreleased == 0;
    }
    if (inserts.empty()) return refused("no body between the halves is its own");
    std::vector<glm::dvec3> formed;
    if (alone) {
      for (const TriangleMesh* insert : inserts)
        formed.insert(formed.end(), insert->vertices.begin(), insert->vertices.end());
    } else {
      formed = released_by(number);
    }
    const double middle = glm::dot(wish_.plain.centre, wish_.plain.frame.z);
    const double diagonal = wish_.model.frame.diagonal;
    return slide_blank({.part = part_,
                        .inserts = inserts,
                        .formed = formed,
                        .alone = alone,
                        .way = way_of(number),
                        .shelf = (wish_.plain.surface.shelf_height - middle) / diagonal,
                        .land = land * wish_.plain.land / diagonal,
                        .low = wish_.plain.block_low,
                        .high = wish_.plain.block_high});
  }

  /// The halves with a slide more than there are, with as much land as goes.
  std::optional<MoldHalves> with_one_more(const Tried& one) {
    std::string why;
    for (const double land : k_lands) {
      SlideBlank blank = blank_of(one.action, land);
      if (!blank.refusal.empty()) continue;
      std::vector<Tried> more = blanks_;
      more.push_back({std::move(blank), one.action});
      auto made = attempt(more, why);
      if (!made) continue;
      blanks_ = std::move(more);
      return made;
    }
    unmade_.push_back({one.action, std::move(why)});
    return std::nullopt;
  }

  [[nodiscard]] MoldHalves halves_with(const std::vector<Tried>& tried) const {
    Beside beside{{}, {}, wish_.plain.block_low, wish_.plain.block_high, wish_.plain.margin};
    for (const Tried& one : tried) beside.blanks.push_back(one.blank);
    for (const Bar& bar : bars_) {
      for (const std::size_t insert : bar.inserts) beside.lifted.push_back(lifted(insert, bar));
    }
    return make_halves(wish_.model, wish_.plain.frame.z, wish_.place, wish_.settings, progress_, beside);
  }

  /// Nothing, and why, where the halves with these blanks or one of the slides is not as it should be.
  [[nodiscard]] std::optional<MoldHalves> attempt(const std::vector<Tried>& tried, std::string& why) const {
    MoldHalves halves = halves_with(tried);
    if (!halves.made() || (!halves.certified() && wish_.plain.certified())) {
      why = halves.made() ? "around it the halves would cross themselves by rounding"
                          : "the halves cannot be made around it: " + halves.refusal;
      return std::nullopt;
    }
    why = divide_shared(tried, halves);
    if (!why.empty()) return std::nullopt;
    for (std::size_t k = 0; k < tried.size(); ++k) {
      why = fault_of(halves, tried, k);
      if (!why.empty()) return std::nullopt;
    }
    return halves;
  }

  /// Gives each slide of a body that several actions form what it can take out with it, the one that releases
  /// the most first; what is left is inserts. Why that cannot be; empty where it can.
  [[nodiscard]] std::string divide_shared(const std::vector<Tried>& tried, MoldHalves& halves) const {
    const double unit = wish_.model.frame.diagonal * halves.scale;
    std::vector<std::size_t> shared;
    const std::vector<InsertActions> of = actions_of_inserts(halves, wish_.split, wish_.plan);
    for (std::size_t k = 0; k < halves.inserts.size(); ++k) {
      if (!halves.inserts[k].blanks.empty() && (of[k].actions.size() > 1 || of[k].unreleased > 0))
        shared.push_back(k);
    }
    for (const std::size_t number : shared) {
      std::vector<std::size_t> blanks = halves.inserts[number].blanks;
      std::ranges::stable_sort(blanks, std::greater(), [&](std::size_t blank) {
        return wish_.plan.actions[tried[blank].action].area;
      });
      std::vector<TriangleMesh> rest = {as_in_part(halves.inserts[number].mesh)};
      std::vector<MoldBody> made;
      const auto as_body = [&](TriangleMesh mesh) {
        for (glm::dvec3& vertex : mesh.vertices) vertex *= unit;
        MoldBody body{.mesh = std::move(mesh), .name = "insert"};
        body.volume = signed_volume(body.mesh);
        body.thinnest = thinnest_of(body.mesh);
        return body;
      };
      for (const std::size_t blank : blanks) {
        std::vector<TriangleMesh> left;
        bool found = false;
        for (const TriangleMesh& body : rest) {
          std::optional<SweptOut> swept;
          if (!found) swept = swept_out(body, tried[blank].blank, way_of(tried[blank].action), progress_);
          if (!swept) {
            left.push_back(body);
            continue;
          }
          found = true;
          left.insert(left.end(), swept->left.begin(), swept->left.end());
          made.push_back(as_body(std::move(swept->moved)));
          made.back().kind = PieceKind::slide;
          made.back().blanks = {blank};
          made.back().name = fmt::format("slide_{}", blank + 1);
        }
        if (!found) return "what it forms with other actions cannot be divided";
        rest = std::move(left);
      }
      // What is too thin for an insert the plastic fills.
      for (TriangleMesh& mesh : rest) {
        MoldBody body = as_body(std::move(mesh));
        if (is_speck(body, k_rest_of_shared * unit)) {
          halves.specks_volume += body.volume;
        } else {
          made.push_back(std::move(body));
        }
      }
      for (std::size_t k = 0; k < made.size(); ++k) {
        const std::size_t place = k == 0 ? number : halves.inserts.size();
        if (!put_body(halves, 2 + place, std::move(made[k]), k_needle * unit, progress_))
          return "facets of it cross each other by rounding";
      }
    }
    if (!shared.empty()) set_in_order(halves);
    return {};
  }

  /// Why a slide is none; empty where it is closed and clean, and moves out past what stands still.
  [[nodiscard]] std::string fault_of(const MoldHalves& halves, const std::vector<Tried>& tried,
                                     std::size_t blank) const {
    const auto piece = std::ranges::find_if(halves.inserts, [&](const MoldBody& body) {
      return std::ranges::find(body.blanks, blank) != body.blanks.end();
    });
    if (piece == halves.inserts.end()) return "nothing of it is left beside the part";
    if (piece->blanks.size() > 1) return "it runs into another slide";
    const std::size_t number = static_cast<std::size_t>(piece - halves.inserts.begin());
    const TriangleMesh mesh = as_in_part(piece->mesh);
    const glm::dvec3 way = way_of(tried[blank].action);
    std::string in_way;
    const auto looked_at = [&](const TriangleMesh& still, std::string_view name) {
      const WayOut out = way_out(mesh, still, way, INFINITY, k_way_slack);
      if (out.blocked <= k_way_slack || !in_way.empty()) return;
      const glm::dvec3 place =
          wish_.plain.centre + wish_.model.frame.diagonal * wish_.plain.frame.to_part(out.place);
      in_way = fmt::format("{} stands in its way, near {}", name, FigureStyle(wish_.model).point(place));
    };
    looked_at(part_, "the part");
    looked_at(as_in_part(halves.core.mesh), "the core");
    looked_at(as_in_part(halves.cavity.mesh), "the cavity");
    for (std::size_t k = 0; k < halves.inserts.size(); ++k) {
      if (k != number)
        looked_at(as_in_part(halves.inserts[k].mesh),
                  halves.inserts[k].blanks.empty() ? "an insert" : "another slide");
    }
    if (!in_way.empty()) return in_way;
    if (piece->crossed_facets > 0) return "facets of it cross each other by rounding";
    return {};
  }

  const PiecesWish& wish_;
  const Progress& progress_;
  TriangleMesh part_;
  std::vector<TriangleMesh> inserts_;
  std::vector<InsertActions> of_plain_;
  std::vector<Tried> blanks_;
  std::vector<Bar> bars_;
  std::vector<UnmadeAction> unmade_;
};

}  // namespace

std::vector<InsertActions> actions_of_inserts(const MoldHalves& halves, const SplitMesh& split,
                                              const ActionPlan& plan) {
  std::vector<InsertActions> found(halves.inserts.size());
  if (halves.inserts.empty()) return found;
  Bounds box;
  for (const glm::dvec3& vertex : split.vertices) box.add(vertex);
  const double cell = k_near * box.diagonal();
  // Each corner of an insert is in the cell where it lies and in those that it is near to.
  std::map<Cell, std::set<std::size_t>> inserts_at;
  for (std::size_t k = 0; k < halves.inserts.size(); ++k) {
    for (const glm::dvec3& vertex : halves.inserts[k].mesh.vertices) {
      const glm::dvec3 at = vertex / halves.scale / cell;
      for (int around = 0; around < 8; ++around) {
        Cell place{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double offset = (around >> axis & 1) != 0 ? 0.25 : -0.25;
          place[axis] = static_cast<std::int64_t>(std::floor(at[static_cast<int>(axis)] + offset));
        }
        inserts_at[place].insert(k);
      }
    }
  }
  for (std::size_t undercut = 0; undercut < plan.undercuts.size(); ++undercut) {
    std::map<std::size_t, std::size_t> corners;
    for (const std::uint32_t piece : plan.undercuts[undercut].undercut.pieces) {
      for (const VertexIndex vertex : split.pieces[piece].corners) {
        const glm::dvec3 at = halves.frame.to_mold(split.vertices[vertex] - halves.centre) / cell;
        Cell place{};
        for (std::size_t axis = 0; axis < 3; ++axis)
          place[axis] = static_cast<std::int64_t>(std::floor(at[static_cast<int>(axis)]));
        const auto here = inserts_at.find(place);
        if (here == inserts_at.end()) continue;
        for (const std::size_t insert : here->second) ++corners[insert];
      }
    }
    const auto most = std::ranges::max_element(corners, {}, [](const auto& entry) { return entry.second; });
    if (most == corners.end()) continue;
    InsertActions& insert = found[most->first];
    if (std::ranges::find(plan.unreleased, undercut) != plan.unreleased.end()) ++insert.unreleased;
    for (std::size_t action = 0; action < plan.actions.size(); ++action) {
      const auto& undercuts = plan.actions[action].undercuts;
      if (std::ranges::find(undercuts, undercut) != undercuts.end()) insert.actions.push_back(action);
    }
  }
  for (InsertActions& insert : found) {
    std::ranges::sort(insert.actions);
    insert.actions.erase(std::unique(insert.actions.begin(), insert.actions.end()), insert.actions.end());
  }
  return found;
}

MoldPieces make_pieces(const PiecesWish& wish, const Progress& progress) {
  if (!wish.plain.made()) return {.halves = wish.plain, .of_inserts = {}, .unmade = {}};
  return PieceMaker(wish, progress).run();
}

}  // namespace moldlight
