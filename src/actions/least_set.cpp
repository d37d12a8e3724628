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

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "actions/meetings.hpp"
#include "actions/piece_actions.hpp"
#include "actions/set_cover.hpp"
#include "base/error.hpp"

namespace moldlight {

namespace {

constexpr double k_meeting_cost = 100.0;  // of two that meet: more than what can be done instead
/// Of a slide's price, for what of a hole it forms across the hole's axis: more than 10 degrees off it.
constexpr double k_off_axis = 0.6, k_along_axis = 0.985;
constexpr int k_most_rounds = 40;
/// Of pairs that are asked whether they meet before they are chosen.
constexpr std::size_t k_pairs_ahead = 1000;
constexpr int k_most_unproved = 8;              // covers that are given up, of a plan
constexpr std::size_t k_nodes_at_last = 1'000;  // of those after them
constexpr std::size_t k_nodes = 200'000, k_nodes_with_clashes = 20'000;  // of a cover, at most

/// A set of options as a plan, and the option of each of its actions.
struct Draft {
  ActionPlan plan;
  std::vector<std::size_t> options;
  std::vector<std::vector<std::size_t>> undercut_parts;  // of each action
};

class LeastSet {
 public:
  LeastSet(const ChosenContext& context, const std::vector<UndercutPart>& undercut_parts,
           const LeastSetQuestions& ask, const Progress& progress)
      : context_(context),
        undercut_parts_(undercut_parts),
        ask_(ask),
        progress_(progress),
        meetings_(context.model, context.split, context.pulls.release()) {}

  ActionPlan run(std::vector<ActionOption> options) {
    constexpr int k_most_others = 12;  // rounds in which others are looked for
    add(std::move(options));
    bool fine = false;
    for (int round = 0;; ++round) {
      Draft draft = cheapest();
      while (give_up_crowded(draft) || give_up_partial(draft)) draft = cheapest();
      if (context_.detail != PlanDetail::whole || draft.plan.unreleased_area > context_.most_left)
        return std::move(draft.plan);
      const bool others = round < k_most_others;
      ask_.measure(draft.plan, fine);
      std::vector<std::size_t> lost = without_hits(draft, others);
      if (lost.empty() && !std::exchange(fine, true)) {
        ask_.measure(draft.plan, true);
        lost = without_hits(draft, others);
      }
      if (lost.empty()) {
        draft.plan.optimal = draft.plan.optimal && round <= k_most_others;
        draft.plan.rejected = std::move(rejected_);
        return std::move(draft.plan);
      }
      if (others) {
        go_round(lost);
        continue;
      }
      for (std::size_t c = 0; c < options_.size(); ++c) {
        std::erase_if(options_[c].undercut_parts, [&](std::size_t undercut_part) {
          return std::ranges::find(lost, undercut_part) != lost.end();
        });
        priced_[c].undercut_parts = options_[c].undercut_parts;
      }
    }
  }

 private:
  /// An option releases nothing any more.
  void drop(std::size_t option) {
    options_[option].undercut_parts.clear();
    priced_[option].undercut_parts.clear();
  }

  void give_up(const Draft& draft, std::size_t k, const RejectedAction& why) {
    drop(draft.options[k]);
    const SideAction& action = draft.plan.actions[k];
    for (const std::size_t undercut : action.undercuts) {
      RejectedAction& rejected = rejected_.emplace_back(why);
      rejected.undercut = undercut;
      rejected.kind = action.kind;
      rejected.direction = action.direction;
      rejected.travel = action.travel;
      rejected.core_side = action.core_side;
    }
  }

  /// Lifters that travel farther than few samples said, and have no room there, or no place to stand. Whether
  /// there were any.
  bool give_up_crowded(const Draft& draft) {
    bool any = false;
    for (std::size_t k = 0; k < draft.plan.actions.size(); ++k) {
      const SideAction& action = draft.plan.actions[k];
      const bool stands =
          action.kind != ActionKind::lifter || !context_.pulls.asks_for_stems() || !action.stems.empty();
      if (has_room(action) && stands) continue;
      any = true;
      const Undercut& undercut = context_.undercuts.counted[action.undercuts.front()];
      give_up(draft, k,
              {.reason = has_room(action) ? RejectReason::no_stem : RejectReason::no_room,
               .place = undercut.centre,
               .room = std::max(0.0, action.clear_to - action.travel)});
    }
    return any;
  }

  /// Lifters and loose inserts for undercuts that keep the part in its mold all the same; but where the user
  /// asks for them. Whether there were any.
  bool give_up_partial(const Draft& draft) {
    const ActionPlan& plan = draft.plan;
    std::vector<double> left(context_.undercuts.counted.size(), 0.0);
    for (std::size_t k = 0; k < plan.unreleased.size(); ++k)
      left[plan.unreleased[k]] = plan.unreleased_areas[k];
    const auto stays = [&](std::size_t undercut) {
      return is_stuck(left[undercut], context_.undercuts.counted[undercut].area, context_.lateral);
    };
    const auto is_asked_for = [&](std::size_t part) { return undercut_parts_[part].pin != nullptr; };
    bool any = false;
    for (std::size_t k = 0; k < plan.actions.size(); ++k) {
      const SideAction& action = plan.actions[k];
      if ((action.kind != ActionKind::lifter && action.kind != ActionKind::insert) ||
          !std::ranges::all_of(action.undercuts, stays) ||
          std::ranges::any_of(draft.undercut_parts[k], is_asked_for))
        continue;
      any = true;
      const std::size_t undercut = action.undercuts.front();
      give_up(draft, k,
              {.reason = RejectReason::leaves_rest,
               .place = context_.undercuts.counted[undercut].centre,
               .room = std::numeric_limits<double>::infinity(),
               .left = left[undercut]});
    }
    return any;
  }

  /// Gives up the options of a draft whose bodies hit; of two that hit each other the one that releases less,
  /// but for the first time where they may be `spared`, as they are not chosen together again if that can be
  /// helped. What they would have released.
  std::vector<std::size_t> without_hits(const Draft& draft, bool spared) {
    std::set<std::size_t> gone;
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    std::vector<std::size_t> lost;
    const std::vector<SideAction>& actions = draft.plan.actions;
    for (std::size_t k = 0; k < actions.size(); ++k) {
      // Facets of a thread leave their helix by more than the tolerance.
      if (!actions[k].body || !actions[k].body->hit || actions[k].kind == ActionKind::unscrew) continue;
      const BodyHit& hit = *actions[k].body->hit;
      std::size_t loser = k;
      if (hit.action) {
        const std::pair<std::size_t, std::size_t> both = std::minmax(k, *hit.action);
        if (spared && take_down(draft.options[k], draft.options[*hit.action])) {
          pairs.insert(both);
          for (const std::size_t one : {both.first, both.second})
            lost.insert(lost.end(), draft.undercut_parts[one].begin(), draft.undercut_parts[one].end());
        }
        if (pairs.contains(both) || gone.contains(both.first)) continue;
        loser = both.second;
      }
      if (!gone.insert(loser).second) continue;
      if (!hit.action) give_up_alike(draft, loser);
      lost.insert(lost.end(), draft.undercut_parts[loser].begin(), draft.undercut_parts[loser].end());
      give_up(draft, loser,
              {.reason = hit.action ? RejectReason::hits_body : RejectReason::hits_part,
               .place = hit.place,
               .room = std::numeric_limits<double>::infinity(),
               .depth = hit.depth,
               .when = hit.stage});
    }
    return lost;
  }

  /// What moves the same way and forms as much, or more, hits the part, too. What it forms elsewhere than
  /// where it hits may do without that.
  void give_up_alike(const Draft& draft, std::size_t k) {
    const std::vector<std::size_t>& formed = draft.undercut_parts[k];
    const Pull pull = options_[draft.options[k]].pull;
    for (std::size_t c = 0; c < options_.size(); ++c) {
      const Pull& its = options_[c].pull;
      if (its.kind == pull.kind && its.core_side == pull.core_side && !its.about &&
          glm::dot(its.direction, pull.direction) > k_same_pull &&
          std::ranges::includes(options_[c].undercut_parts, formed))
        drop(c);
    }
    if (formed.size() < 2 || pull.about) return;
    const glm::dvec3 place(context_.model.frame.to_unit(draft.plan.actions[k].body->hit->place));
    const auto from_its_way = [&](std::size_t part) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const UndercutSample& sample : undercut_parts_[part].samples) {
        const glm::dvec3 to = glm::dvec3(sample.position) - place;
        nearest = std::min(nearest, glm::length(to - glm::dot(to, pull.direction) * pull.direction));
      }
      return nearest;
    };
    std::vector<std::size_t> others = formed;
    others.erase(std::ranges::min_element(others, {}, from_its_way));
    add({{pull, std::move(others)}});
  }

  /// Of the options that are left.
  Draft cheapest() {
    std::optional<Draft> best;
    double best_cost = std::numeric_limits<double>::infinity();
    for (int round = 0; round == 0 || (round < k_most_rounds && unproved_ < k_most_unproved); ++round) {
      progress_.report("choosing the least set", 0.8);
      const std::size_t nodes = unproved_ >= k_most_unproved ? k_nodes_at_last
                                : clashes_.empty()           ? k_nodes
                                                             : k_nodes_with_clashes;
      const Cover cover = least_cover(undercut_parts_.size(), priced_, clashes_, nodes, progress_);
      unproved_ += cover.optimal ? 0 : 1;
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

  /// Whether a slide forms something of a hole across the hole's axis.
  [[nodiscard]] bool is_off_axis(const Pull& pull, std::size_t undercut_part) const {
    const auto& axis = undercut_parts_[undercut_part].axis;
    return axis && is_slide(pull.kind) && !pull.about &&
           std::abs(glm::dot(*axis, pull.direction)) < k_along_axis;
  }

  /// A hole is formed along its axis. A slide for it is dearer than all of the hole in another's way, and
  /// cheaper than its two sides in the ways of two others.
  [[nodiscard]] double cost_of(const ActionOption& option) const {
    const ActionPrices& prices = context_.settings.prices;
    const auto off_axis = std::ranges::count_if(
        option.undercut_parts, [&](std::size_t part) { return is_off_axis(option.pull, part); });
    return pull_cost(option.pull, prices) +
           k_off_axis * static_cast<double>(off_axis) * prices[static_cast<std::size_t>(ActionKind::slide)];
  }

  /// Each, and what it forms of holes along their axes by itself, too.
  void add(std::vector<ActionOption> options) {
    for (ActionOption& option : options) {
      ActionOption along = option;
      std::erase_if(along.undercut_parts, [&](std::size_t part) { return is_off_axis(option.pull, part); });
      if (!along.undercut_parts.empty() && along.undercut_parts.size() < option.undercut_parts.size()) {
        priced_.push_back({along.undercut_parts, cost_of(along)});
        options_.push_back(std::move(along));
      }
      priced_.push_back({option.undercut_parts, cost_of(option)});
      options_.push_back(std::move(option));
    }
  }

  /// An option and those of its undercut parts that are left to it.
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
      ActionOption option = options_[left->first];
      option.undercut_parts = left->second;
      *action = chosen_action(context_, undercut_parts_, option);
    });
  }

  [[nodiscard]] Draft draft_of(const Cover& cover) {
    Draft draft;
    std::vector<std::int32_t> of_atom(undercut_parts_.size(), k_unreleased_piece);
    std::map<std::size_t, double> left_of;  // by undercut
    for (const std::size_t undercut_part : cover.uncovered) {
      if (undercut_parts_[undercut_part].shallow) {
        of_atom[undercut_part] = k_no_action_of_piece;
      } else {
        left_of[undercut_parts_[undercut_part].undercut] += undercut_parts_[undercut_part].area();
      }
    }
    for (const auto& [undercut, area] : left_of) {
      draft.plan.unreleased.push_back(undercut);
      draft.plan.unreleased_areas.push_back(area);
      draft.plan.unreleased_area += area;
    }
    std::vector<Left> chosen;
    for (const std::size_t c : cover.options) {
      std::vector<std::size_t> left = options_[c].undercut_parts;
      std::erase_if(left, [&](std::size_t undercut_part) { return of_atom[undercut_part] >= 0; });
      for (const std::size_t undercut_part : left)
        of_atom[undercut_part] = static_cast<std::int32_t>(chosen.size());
      // A cover that was given up may have one that others make unnecessary.
      if (!left.empty()) chosen.emplace_back(c, std::move(left));
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
      draft.options.push_back(chosen[k].first);
      draft.undercut_parts.push_back(chosen[k].second);
    }
    if (context_.detail == PlanDetail::rough) return draft;
    for (std::int32_t& action : of_atom)
      action = action < 0 ? action : place[static_cast<std::size_t>(action)];
    if (!pieces_) pieces_.emplace(context_, undercut_parts_);
    draft.plan.action_of_piece = pieces_->of(of_atom, draft.plan.actions);
    meetings_.find(draft.plan);
    return draft;
  }

  /// Takes down which of its options meet, and looks for ways round. How many pairs were not known.
  std::size_t learn(const Draft& draft) {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    std::vector<std::size_t> undercut_parts;
    for (std::size_t k = 0; k < draft.plan.actions.size(); ++k) {
      for (const std::size_t other : draft.plan.actions[k].meets) {
        if (other > k || !take_down(draft.options[k], draft.options[other])) continue;
        found.emplace_back(k, other);
        for (const std::size_t one : {k, other}) {
          const std::vector<std::size_t>& its = options_[draft.options[one]].undercut_parts;
          undercut_parts.insert(undercut_parts.end(), its.begin(), its.end());
        }
      }
    }
    go_round(std::move(undercut_parts));
    for (const auto& [k, other] : found) look_ahead(draft, k, other);
    return found.size();
  }

  /// False where it is known.
  bool take_down(std::size_t a, std::size_t b) {
    if (!met_.insert(std::minmax(a, b)).second) return false;
    clashes_.push_back({a, b, k_meeting_cost});
    return true;
  }

  /// Which others for the same undercut parts as the two that meet would meet, too: so that not each pair of
  /// them has to be chosen first.
  void look_ahead(const Draft& draft, std::size_t one, std::size_t other) {
    const std::array<std::vector<std::size_t>, 2> alike = {those_like(draft.options[one]),
                                                           those_like(draft.options[other])};
    const std::size_t pairs = alike[0].size() * alike[1].size();
    if (pairs > pairs_ahead_ || !looked_ahead_
                                     .insert({options_[draft.options[one]].undercut_parts,
                                              options_[draft.options[other]].undercut_parts})
                                     .second)
      return;
    pairs_ahead_ -= pairs;
    progress_.report("looking for alternatives to actions that meet", 0.9);
    std::array<MovedAction, 2> moved = {MovedAction{.action = one}, MovedAction{.action = other}};
    std::vector<Left> wanted;
    for (const std::vector<std::size_t>& options : alike) {
      for (const std::size_t c : options) wanted.emplace_back(c, options_[c].undercut_parts);
    }
    find_actions_of(wanted);
    for (const std::size_t side : {0, 1}) {
      for (const std::size_t c : alike[side]) {
        moved[side].moves.push_back(move_of(known_.at({c, options_[c].undercut_parts})));
      }
    }
    for (const auto& [a, b] : meetings_.crossing_moves(draft.plan, moved[0], moved[1]))
      take_down(alike[0][a], alike[1][b]);
  }

  /// Slides for slides, lifters for lifters.
  [[nodiscard]] std::vector<std::size_t> those_like(std::size_t option) const {
    const auto is_like = [&](ActionKind kind) {
      return is_slide(options_[option].pull.kind) ? is_slide(kind) : kind == ActionKind::lifter;
    };
    std::vector<std::size_t> alike;
    for (std::size_t c = 0; c < options_.size(); ++c) {
      if (is_like(options_[c].pull.kind) && options_[c].undercut_parts == options_[option].undercut_parts)
        alike.push_back(c);
    }
    return alike;
  }

  /// For each of the undercut parts once, several at a time.
  void go_round(std::vector<std::size_t> undercut_parts) {
    std::erase_if(undercut_parts,
                  [&](std::size_t undercut_part) { return !gone_round_.insert(undercut_part).second; });
    if (undercut_parts.empty()) return;
    progress_.report("looking for alternatives to actions that meet", 0.85);
    std::vector<std::vector<ActionOption>> ways(undercut_parts.size());
    tbb::parallel_for(std::size_t{0}, undercut_parts.size(), [&](std::size_t k) {
      if (!progress_.cancelled()) ways[k] = ask_.alternatives(undercut_parts[k]);
    });
    if (progress_.cancelled()) throw Cancelled();
    for (std::vector<ActionOption>& options : ways) add(std::move(options));
  }

  const ChosenContext& context_;
  const std::vector<UndercutPart>& undercut_parts_;
  const LeastSetQuestions& ask_;
  const Progress& progress_;
  MeetingFinder meetings_;
  std::vector<ActionOption> options_;
  std::vector<CoverOption> priced_;
  std::vector<CoverClash> clashes_;
  std::set<std::pair<std::size_t, std::size_t>> met_;
  std::set<std::size_t> gone_round_;  // undercut parts
  std::set<std::pair<std::vector<std::size_t>, std::vector<std::size_t>>>
      looked_ahead_;                         // undercut parts of pairs
  std::size_t pairs_ahead_ = k_pairs_ahead;  // that are still worth the time
  int unproved_ = 0;                         // covers
  std::map<Left, SideAction> known_;
  std::optional<PieceActions> pieces_;
  std::vector<RejectedAction> rejected_;
};

}  // namespace

ActionPlan least_set(const ChosenContext& context, const std::vector<UndercutPart>& undercut_parts,
                     std::vector<ActionOption> options, const LeastSetQuestions& ask,
                     const Progress& progress) {
  return LeastSet(context, undercut_parts, ask, progress).run(std::move(options));
}

}  // namespace moldlight
