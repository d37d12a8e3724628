#include "parting/mold_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "parting/lifter_bars.hpp"
#include "parting/make_halves.hpp"
#include "parting/mold_files.hpp"
#include "parting/pin_bars.hpp"
#include "parting/plain_mold.hpp"
#include "parting/slide_blank.hpp"
#include "parting/swept_out.hpp"

namespace moldlight {

namespace {

/// Land around what a slide forms, in shares of the usual one: the first that goes.
constexpr double k_lands[] = {1.0, 0.3, 0.05};

struct Tried {
  SlideBlank blank;
  std::size_t action = 0;
};

class PieceMaker {
 public:
  /// `divides`: whether round walls may be divided.
  PieceMaker(const PiecesWish& wish, bool divides, const Progress& progress)
      : plain_(wish), divides_(divides), progress_(progress) {}

  MoldPieces run() {
    std::vector<Tried> all;
    for (std::size_t action = 0; action < plain_.wish.plan.actions.size(); ++action) {
      const ActionKind kind = plain_.wish.plan.actions[action].kind;
      if (kind == ActionKind::lifter) bars_.add(action);
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
    while (!bars_.empty() && !bars_.put(*made)) {
      auto again = attempt(blanks_, why);
      if (!again) bars_.give_up(why);
      if (again) made = std::move(again);
    }
    MoldPieces pieces{.halves = made ? std::move(*made) : plain_.wish.plain, .of_inserts = {}, .unmade = {}};
    pins_instead(pieces.halves);
    pieces.unmade = std::move(unmade_);
    for (MoldBody& body : pieces.halves.inserts) {
      if (!body.blanks.empty()) body.action = blanks_[body.blanks.front()].action;
    }
    pieces.of_inserts = actions_of_inserts(pieces.halves, plain_.wish.split, plain_.wish.plan);
    for (std::size_t k = 0; k < pieces.of_inserts.size(); ++k) {
      const MoldBody& body = pieces.halves.inserts[k];
      if (body.kind != PieceKind::insert) pieces.of_inserts[k] = {.actions = {body.action}, .unreleased = 0};
    }
    std::ranges::sort(pieces.unmade, {}, &UnmadeAction::action);
    return pieces;
  }

 private:
  /// Slides that could not be made as blocks are pins, where they are straight.
  void pins_instead(MoldHalves& halves) {
    if (!halves.made()) return;
    std::vector<UnmadeAction> left;
    for (UnmadeAction& unmade : unmade_) {
      const SideAction& action = plain_.wish.plan.actions[unmade.action];
      std::string why = "no pin";
      for (const bool stepped : {false, true}) {
        for (const bool with_skins : {true, false}) {
          // Where one runs along an edge of a half by rounding, a wider one may not.
          for (const double fit : {1.0, 1.7}) {
            if (why.empty() || !is_slide(action.kind)) continue;
            const std::vector<BarRoom> rooms = pins_of(unmade.action, with_skins, fit, stepped);
            if (!rooms.empty()) why = put_pins(plain_, unmade.action, rooms, halves, progress_);
          }
        }
      }
      if (!why.empty()) left.push_back(std::move(unmade));
    }
    unmade_ = std::move(left);
  }

  [[nodiscard]] std::vector<BarRoom> pins_of(std::size_t number, bool with_skins, double fit,
                                             bool stepped) const {
    const glm::dvec3 way = plain_.wish.plain.frame.to_mold(plain_.wish.plan.actions[number].direction);
    PinWish wish{.inserts = {},
                 .formed = {},
                 .beside = false,
                 .way = std::abs(way.z) > k_inclined ? glm::normalize(way) : plain_.way_of(number),
                 .land = plain_.wish.plain.land / plain_.wish.model.frame.diagonal,
                 .fit = fit,
                 .stepped = stepped};
    bool alone = true;
    forming(number, wish.inserts, alone);
    wish.beside = !with_skins && alone;
    wish.formed = formed_by(number, wish.inserts, alone && with_skins);
    if (wish.formed.empty() || (!with_skins && !alone)) return {};
    return pin_rooms(plain_.part, wish);
  }

  /// The bodies between the halves without slides that it forms something of, and whether nothing else does.
  void forming(std::size_t number, std::vector<const TriangleMesh*>& inserts, bool& alone) const {
    for (std::size_t k = 0; k < plain_.of_inserts.size(); ++k) {
      const InsertActions& of = plain_.of_inserts[k];
      if (std::ranges::find(of.actions, number) == of.actions.end()) continue;
      inserts.push_back(&plain_.inserts[k]);
      alone = alone && of.actions.size() == 1 && of.unreleased == 0;
    }
  }
  [[nodiscard]] std::vector<glm::dvec3> formed_by(std::size_t number,
                                                  const std::vector<const TriangleMesh*>& inserts,
                                                  bool alone) const {
    if (!alone) return plain_.released_by(number);
    std::vector<glm::dvec3> formed;
    for (const TriangleMesh* insert : inserts)
      formed.insert(formed.end(), insert->vertices.begin(), insert->vertices.end());
    return formed;
  }

  /// With this share of the usual land around what the action forms.
  [[nodiscard]] SlideBlank blank_of(std::size_t number, double land) const {
    const auto refused = [](std::string why) {
      SlideBlank none;
      none.refusal = std::move(why);
      return none;
    };
    const SideAction& action = plain_.wish.plan.actions[number];
    if (std::abs(plain_.wish.plain.frame.to_mold(action.direction).z) > k_inclined)
      return refused("it moves at an angle to the plane across the direction");
    std::vector<const TriangleMesh*> inserts;
    bool alone = true;
    forming(number, inserts, alone);
    if (inserts.empty()) return refused("no body between the halves is its own");
    const double middle = glm::dot(plain_.wish.plain.centre, plain_.wish.plain.frame.z);
    const double diagonal = plain_.wish.model.frame.diagonal;
    const auto blank = [&](bool whole) {
      return slide_blank({.part = plain_.part,
                          .inserts = inserts,
                          .formed = formed_by(number, inserts, whole),
                          .alone = whole,
                          .way = plain_.way_of(number),
                          .shelf = (plain_.wish.plain.surface.shelf_height - middle) / diagonal,
                          .land = land * plain_.wish.plain.land / diagonal,
                          .low = plain_.wish.plain.block_low,
                          .high = plain_.wish.plain.block_high});
    };
    SlideBlank made = blank(alone);
    // Skins on walls beside what it releases it need not form.
    return alone && !made.refusal.empty() ? blank(false) : made;
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
    Beside beside{{},
                  bars_.lifted(),
                  plain_.wish.plain.block_low,
                  plain_.wish.plain.block_high,
                  plain_.wish.plain.margin,
                  divides_,
                  plain_.wish.plain.contact_area};
    for (const Tried& one : tried) beside.blanks.push_back(one.blank);
    return make_halves(plain_.wish.model, plain_.wish.plain.frame.z, plain_.wish.place, plain_.wish.settings,
                       progress_, beside);
  }

  /// Nothing, and why, where the halves with these blanks or one of the slides is not as it should be.
  [[nodiscard]] std::optional<MoldHalves> attempt(const std::vector<Tried>& tried, std::string& why) const {
    MoldHalves halves = halves_with(tried);
    if (!halves.made() || (!halves.certified() && plain_.wish.plain.certified())) {
      why = halves.made() ? "around it the halves would cross themselves by rounding"
                          : "the halves cannot be made around it: " + halves.refusal;
      return std::nullopt;
    }
    if (loose_of(halves) > loose_of(plain_.wish.plain)) {
      why = "it would come out of the part beside what it forms";
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

  /// Bodies between the halves, no slides, on which there is no undercut: what a blank cuts off where it
  /// comes out of the part.
  [[nodiscard]] std::size_t loose_of(const MoldHalves& halves) const {
    const std::vector<InsertActions> of = actions_of_inserts(halves, plain_.wish.split, plain_.wish.plan);
    std::size_t loose = 0;
    for (std::size_t k = 0; k < of.size(); ++k)
      loose += halves.inserts[k].blanks.empty() && of[k].actions.empty() && of[k].unreleased == 0 ? 1 : 0;
    return loose;
  }

  /// Gives each slide of a body that several actions form what it can take out with it, the one that releases
  /// the most first; what is left is inserts. Why that cannot be; empty where it can.
  [[nodiscard]] std::string divide_shared(const std::vector<Tried>& tried, MoldHalves& halves) const {
    const double unit = plain_.wish.model.frame.diagonal * halves.scale;
    std::vector<std::size_t> shared;
    const std::vector<InsertActions> of = actions_of_inserts(halves, plain_.wish.split, plain_.wish.plan);
    for (std::size_t k = 0; k < halves.inserts.size(); ++k) {
      if (!halves.inserts[k].blanks.empty() && (of[k].actions.size() > 1 || of[k].unreleased > 0))
        shared.push_back(k);
    }
    for (const std::size_t number : shared) {
      std::vector<std::size_t> blanks = halves.inserts[number].blanks;
      std::ranges::stable_sort(blanks, std::greater(), [&](std::size_t blank) {
        return plain_.wish.plan.actions[tried[blank].action].area;
      });
      std::vector<TriangleMesh> rest = {plain_.as_in_part(halves.inserts[number].mesh)};
      std::vector<MoldBody> made;
      for (const std::size_t blank : blanks) {
        std::vector<TriangleMesh> left;
        bool found = false;
        for (const TriangleMesh& body : rest) {
          std::optional<SweptOut> swept;
          if (!found)
            swept = swept_out(body, tried[blank].blank, plain_.way_of(tried[blank].action), progress_);
          if (!swept) {
            left.push_back(body);
            continue;
          }
          found = true;
          left.insert(left.end(), swept->left.begin(), swept->left.end());
          made.push_back(mold_body(std::move(swept->moved), unit));
          made.back().kind = PieceKind::slide;
          made.back().blanks = {blank};
          made.back().name = fmt::format("slide_{}", blank + 1);
        }
        if (!found) return "what it forms with other actions cannot be divided";
        rest = std::move(left);
      }
      // What is too thin for an insert the plastic fills.
      for (TriangleMesh& mesh : rest) {
        MoldBody body = mold_body(std::move(mesh), unit);
        if (is_speck(body, k_left_to_plastic * unit)) {
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
    const TriangleMesh mesh = plain_.as_in_part(piece->mesh);
    const glm::dvec3 way = plain_.way_of(tried[blank].action);
    std::string in_way;
    const auto looked_at = [&](const TriangleMesh& still, std::string_view name) {
      const WayOut out = way_out(mesh, still, way, INFINITY, k_way_slack);
      if (out.blocked <= k_way_slack || !in_way.empty()) return;
      in_way = plain_.stands_text(name, out.place);
    };
    looked_at(plain_.part, "the part");
    looked_at(plain_.as_in_part(halves.core.mesh), "the core");
    looked_at(plain_.as_in_part(halves.cavity.mesh), "the cavity");
    for (std::size_t k = 0; k < halves.inserts.size(); ++k) {
      if (k != number)
        looked_at(plain_.as_in_part(halves.inserts[k].mesh),
                  halves.inserts[k].blanks.empty() ? "an insert" : "another slide");
    }
    if (!in_way.empty()) return in_way;
    if (piece->crossed_facets > 0) return "facets of it cross each other by rounding";
    return {};
  }

  PlainMold plain_;
  bool divides_;
  const Progress& progress_;
  std::vector<UnmadeAction> unmade_;
  LifterBars bars_{plain_, unmade_, progress_};
  std::vector<Tried> blanks_;
};

}  // namespace

MoldPieces make_pieces(const PiecesWish& wish, const Progress& progress) {
  if (!wish.plain.made()) return {.halves = wish.plain, .of_inserts = {}, .unmade = {}};
  MoldPieces pieces = PieceMaker(wish, true, progress).run();
  const MoldHalves& made = pieces.halves;
  const bool none = made.count(PieceKind::slide) + made.count(PieceKind::lifter) == 0;
  if (pieces.unmade.empty() || !none || !wish.plain.divided) return pieces;
  // Walls that are not divided may cross less by rounding.
  const MoldHalves plain = make_halves(wish.model, wish.plain.frame.z, wish.place, wish.settings, progress,
                                       {.blanks = {}, .divides = false, .contact_area = 0.0});
  if (!plain.made() || (wish.plain.certified() && !plain.certified())) return pieces;
  const PiecesWish again{wish.model, plain, wish.plan, wish.split, wish.place, wish.settings};
  MoldPieces others = PieceMaker(again, false, progress).run();
  return others.unmade.size() < pieces.unmade.size() ? std::move(others) : std::move(pieces);
}

}  // namespace moldlight
