// The ranking of parting directions by a mold maker's criteria.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/action_kind.hpp"

namespace moldlight {

/// In this order. All are figures of which less is better.
enum class MoldCriterion : std::uint8_t {
  found,       // 1 for a direction that the part's shape does not name, or names by less, beside one that it
               // names and that costs no more
  unreleased,  // surface that no side action releases, or more than a mold has, share of the part's
  effort,      // weight of the side actions, and what is added to it, see mold_effort()
  line,        // climb and steep steps of the parting line, share of the diagonal
  draft,       // surface with too little draft or with reverse draft, share of the part's
  undercut,    // share of the part's surface
  depth,       // draw depth, share of the diagonal
  support,     // share of the surface that does not speak for the direction
};
inline constexpr std::size_t k_mold_criteria = 8;

struct MoldCost {
  std::array<double, k_mold_criteria> values{};
  glm::dvec3 direction{0.0};  // unit
  bool canonical = false;
  double weight = 0.0;       // of side actions
  double in_vain = 0.0;      // of it, what does not count as effort
  double formed = 0.0;       // by them, share of the part's surface
  double on_its_side = 0.0;  // of the effort, see settle()
  double beyond = 0.0;       // of what is unreleased what only more side actions than are built would release
  ActionCounts counts{};     // of side actions

  [[nodiscard]] double of(MoldCriterion criterion) const {
    return values[static_cast<std::size_t>(criterion)];
  }
  double& of(MoldCriterion criterion) { return values[static_cast<std::size_t>(criterion)]; }
};

/// Of the surface that side actions form, as a share: each fifth weighs as much as a slide.
inline constexpr double k_effort_of_formed = 5.0;
/// What a part that lies on its side in the mold leaves to them: of what is formed beyond a quarter of the
/// surface each fortieth weighs as much as a slide. A fifth of it more than in the direction that leaves them
/// least is no such mold: bores that cross are formed by slides whichever way the part lies.
inline constexpr double k_on_its_side = 0.25, k_beyond_the_least = 0.2, k_effort_on_its_side = 40.0;
/// Of surface without draft, as a share: half of it weighs as much as a slide.
inline constexpr double k_effort_of_draft = 2.0;
/// Of the line's climb and steep steps: a diagonal weighs as much as a slide, and more than two diagonals no
/// more.
inline constexpr double k_most_of_line = 2.0;
/// Added where the part's shape does not name the direction: no wall is upright or level in such a mold.
inline constexpr double k_effort_of_found = 4.0;
/// The weight of side actions that counts, with what they form, the draft that is missing, the climb of the
/// line, and more than any one action where something is left unreleased: few slides are no gain where the
/// part lies on its side in the mold. Set the other figures before.
[[nodiscard]] double mold_effort(const MoldCost& cost);

/// What of it comes from lying on its side, for the share that side actions form and the least share that
/// they form in another direction.
[[nodiscard]] double effort_on_its_side(double formed, double least_formed);

/// Figures that differ by less tie; beside the least of them, for what that leaves unreleased.
[[nodiscard]] double mold_band(MoldCriterion criterion, double least = 0.0);

/// Whether the one leaves no more surface unreleased and needs no heavier set of side actions, as a whole or
/// without what does not count.
[[nodiscard]] bool costs_no_more(const MoldCost& one, const MoldCost& other);

struct MoldOrder {
  std::vector<std::size_t> order;  // best first, indices into the costs
  /// By place in the order: what decided against it beside the one before; none for the first, and where all
  /// that counts ties.
  std::vector<std::optional<MoldCriterion>> decided_by;
};
/// Within 10 degrees one direction lies beside another.
inline constexpr double k_beside_deg = 10.0;
/// Settles what depends on the others. Of the effort, what comes from lying on its side, beside the least
/// that side actions form where no more is left unreleased. And what is found beside what the shape names: a
/// direction that it does not name, where one that it names costs no more, or where both leave surface
/// unreleased, so that the part has to be changed, and that one not 5 % of the surface more, or 20 % where
/// half of the surface speaks for it; and one that it
/// names, where another beside it, for which more of the surface speaks, costs no more.
void settle(std::span<MoldCost> costs);
/// The first is what remains where, criterion by criterion, all go that are worse than the best left by more
/// than the band; of what ties in all, the first given. The next is the first of the others, and so on.
[[nodiscard]] MoldOrder mold_order(std::span<const MoldCost> costs);

/// "needs 1 lifter more", "its parting line climbs more, by 3.1 % of the part's diagonal": what speaks
/// against the one beside the other, what decides first, and what speaks for it last.
[[nodiscard]] std::vector<std::string> rank_reasons(const MoldCost& one, const MoldCost& other);

/// What a direction wins and costs beside another one, in words, the depth left aside. Worse side actions,
/// unreleased surface and parting lines are costs even within the bands.
struct MoldTrade {
  std::vector<std::string> wins, costs;
  /// Lighter side actions, all released, or 2 % less of line, draft or undercut. Nothing where it leaves more
  /// unreleased; and a line is worth one slide more at most, draft and undercut are worth none.
  bool worth = false;
};
[[nodiscard]] MoldTrade mold_trade(MoldCost one, const MoldCost& other);

}  // namespace moldlight
