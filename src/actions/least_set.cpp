#include "actions/least_set.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <tbb/parallel_for.h>

#include "actions/meetings.hpp"
#include "actions/piece_actions.hpp"
#include "actions/set_cover.hpp"
#include "base/error.hpp"

namespace moldlight {

namespace {

constexpr double k_meeting_cost = 100.0;  // of two that meet: more than what can be done instead
constexpr int k_most_rounds = 40;
/// Of pairs that are asked whether they meet before they are chosen.
constexpr std::size_t k_pairs_ahead = 1000;
constexpr int k_most_unproved = 4;                                       // rounds whose cover was given up
constexpr std::size_t k_nodes = 200'000, k_nodes_with_clashes = 20'000;  // of a cover, at most

/// A set of columns as a plan, and the column of each of its actions.
struct Draft {
  ActionPlan plan;
  std::vector<std::size_t> columns;
  std::vector<std::vector<std::size_t>> atoms;  // of each action
};

class LeastSet {
 public:
  LeastSet(const ChosenContext& context, const std::vector<Atom>& atoms, const LeastSetQuestions& ask,
           const Progress& progress)
      : context_(context), atoms_(atoms), ask_(ask), progress_(progress) {}

  ActionPlan run(std::vector<Column> columns) {
    constexpr int k_most_others = 3;  // rounds in which others are looked for
    add(std::move(columns));
    for (int round = 0;; ++round) {
      Draft draft = cheapest();
      if (context_.detail == PlanDetail::rough) return std::move(draft.plan);
      const std::vector<ActionFault> faults = ask_.faults(draft.plan);
      if (faults.empty()) {
        draft.plan.rejected = std::move(rejected_);
        return std::move(draft.plan);
      }
      const bool others = round < k_most_others;
      std::vector<std::size_t> lost = rejected_of(draft, faults, others);
      if (others) {
        std::erase_if(lost, [&](std::size_t atom) { return has_column(atom); });
        add(ask_.last_resort(lost));
      } else {
        for (Column& column : columns_) give_up(lost, column.atoms);
        for (CoverColumn& column : priced_) give_up(lost, column.atoms);
      }
    }
  }

 private:
  /// Without what cannot be built so far.
  Draft cheapest() {
    std::optional<Draft> best;
    double best_cost = std::numeric_limits<double>::infinity();
    int unproved = 0;
    for (int round = 0; round < k_most_rounds && unproved < k_most_unproved; ++round) {
      progress_.report("choosing the least set", 0.8);
      const Cover cover = least_cover(atoms_.size(), priced_, clashes_,
                                      clashes_.empty() ? k_nodes : k_nodes_with_clashes, progress_);
      unproved += cover.optimal ? 0 : 1;
      // Clashes that are not known yet would only make it dearer.
      if (best && cover.cost >= best_cost) {
        best->plan.optimal = cover.optimal;
        break;
      }
      Draft draft = draft_of(cover);
      const std::size_t found = context_.detail == PlanDetail::rough ? 0 : learn(draft);
      const double its_cost = cover.cost + k_meeting_cost * static_cast<double>(found);
      if (its_cost < best_cost) {
        best_cost = its_cost;
        best = std::move(draft);
        best->plan.optimal = false;
      }
      if (found > 0) continue;
      best->plan.optimal = cover.optimal;
      break;
    }
    return std::move(*best);
  }

  /// Gives up the columns of a draft that cannot be built; two that hit each other for the first time may be
  /// spared, as they are not chosen together again where that can be helped. The atoms that were theirs.
  std::vector<std::size_t> rejected_of(const Draft& draft, const std::vector<ActionFault>& faults,
                                       bool spare) {
    std::set<std::pair<std::size_t, std::size_t>> spared;
    std::set<std::size_t> gone;
    std::vector<std::size_t> lost;
    for (const ActionFault& fault : faults) {
      std::size_t action = fault.action;
      if (fault.hit.action) {
        const std::size_t other = *fault.hit.action;
        const std::pair<std::size_t, std::size_t> both = std::minmax(action, other);
        if (spare && take_down(draft.columns[action], draft.columns[other])) spared.insert(both);
        if (spared.contains(both) || gone.contains(other)) continue;
        action = both.second;  // the smaller one
      }
      if (!gone.insert(action).second) continue;
      priced_[draft.columns[action]].atoms.clear();
      columns_[draft.columns[action]].atoms.clear();
      lost.insert(lost.end(), draft.atoms[action].begin(), draft.atoms[action].end());
      const SideAction& its = draft.plan.actions[action];
      for (const std::size_t patch : its.patches)
        rejected_.push_back({.patch = patch,
                             .kind = its.kind,
                             .direction = its.direction,
                             .travel = its.travel,
                             .core_side = its.core_side,
                             .reason = fault.reason,
                             .place = fault.hit.place,
                             .hit = fault.hit});
    }
    return lost;
  }

  [[nodiscard]] bool has_column(std::size_t atom) const {
    return std::ranges::any_of(priced_, [&](const CoverColumn& column) {
      return std::ranges::find(column.atoms, atom) != column.atoms.end();
    });
  }

  static void give_up(const std::vector<std::size_t>& lost, std::vector<std::size_t>& atoms) {
    std::erase_if(atoms, [&](std::size_t atom) { return std::ranges::find(lost, atom) != lost.end(); });
  }

  void add(std::vector<Column> columns) {
    for (Column& column : columns) {
      priced_.push_back({column.atoms, pull_cost(column.pull, context_.settings.prices)});
      columns_.push_back(std::move(column));
    }
  }

  /// A column and those of its atoms that are left to it.
  using Left = std::pair<std::size_t, std::vector<std::size_t>>;

  /// Finds the actions that are not known yet, several at a time.
  void find_actions_of(const std::vector<Left>& wanted) {
    std::vector<std::pair<const Left*, SideAction*>> missing;
    for (const Left& left : wanted) {
      const auto [place, is_new] = known_.try_emplace(left);
      if (is_new) missing.emplace_back(&place->first, &place->second);
    }
    tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t k) {
      const auto& [left, action] = missing[k];
      Column column = columns_[left->first];
      column.atoms = left->second;
      *action = chosen_action(context_, atoms_, column);
    });
  }

  [[nodiscard]] Draft draft_of(const Cover& cover) {
    Draft draft;
    std::vector<std::int32_t> of_atom(atoms_.size(), k_unreleased_piece);
    std::map<std::size_t, double> left_of;  // by patch
    for (const std::size_t atom : cover.uncovered) {
      if (atoms_[atom].shallow) {
        of_atom[atom] = k_no_action_of_piece;
      } else {
        left_of[atoms_[atom].patch] += atoms_[atom].area();
      }
    }
    for (const auto& [patch, area] : left_of) {
      draft.plan.unreleased.push_back(patch);
      draft.plan.unreleased_areas.push_back(area);
      draft.plan.unreleased_area += area;
    }
    std::vector<Left> chosen;
    for (const std::size_t c : cover.columns) {
      std::vector<std::size_t> left = columns_[c].atoms;
      std::erase_if(left, [&](std::size_t atom) { return of_atom[atom] >= 0; });
      for (const std::size_t atom : left) of_atom[atom] = static_cast<std::int32_t>(chosen.size());
      chosen.emplace_back(c, std::move(left));
    }
    find_actions_of(chosen);
    std::vector<SideAction> actions;
    for (const Left& left : chosen) actions.push_back(known_.at(left));
    std::vector<std::size_t> order(actions.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t k) { return actions[k].area; });
    std::vector<std::int32_t> place(actions.size());
    for (const std::size_t k : order) {
      place[k] = static_cast<std::int32_t>(draft.plan.actions.size());
      draft.plan.actions.push_back(std::move(actions[k]));
      draft.columns.push_back(cover.columns[k]);
      draft.atoms.push_back(chosen[k].second);
    }
    for (std::int32_t& action : of_atom)
      action = action < 0 ? action : place[static_cast<std::size_t>(action)];
    draft.plan.action_of_piece = actions_of_pieces(context_, atoms_, of_atom, draft.plan.actions);
    find_meetings(context_.model, context_.split, context_.pulls.release(), draft.plan);
    return draft;
  }

  /// Takes down which of its columns meet, and looks for ways round. How many pairs were not known.
  std::size_t learn(const Draft& draft) {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    std::vector<std::size_t> atoms;
    for (std::size_t k = 0; k < draft.plan.actions.size(); ++k) {
      for (const std::size_t other : draft.plan.actions[k].meets) {
        if (other > k || !take_down(draft.columns[k], draft.columns[other])) continue;
        found.emplace_back(k, other);
        for (const std::size_t one : {k, other}) {
          const std::vector<std::size_t>& its = columns_[draft.columns[one]].atoms;
          atoms.insert(atoms.end(), its.begin(), its.end());
        }
      }
    }
    go_round(std::move(atoms));
    for (const auto& [k, other] : found) look_ahead(draft, k, other);
    return found.size();
  }

  /// False where it is known.
  bool take_down(std::size_t a, std::size_t b) {
    if (!met_.insert(std::minmax(a, b)).second) return false;
    clashes_.push_back({a, b, k_meeting_cost});
    return true;
  }

  /// Which others for the same atoms as the two that meet would meet, too: so that not each pair of
  /// them has to be chosen first.
  void look_ahead(const Draft& draft, std::size_t one, std::size_t other) {
    const std::array<std::vector<std::size_t>, 2> alike = {those_like(draft.columns[one]),
                                                           those_like(draft.columns[other])};
    const std::size_t pairs = alike[0].size() * alike[1].size();
    if (pairs > pairs_ahead_ ||
        !looked_ahead_.insert({columns_[draft.columns[one]].atoms, columns_[draft.columns[other]].atoms})
             .second)
      return;
    pairs_ahead_ -= pairs;
    progress_.report("looking for ways round actions that meet", 0.9);
    std::array<MovedAction, 2> moved = {MovedAction{.action = one}, MovedAction{.action = other}};
    std::vector<Left> wanted;
    for (const std::vector<std::size_t>& columns : alike) {
      for (const std::size_t c : columns) wanted.emplace_back(c, columns_[c].atoms);
    }
    find_actions_of(wanted);
    for (const std::size_t side : {0, 1}) {
      for (const std::size_t c : alike[side]) {
        moved[side].moves.push_back(move_of(known_.at({c, columns_[c].atoms})));
      }
    }
    for (const auto& [a, b] : crossing_moves(context_.model, context_.split, context_.pulls.release(),
                                             draft.plan, moved[0], moved[1]))
      take_down(alike[0][a], alike[1][b]);
  }

  /// Slides for slides, lifters for lifters.
  [[nodiscard]] std::vector<std::size_t> those_like(std::size_t column) const {
    const auto is_like = [&](ActionKind kind) {
      return is_slide(columns_[column].pull.kind) ? is_slide(kind) : kind == ActionKind::lifter;
    };
    std::vector<std::size_t> alike;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (is_like(columns_[c].pull.kind) && columns_[c].atoms == columns_[column].atoms) alike.push_back(c);
    }
    return alike;
  }

  /// For each of the atoms once, several at a time.
  void go_round(std::vector<std::size_t> atoms) {
    std::erase_if(atoms, [&](std::size_t atom) { return !gone_round_.insert(atom).second; });
    if (atoms.empty()) return;
    progress_.report("looking for ways round actions that meet", 0.85);
    std::vector<std::vector<Column>> ways(atoms.size());
    tbb::parallel_for(std::size_t{0}, atoms.size(), [&](std::size_t k) {
      if (!progress_.cancelled()) ways[k] = ask_.ways_round(atoms[k]);
    });
    if (progress_.cancelled()) throw Cancelled();
    for (std::vector<Column>& columns : ways) add(std::move(columns));
  }

  const ChosenContext& context_;
  const std::vector<Atom>& atoms_;
  const LeastSetQuestions& ask_;
  const Progress& progress_;
  std::vector<Column> columns_;
  std::vector<CoverColumn> priced_;
  std::vector<CoverClash> clashes_;
  std::set<std::pair<std::size_t, std::size_t>> met_;
  std::set<std::size_t> gone_round_;                                                      // atoms
  std::set<std::pair<std::vector<std::size_t>, std::vector<std::size_t>>> looked_ahead_;  // atoms of pairs
  std::size_t pairs_ahead_ = k_pairs_ahead;  // that are still worth the time
  std::map<Left, SideAction> known_;
  std::vector<RejectedAction> rejected_;
};

}  // namespace

ActionPlan least_set(const ChosenContext& context, const std::vector<Atom>& atoms,
                     std::vector<Column> columns, const LeastSetQuestions& ask, const Progress& progress) {
  return LeastSet(context, atoms, ask, progress).run(std::move(columns));
}

}  // namespace moldlight
