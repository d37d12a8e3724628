// Candidates for each undercut, those that several can share, and the cheapest set of them.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

#include "actions/pull_candidates.hpp"
#include "actions/set_cover.hpp"
#include "actions/side_action.hpp"
#include "mesh/length_unit.hpp"

namespace moldlight {

namespace {

constexpr double k_never = std::numeric_limits<double>::infinity();
constexpr double k_samples = 6000.0;                              // over all undercuts
constexpr double k_least_samples = 48.0, k_most_samples = 600.0;  // of one of them
constexpr std::size_t k_quick_samples = 24;                       // which tell soon that a lifter is hopeless
constexpr std::size_t k_corners = 64;                             // deepest ones that a travel is found for
constexpr double k_coarse_step = 1.0 / 64.0, k_fine_step = 1.0 / 512.0;  // of travels, shares of the diagonal
constexpr double k_same_elevation_deg = 0.01;
constexpr std::size_t k_lifters = 3;    // of an undercut that are looked at closely
constexpr double k_narrow_cost = 2e-4;  // of a pull that may not turn at all, beside the weights
constexpr double k_travel_cost = 1e-3;  // of the diagonal, beside the weights

/// A direction that releases one undercut.
struct Pull {
  ActionKind kind = ActionKind::slide;
  glm::dvec3 direction{1, 0, 0};
  PullSource source = PullSource::even;
  TurnInterval interval;
  double travel = 0.0;  // share of the diagonal, about
  bool core_side = true;
};

/// One undercut while actions are looked for.
struct Atom {
  std::vector<UndercutSample> samples;
  std::vector<Pull> pulls;
};

/// A set of undercuts that one action may release.
struct Column {
  Pull pull;
  std::vector<std::size_t> atoms;
};

class Finder {
 public:
  Finder(const PartModel& model, const Classification& result, const ActionSettings& settings,
         const Progress& progress)
      : model_(model),
        split_(*result.split),
        settings_(settings),
        progress_(progress),
        direction_(result.direction),
        release_(model, exact_query(model, result.query())),
        undercuts_(find_undercuts(model, split_, exact_query(model, result.query()))) {
    const auto unit = find_length_unit(model.part.unit);
    unit_per_mm_ = 1.0 / (unit ? unit->mm : 1.0);
  }

  ActionPlan run() {
    sample();
    find_pulls();
    const std::vector<Column> columns = find_columns();
    std::vector<CoverColumn> priced;
    for (const Column& column : columns) priced.push_back({column.atoms, cost(column.pull)});
    const Cover cover = least_cover(atoms_.size(), priced);

    ActionPlan plan;
    plan.dropped = undercuts_.dropped;
    plan.dropped_area = undercuts_.dropped_area;
    plan.optimal = cover.optimal;
    plan.unreleased = cover.uncovered;
    for (const std::size_t atom : cover.uncovered) plan.unreleased_area += undercuts_.patches[atom].area;
    std::vector<char> taken(atoms_.size(), 0);
    for (const std::size_t c : cover.columns) {
      Column column = columns[c];
      std::erase_if(column.atoms, [&](std::size_t atom) { return taken[atom] != 0; });
      for (const std::size_t atom : column.atoms) taken[atom] = 1;
      plan.actions.push_back(finished(column));
    }
    std::ranges::stable_sort(plan.actions, std::greater(), &SideAction::area);
    report(plan);
    return plan;
  }

 private:
  /// The weight of its kind; of equal ones the shorter is better, then the one that leaves more room.
  [[nodiscard]] static double cost(const Pull& pull) {
    const double width_deg = pull.interval.to_deg - pull.interval.from_deg;
    return facts(pull.kind).weight + k_travel_cost * pull.travel + k_narrow_cost / (1.0 + width_deg);
  }

  void sample() {
    double total = 0.0;
    for (const Undercut& patch : undercuts_.patches) total += patch.area;
    for (const Undercut& patch : undercuts_.patches) {
      const double wanted = std::clamp(k_samples * patch.area / total, k_least_samples, k_most_samples);
      atoms_.push_back({sample_undercut(model_, split_, patch, static_cast<std::size_t>(wanted)), {}});
    }
  }

  void find_pulls() {
    progress_.report("looking for side actions", 0.0);
    const std::vector<PullCandidate> fan = pull_fan(direction_);
    tbb::parallel_for(std::size_t{0}, atoms_.size(), [&](std::size_t k) {
      if (progress_.cancelled()) return;
      Atom& atom = atoms_[k];
      std::vector<PullCandidate> tried =
          own_pulls(model_, split_, undercuts_.patches[k], direction_, settings_);
      tried.insert(tried.end(), fan.begin(), fan.end());
      find_straight(atom, tried);
      if (atom.pulls.empty()) find_lifters(atom, tried);
    });
    if (progress_.cancelled()) throw Cancelled();
  }

  /// Slides; where there is none, such as lean; where there is none either, inclined ones.
  void find_straight(Atom& atom, const std::vector<PullCandidate>& tried) const {
    struct Band {
      ActionKind kind;
      double above_deg, up_to_deg;
    };
    for (const auto& [kind, above_deg, up_to_deg] :
         {Band{ActionKind::slide, -1.0, std::min(k_same_elevation_deg, settings_.slide_angle_deg)},
          Band{ActionKind::slide, k_same_elevation_deg, settings_.slide_angle_deg},
          Band{ActionKind::inclined, settings_.slide_angle_deg, settings_.incline_deg}}) {
      for (const PullCandidate& candidate : tried) {
        const double angle_deg = std::abs(elevation_deg(candidate.direction, direction_));
        if (angle_deg <= above_deg || angle_deg > up_to_deg || is_known(atom, candidate.direction)) continue;
        if (!release_.releases(atom.samples, candidate.direction, k_never)) continue;
        atom.pulls.push_back(in_the_middle(atom.samples, candidate, kind));
        estimate_travel(atom.samples, atom.pulls.back());
      }
      if (!atom.pulls.empty()) return;
    }
  }

  /// Whether a pull that was found reaches it by turning about the parting direction.
  [[nodiscard]] bool is_known(const Atom& atom, const glm::dvec3& pull) const {
    return std::ranges::any_of(atom.pulls, [&](const Pull& known) {
      if (std::abs(elevation_deg(known.direction, direction_) - elevation_deg(pull, direction_)) >
          k_same_elevation_deg)
        return false;
      const double angle_deg = turn_between(known.direction, pull);
      return angle_deg >= known.interval.from_deg - 1e-6 && angle_deg <= known.interval.to_deg + 1e-6;
    });
  }

  /// From one to the other about the parting direction, (-180, 180].
  [[nodiscard]] double turn_between(const glm::dvec3& from, const glm::dvec3& to) const {
    const glm::dvec3 a = from - glm::dot(from, direction_) * direction_;
    const glm::dvec3 b = to - glm::dot(to, direction_) * direction_;
    return glm::degrees(std::atan2(glm::dot(glm::cross(a, b), direction_), glm::dot(a, b)));
  }

  /// The middle of what is free, unless the part says better: an axis is kept unless it lies near an end, and
  /// where much is free, so is a direction of the part's own shape.
  [[nodiscard]] Pull in_the_middle(const std::vector<UndercutSample>& samples, const PullCandidate& candidate,
                                   ActionKind kind) const {
    constexpr double k_wide_deg = 10.0, k_least_margin_deg = 0.5;
    Pull pull{.kind = kind, .direction = candidate.direction, .source = candidate.source, .interval = {}};
    pull.interval = release_.free_turn(samples, pull.direction, direction_);
    const auto [from_deg, to_deg] = pull.interval;
    const double middle = pull.interval.middle_deg(), half = 0.5 * (to_deg - from_deg);
    const bool central = std::abs(middle) < 0.5 * half;
    const bool roomy = 2.0 * half > k_wide_deg && std::min(to_deg, -from_deg) >= k_least_margin_deg;
    if ((pull.source == PullSource::exact && central) || (pull.source != PullSource::even && roomy))
      return pull;
    const glm::dvec3 centred = turned_about(pull.direction, direction_, middle);
    if (!release_.releases(samples, centred, k_never)) return pull;
    pull.direction = centred;
    pull.source = PullSource::even;
    pull.interval = {-half, half};
    return pull;
  }

  void estimate_travel(const std::vector<UndercutSample>& samples, Pull& pull) const {
    const std::span<const UndercutSample> few(samples.data(), std::min(samples.size(), k_quick_samples));
    set_travel(few, k_coarse_step, pull);
  }

  /// On the side on which it is shorter.
  void set_travel(std::span<const UndercutSample> samples, double step, Pull& pull) const {
    const double core = release_.clear_beyond(samples, pull.direction, direction_, step);
    const double cavity = release_.clear_beyond(samples, pull.direction, -direction_, step);
    pull.core_side = core <= cavity;
    pull.travel = std::min(core, cavity);
  }

  /// Sideways by as little as clears the undercut, for each of the directions that seem best.
  void find_lifters(Atom& atom, const std::vector<PullCandidate>& tried) const {
    const std::span<const UndercutSample> few(atom.samples.data(),
                                              std::min(atom.samples.size(), k_quick_samples));
    std::vector<Pull> found;
    for (const PullCandidate& candidate : tried) {
      if (std::abs(elevation_deg(candidate.direction, direction_)) > k_same_elevation_deg) continue;
      for (const bool core_side : {true, false}) {
        const auto travel =
            release_.first_clear(few, candidate.direction, core_side ? direction_ : -direction_, 1.0);
        if (travel)
          found.push_back(
              {ActionKind::lifter, candidate.direction, candidate.source, {}, *travel, core_side});
      }
    }
    std::ranges::stable_sort(found, {}, &Pull::travel);
    for (Pull& pull : found) {
      if (atom.pulls.size() == k_lifters) return;
      const auto travel =
          release_.first_clear(atom.samples, pull.direction, pull.core_side ? direction_ : -direction_, 1.0);
      if (!travel) continue;
      pull.travel = *travel;
      atom.pulls.push_back(pull);
    }
  }

  /// Undercuts that one direction releases and that are near enough to each other; and each on its own.
  std::vector<Column> find_columns() {
    std::vector<Column> columns;
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      for (const Pull& pull : atoms_[k].pulls) {
        Column alone{pull, {k}};
        if (pull.kind != ActionKind::lifter) add_shared(columns, alone);
        columns.push_back(std::move(alone));
      }
    }
    return columns;
  }

  void add_shared(std::vector<Column>& columns, const Column& alone) {
    // Of undercuts that could share, the first looks for all.
    std::vector<std::size_t> group = alone.atoms;
    Pull pull = alone.pull;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (std::size_t k = 0; k < atoms_.size(); ++k) {
        if (std::ranges::find(group, k) != group.end() || !are_near(group[next], k, pull.direction) ||
            !may_share(alone.atoms.front(), k) ||
            !release_.releases(atoms_[k].samples, pull.direction, k_never))
          continue;
        group.push_back(k);
        Pull its = pull;
        estimate_travel(atoms_[k].samples, its);
        pull.travel = std::max(pull.travel, its.travel);
      }
    }
    if (group.size() < 2) return;
    std::ranges::sort(group);
    columns.push_back({pull, std::move(group)});
  }

  /// Whether some of their own directions are near enough to each other.
  [[nodiscard]] bool may_share(std::size_t a, std::size_t b) const {
    const double least = std::cos(glm::radians(k_bundle_deg));
    return std::ranges::any_of(atoms_[a].pulls, [&](const Pull& one) {
      return std::ranges::any_of(atoms_[b].pulls, [&](const Pull& other) {
        return glm::dot(one.direction, other.direction) >= least;
      });
    });
  }

  [[nodiscard]] bool are_near(std::size_t a, std::size_t b, const glm::dvec3& pull) const {
    const double across = settings_.bundle_across_mm * unit_per_mm_ / model_.frame.diagonal;
    const double along = settings_.bundle_along_mm * unit_per_mm_ / model_.frame.diagonal;
    double least_across = k_never;
    std::array<double, 2> least{k_never, k_never}, greatest{-k_never, -k_never};
    for (const std::size_t which : {a, b}) {
      for (const UndercutSample& sample : atoms_[which].samples) {
        const double at = glm::dot(glm::dvec3(sample.position), pull);
        const std::size_t side = which == a ? 0 : 1;
        least[side] = std::min(least[side], at);
        greatest[side] = std::max(greatest[side], at);
      }
    }
    if (std::max(least[0] - greatest[1], least[1] - greatest[0]) > along) return false;
    for (const UndercutSample& one : atoms_[a].samples) {
      for (const UndercutSample& other : atoms_[b].samples) {
        const glm::dvec3 between(one.position - other.position);
        least_across = std::min(least_across, glm::length(between - glm::dot(between, pull) * pull));
      }
      if (least_across <= across) return true;
    }
    return false;
  }

  /// With its travel and interval as exact as they get.
  SideAction finished(const Column& column) const {
    Pull pull = column.pull;
    std::vector<UndercutSample> samples, deepest;
    SideAction action;
    for (const std::size_t atom : column.atoms) {
      action.patches.push_back(atom);
      action.area += undercuts_.patches[atom].area;
      samples.insert(samples.end(), atoms_[atom].samples.begin(), atoms_[atom].samples.end());
    }
    const double diagonal = model_.frame.diagonal, clearance = settings_.clearance_mm * unit_per_mm_;
    action.kind = pull.kind;
    if (pull.kind == ActionKind::lifter) {
      action.travel = pull.travel * diagonal;
      action.stroke = action.travel / std::tan(glm::radians(settings_.lifter_angle_deg));
      double room = k_never;
      for (const UndercutSample& sample : samples)
        room = std::min(room, release_.free_length(sample, pull.direction));
      action.clear_to = room * diagonal;
    } else {
      pull = in_the_middle(samples, {pull.direction, pull.source}, pull.kind);
      for (const std::size_t atom : column.atoms) {
        const auto corners =
            deepest_corners(model_, split_, undercuts_.patches[atom], pull.direction, k_corners);
        deepest.insert(deepest.end(), corners.begin(), corners.end());
      }
      deepest.insert(deepest.end(), samples.begin(),
                     samples.begin() + static_cast<std::ptrdiff_t>(std::min(samples.size(), 2 * k_corners)));
      set_travel(deepest, k_fine_step, pull);
      action.travel = pull.travel * diagonal + clearance;
    }
    action.direction = pull.direction;
    action.interval = pull.interval;
    action.core_side = pull.core_side;
    return action;
  }

  void report(ActionPlan& plan) const {
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      UndercutReport told;
      told.undercut = undercuts_.patches[k];
      told.blocked_by = blockers(k);
      const auto action = std::ranges::find_if(plan.actions, [&](const SideAction& each) {
        return std::ranges::find(each.patches, k) != each.patches.end();
      });
      if (action != plan.actions.end()) {
        const double clearance =
            action->kind == ActionKind::lifter ? 0.0 : settings_.clearance_mm * unit_per_mm_;
        told.depth = action->travel - clearance;
        told.core_side = action->core_side;
      }
      told.formed_area = told.undercut.area;
      plan.patches.push_back(std::move(told));
    }
  }

  [[nodiscard]] std::vector<FacetIndex> blockers(std::size_t k) const {
    constexpr std::size_t k_most = 4, k_asked = 48;
    std::map<FacetIndex, int> counts;
    const auto& samples = atoms_[k].samples;
    for (std::size_t i = 0; i < std::min(samples.size(), k_asked); ++i) {
      for (const glm::dvec3& side : {direction_, -direction_}) {
        const auto hit = model_.rays().first_hit(samples[i].position, glm::vec3(side), true);
        if (hit) ++counts[hit->facet];
      }
    }
    std::vector<std::pair<FacetIndex, int>> order(counts.begin(), counts.end());
    std::ranges::stable_sort(order, std::greater(), [](const auto& entry) { return entry.second; });
    std::vector<FacetIndex> facets;
    for (std::size_t i = 0; i < std::min(order.size(), k_most); ++i) facets.push_back(order[i].first);
    return facets;
  }

  const PartModel& model_;
  const SplitMesh& split_;
  const ActionSettings& settings_;
  const Progress& progress_;
  glm::dvec3 direction_;
  Release release_;
  Undercuts undercuts_;
  double unit_per_mm_ = 1.0;
  std::vector<Atom> atoms_;
};

constexpr std::array<ActionFacts, k_action_kinds> k_facts = {{
    {"slide", "slides", "Pulled out sideways before the part leaves.", 1.0},
    {"inclined", "inclined slides",
     "A slide that moves at an angle to the plane across the parting direction.", 1.3},
    {"lifter", "lifters", "Moves sideways relative to the part while both rise.", 1.2},
    {"unscrew", "unscrewing cores", "Leaves the part along its thread.", 2.5},
    {"strip", "stripped rings", "The part is stretched over it.", 0.1},
    {"insert", "loose inserts", "Leaves the mold with the part and is taken out by hand.", 4.0},
}};

}  // namespace

const ActionFacts& facts(ActionKind kind) { return k_facts[static_cast<std::size_t>(kind)]; }

ActionPlan find_actions(const PartModel& model, const Classification& result, const ActionSettings& settings,
                        const Progress& progress) {
  return Finder(model, result, settings, progress).run();
}

std::string actions_text(const ActionPlan& plan) {
  std::array<std::size_t, k_action_kinds> counts{};
  for (const SideAction& action : plan.actions) ++counts[static_cast<std::size_t>(action.kind)];
  std::string text;
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind) {
    if (counts[kind] == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[kind],
                        counts[kind] == 1 ? k_facts[kind].name : k_facts[kind].plural);
  }
  return text.empty() ? "none" : text;
}

}  // namespace moldlight
