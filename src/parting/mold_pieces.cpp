#include "parting/mold_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "classify/figure_table.hpp"
#include "parting/make_halves.hpp"
#include "parting/slide_blank.hpp"

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

struct Tried {
  SlideBlank blank;
  std::size_t action = 0;
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
      if (!is_slide(kind) && kind != ActionKind::lifter) continue;
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
    MoldPieces pieces{.halves = made ? std::move(*made) : wish_.plain,
                      .of_inserts = {},
                      .of_slides = {},
                      .unmade = std::move(unmade_)};
    pieces.of_inserts = actions_of_inserts(pieces.halves, wish_.split, wish_.plan);
    for (const Tried& one : blanks_) pieces.of_slides.push_back(one.action);
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

  /// With this share of the usual land around what the action forms.
  [[nodiscard]] SlideBlank blank_of(std::size_t number, double land) const {
    const auto refused = [](std::string why) {
      SlideBlank none;
      none.refusal = std::move(why);
      return none;
    };
    const SideAction& action = wish_.plan.actions[number];
    if (!is_slide(action.kind)) return refused("only slides are made as solids");
    if (std::abs(wish_.plain.frame.to_mold(action.direction).z) > k_inclined)
      return refused("it moves at an angle to the plane across the direction");
    std::vector<const TriangleMesh*> formed;
    for (std::size_t k = 0; k < of_plain_.size(); ++k) {
      const InsertActions& of = of_plain_[k];
      if (std::ranges::find(of.actions, number) == of.actions.end()) continue;
      if (of.actions.size() > 1 || of.unreleased > 0)
        return refused("other actions share the surface that it forms");
      formed.push_back(&inserts_[k]);
    }
    if (formed.empty()) return refused("no body between the halves is its own");
    const double middle = glm::dot(wish_.plain.centre, wish_.plain.frame.z);
    const double diagonal = wish_.model.frame.diagonal;
    return slide_blank({.part = part_,
                        .inserts = formed,
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
    Beside beside{{}, wish_.plain.block_low, wish_.plain.block_high, wish_.plain.margin};
    for (const Tried& one : tried) beside.blanks.push_back(one.blank);
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
    for (std::size_t k = 0; k < tried.size(); ++k) {
      why = fault_of(halves, tried, k);
      if (!why.empty()) return std::nullopt;
    }
    return halves;
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
      const WayOut out = way_out(mesh, still, way);
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
  if (!wish.plain.made()) return {.halves = wish.plain, .of_inserts = {}, .of_slides = {}, .unmade = {}};
  return PieceMaker(wish, progress).run();
}

}  // namespace moldlight
