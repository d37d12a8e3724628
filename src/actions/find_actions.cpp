// Pulls for each undercut, those that several can share, and the cheapest set of them.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

#include "actions/pull.hpp"
#include "actions/revolved.hpp"
#include "actions/set_cover.hpp"
#include "actions/side_action.hpp"
#include "actions/undercut_report.hpp"
#include "classify/map_comparison.hpp"
#include "mesh/faces.hpp"
#include "mesh/length_unit.hpp"

namespace moldlight {

namespace {

constexpr double k_never = std::numeric_limits<double>::infinity();
constexpr double k_samples = 6000.0;                              // over all undercuts
constexpr double k_least_samples = 48.0, k_most_samples = 600.0;  // of one of them
constexpr std::size_t k_corners = 64;                             // deepest ones that a travel is found for
constexpr double k_fine_step = 1.0 / 512.0;                       // of travels, share of the diagonal
constexpr double k_least_revolved = 1e-4;  // of the part's area: a smaller patch is neither thread nor ring
constexpr double k_narrow_cost = 2e-4;     // of a pull that may not turn at all, beside the weights
constexpr double k_travel_cost = 1e-3;     // of the diagonal, beside the weights
constexpr double k_wish_gain = 0.05;       // of a direction of the user's own, off the weights
constexpr double k_pin_reach = 0.02;       // of the diagonal, from a pin to its undercut

/// An undercut, or a part of one that nothing releases whole, while actions are looked for.
struct Atom {
  std::size_t patch = 0;
  std::vector<UndercutSample> samples;
  std::vector<Pull> pulls = {};
  bool whole = true;
  const ActionPin* pin = nullptr;  // of its undercut

  [[nodiscard]] bool allows(ActionKind kind) const { return pin == nullptr || pin->allows(kind); }
  /// False where it is to be left as it is.
  [[nodiscard]] bool wanted() const { return pin == nullptr || pin->kind; }
  /// The kind that alone may release it.
  [[nodiscard]] std::optional<ActionKind> only() const { return pin == nullptr ? std::nullopt : pin->kind; }

  [[nodiscard]] double area() const {
    return std::accumulate(samples.begin(), samples.end(), 0.0,
                           [](double sum, const UndercutSample& sample) { return sum + sample.area; });
  }
};

/// Atoms that one action may release.
struct Column {
  Pull pull;
  std::vector<std::size_t> atoms;
};

/// The weight of its kind; of equal ones the shorter is better, then the one that leaves more room.
double cost(const Pull& pull) {
  const double width_deg = pull.interval.to_deg - pull.interval.from_deg;
  const double gain = pull.source == PullSource::wish ? k_wish_gain : 0.0;
  return facts(pull.kind).weight - gain + k_travel_cost * pull.travel + k_narrow_cost / (1.0 + width_deg);
}

class Finder {
 public:
  Finder(const PartModel& model, const Classification& result, const ActionSettings& settings,
         const Progress& progress)
      : model_(model),
        split_(*result.split),
        settings_(settings),
        progress_(progress),
        query_(exact_query(model, result.query())),
        pulls_(model, query_, settings),
        undercuts_(find_undercuts(model, split_, query_)),
        faces_(part_faces(model.part, model.geometry, model.adjacency)) {
    const auto unit = find_length_unit(model.part.unit);
    unit_per_mm_ = 1.0 / (unit ? unit->mm : 1.0);
  }

  ActionPlan run() {
    sample();
    find_pulls();
    find_revolved();
    split_the_rest();
    find_inserts();
    drop_within_tolerance();
    const std::vector<Column> columns = find_columns();
    std::vector<CoverColumn> priced;
    for (const Column& column : columns) priced.push_back({column.atoms, cost(column.pull)});
    const Cover cover = least_cover(atoms_.size(), priced);

    ActionPlan plan;
    plan.dropped = undercuts_.dropped;
    plan.dropped_area = undercuts_.dropped_area;
    plan.optimal = cover.optimal;
    for (const std::size_t atom : cover.uncovered) {
      plan.unreleased.push_back(atoms_[atom].patch);
      plan.unreleased_area += atoms_[atom].area();
    }
    std::ranges::sort(plan.unreleased);
    std::vector<std::int32_t> of_atom(atoms_.size(),
                                      k_unreleased_piece);  // the action, as `actions` has them
    std::vector<SideAction> actions;
    for (const std::size_t c : cover.columns) {
      Column column = columns[c];
      std::erase_if(column.atoms, [&](std::size_t atom) { return of_atom[atom] >= 0; });
      for (const std::size_t atom : column.atoms) of_atom[atom] = static_cast<std::int32_t>(actions.size());
      actions.push_back(finished(column));
    }
    std::vector<std::size_t> order(actions.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t k) { return actions[k].area; });
    std::vector<std::int32_t> place(actions.size());
    for (const std::size_t k : order) {
      place[k] = static_cast<std::int32_t>(plan.actions.size());
      plan.actions.push_back(std::move(actions[k]));
    }
    for (std::int32_t& action : of_atom)
      action = action < 0 ? action : place[static_cast<std::size_t>(action)];
    assign_pieces(of_atom, plan);
    report(plan);
    return plan;
  }

 private:
  void sample() {
    double total = 0.0;
    for (const Undercut& patch : undercuts_.patches) total += patch.area;
    for (const Undercut& patch : undercuts_.patches) {
      const double wanted = std::clamp(k_samples * patch.area / total, k_least_samples, k_most_samples);
      atoms_.push_back(
          {atoms_.size(), sample_undercut(model_, split_, patch, static_cast<std::size_t>(wanted))});
      atoms_.back().pin = pin_of(settings_.pins, {atoms_.back().samples, patch.area}, model_.frame,
                                 k_pin_reach * model_.frame.diagonal);
    }
  }

  [[nodiscard]] std::vector<PullCandidate> candidates(const Atom& atom) const {
    auto tried = own_pulls(model_, split_, undercuts_.patches[atom.patch], query_.direction, settings_);
    const auto fan = pull_fan(query_.direction);
    tried.insert(tried.end(), fan.begin(), fan.end());
    return tried;
  }

  /// Calls `work` for every atom, several at a time. Throws Cancelled.
  template <typename Work>
  void for_each_atom(const Work& work) {
    tbb::parallel_for(std::size_t{0}, atoms_.size(), [&](std::size_t k) {
      if (!progress_.cancelled()) work(k);
    });
    if (progress_.cancelled()) throw Cancelled();
  }

  void find_pulls() {
    progress_.report("looking for side actions", 0.0);
    for_each_atom([&](std::size_t k) {
      Atom& atom = atoms_[k];
      if (atom.wanted()) atom.pulls = pulls_.find(atom.samples, candidates(atom), atom.only());
    });
  }

  /// What pulls clear within the lateral tolerance is no undercut that a mold maker would see.
  void drop_within_tolerance() {
    std::vector<char> kept(undercuts_.patches.size(), 0);
    for (const Atom& atom : atoms_) {
      const bool within =
          std::ranges::any_of(atom.pulls, [&](const Pull& pull) { return pull.travel <= query_.lateral; });
      if (!within) kept[atom.patch] = 1;
    }
    std::vector<std::size_t> number(kept.size(), 0), place(atoms_.size(), 0);
    std::vector<Undercut> patches;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      number[k] = patches.size();
      if (kept[k] != 0) {
        patches.push_back(std::move(undercuts_.patches[k]));
      } else {
        ++undercuts_.dropped;
        undercuts_.dropped_area += undercuts_.patches[k].area;
      }
    }
    undercuts_.patches = std::move(patches);
    std::vector<Atom> atoms;
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      place[k] = atoms.size();
      if (kept[atoms_[k].patch] == 0) continue;
      atoms_[k].patch = number[atoms_[k].patch];
      atoms.push_back(std::move(atoms_[k]));
    }
    atoms_ = std::move(atoms);
    for (Column& column : revolved_) {
      for (std::size_t& atom : column.atoms) atom = place[atom];
    }
  }

  /// Threads and rings among what no pull releases: all of it together, as the turns of a thread are patches
  /// of their own, then each.
  void find_revolved() {
    progress_.report("looking for threads", 0.4);
    std::vector<std::size_t> stuck;
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      if (atoms_[k].pulls.empty() && atoms_[k].area() >= k_least_revolved * model_.geometry.total_area)
        stuck.push_back(k);
    }
    std::vector<std::size_t> threads;
    for (const std::size_t k : stuck) {
      if (atoms_[k].allows(ActionKind::unscrew)) threads.push_back(k);
    }
    if (threads.size() > 1 && add_thread(threads)) return;
    for (const std::size_t k : stuck) {
      const bool turns = atoms_[k].allows(ActionKind::unscrew) && add_thread({k});
      if (!turns && atoms_[k].allows(ActionKind::strip)) add_ring(k);
    }
  }

  [[nodiscard]] Revolution axis_of(const HelixFit& fit) const {
    return {.point = model_.frame.center + model_.frame.diagonal * fit.point, .direction = query_.direction};
  }

  void add_revolved(ActionKind kind, bool core_side, const Revolution& about,
                    const std::vector<std::size_t>& atoms) {
    double least = k_never, greatest = -k_never;
    for (const std::size_t k : atoms) {
      for (const UndercutSample& sample : atoms_[k].samples) {
        const double height = glm::dot(glm::dvec3(sample.position), query_.direction);
        least = std::min(least, height);
        greatest = std::max(greatest, height);
      }
    }
    Pull pull{.kind = kind,
              .direction = core_side ? query_.direction : -query_.direction,
              .travel = greatest - least,
              .core_side = core_side,
              .about = about};
    if (about.pitch != 0.0) pull.about->turns = pull.travel * model_.frame.diagonal / std::abs(about.pitch);
    revolved_.push_back({pull, atoms});
  }

  [[nodiscard]] std::vector<FacetIndex> facets_of(const std::vector<std::size_t>& atoms) const {
    std::vector<FacetIndex> facets;
    for (const std::size_t k : atoms) {
      for (const std::uint32_t piece : undercuts_.patches[atoms_[k].patch].pieces)
        facets.push_back(split_.pieces[piece].facet);
    }
    std::ranges::sort(facets);
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    return facets;
  }

  bool add_thread(const std::vector<std::size_t>& atoms) {
    std::vector<UndercutSample> samples;
    for (const std::size_t k : atoms)
      samples.insert(samples.end(), atoms_[k].samples.begin(), atoms_[k].samples.end());
    const auto thread = find_thread(model_, {samples, facets_of(atoms)}, query_);
    if (!thread) return false;
    Revolution about = axis_of(thread->helix);
    about.pitch = (thread->right_handed ? 1.0 : -1.0) * thread->pitch * model_.frame.diagonal;
    add_revolved(ActionKind::unscrew, thread->core_side, about, atoms);
    return true;
  }

  void add_ring(std::size_t k) {
    const auto ring = find_ring(model_, {atoms_[k].samples, facets_of({k})}, query_);
    if (!ring) return;
    if (settings_.strip_strain_pct > 0.0 && 100.0 * ring->strain > settings_.strip_strain_pct) return;
    Revolution about = axis_of(ring->axis);
    about.strain = ring->strain;
    add_revolved(ActionKind::strip, ring->core_side, about, {k});
  }

  /// 1 for each atom that a thread or a ring releases.
  [[nodiscard]] std::vector<char> revolved_atoms() const {
    std::vector<char> revolved(atoms_.size(), 0);
    for (const Column& column : revolved_) {
      for (const std::size_t k : column.atoms) revolved[k] = 1;
    }
    return revolved;
  }

  /// What nothing releases whole becomes an atom for each part that a pull frees, and one for what none does.
  void split_the_rest() {
    progress_.report("splitting what no single action releases", 0.6);
    const std::vector<char> revolved = revolved_atoms();
    std::vector<std::vector<FreedPart>> parts(atoms_.size());
    for_each_atom([&](std::size_t k) {
      const Atom& atom = atoms_[k];
      if (revolved[k] == 0 && atom.pulls.empty() && atom.wanted())
        parts[k] = pulls_.split(atom.samples, candidates(atom), atom.only());
    });
    take_parts(parts);
  }

  /// For what no action of the mold releases.
  void find_inserts() {
    progress_.report("looking for loose inserts", 0.7);
    const std::vector<char> revolved = revolved_atoms();
    ActionSettings all_round = settings_;
    all_round.incline_deg = 90.0;
    const std::vector<PullCandidate> sphere = pull_sphere();
    std::vector<std::vector<FreedPart>> parts(atoms_.size());
    for_each_atom([&](std::size_t k) {
      const Atom& atom = atoms_[k];
      if (revolved[k] != 0 || !atom.pulls.empty() || !atom.allows(ActionKind::insert)) return;
      auto tried = own_pulls(model_, split_, undercuts_.patches[atom.patch], query_.direction, all_round);
      tried.insert(tried.end(), sphere.begin(), sphere.end());
      parts[k] = pulls_.find_inserts(atom.samples, tried, undercuts_.patches[atom.patch].area);
    });
    take_parts(parts);
  }

  /// Atoms that were split become their parts; the others, which have none, stay.
  void take_parts(std::vector<std::vector<FreedPart>>& parts) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const bool whole = atoms_[k].whole && parts[k].size() == 1;
      for (std::size_t part = 0; part < parts[k].size(); ++part) {
        Atom atom{atoms_[k].patch, std::move(parts[k][part].samples), std::move(parts[k][part].pulls), whole,
                  atoms_[k].pin};
        if (part == 0) {
          atoms_[k] = std::move(atom);
        } else {
          atoms_.push_back(std::move(atom));
        }
      }
    }
  }

  /// Undercuts that one direction releases and that are near enough to each other; and each on its own.
  std::vector<Column> find_columns() {
    progress_.report("choosing the least set", 0.8);
    std::vector<Column> columns = revolved_;
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      for (const Pull& pull : atoms_[k].pulls) {
        Column alone{pull, {k}};
        if (pull.kind == ActionKind::slide || pull.kind == ActionKind::inclined) add_shared(columns, alone);
        if (!pull.for_sharing) columns.push_back(std::move(alone));
      }
    }
    return columns;
  }

  void add_shared(std::vector<Column>& columns, const Column& alone) {
    std::vector<std::size_t> group = alone.atoms;
    Pull pull = alone.pull;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (std::size_t k = 0; k < atoms_.size(); ++k) {
        if (std::ranges::find(group, k) != group.end() || !atoms_[k].allows(pull.kind) ||
            !are_near(group[next], k, pull.direction) || !may_share(alone.atoms.front(), k) ||
            !pulls_.release().releases(atoms_[k].samples, pull.direction, k_never))
          continue;
        group.push_back(k);
        Pull its = pull;
        pulls_.estimate_travel(atoms_[k].samples, its);
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
        return !one.for_sharing && !other.for_sharing && glm::dot(one.direction, other.direction) >= least;
      });
    });
  }

  [[nodiscard]] bool are_near(std::size_t a, std::size_t b, const glm::dvec3& pull) const {
    const double across = settings_.bundle_across_mm * unit_per_mm_ / model_.frame.diagonal;
    const double along = settings_.bundle_along_mm * unit_per_mm_ / model_.frame.diagonal;
    std::array<double, 2> least{k_never, k_never}, greatest{-k_never, -k_never};
    for (const std::size_t which : {a, b}) {
      const std::size_t side = which == a ? 0 : 1;
      for (const UndercutSample& sample : atoms_[which].samples) {
        const double at = glm::dot(glm::dvec3(sample.position), pull);
        least[side] = std::min(least[side], at);
        greatest[side] = std::max(greatest[side], at);
      }
    }
    if (std::max(least[0] - greatest[1], least[1] - greatest[0]) > along) return false;
    return std::ranges::any_of(atoms_[a].samples, [&](const UndercutSample& one) {
      return std::ranges::any_of(atoms_[b].samples, [&](const UndercutSample& other) {
        const glm::dvec3 between(one.position - other.position);
        return glm::length(between - glm::dot(between, pull) * pull) <= across;
      });
    });
  }

  /// With its travel and interval as exact as they get.
  SideAction finished(const Column& column) const {
    Pull pull = column.pull;
    SideAction action;
    std::vector<UndercutSample> samples;
    for (const std::size_t k : column.atoms) {
      action.patches.push_back(atoms_[k].patch);
      action.area += atoms_[k].area();
      samples.insert(samples.end(), atoms_[k].samples.begin(), atoms_[k].samples.end());
    }
    std::ranges::sort(action.patches);
    action.patches.erase(std::unique(action.patches.begin(), action.patches.end()), action.patches.end());
    const double diagonal = model_.frame.diagonal;
    action.kind = pull.kind;
    action.about = pull.about;
    if (pull.kind == ActionKind::lifter) {
      action.stroke = pull.travel * diagonal / std::tan(glm::radians(settings_.lifter_angle_deg));
      double room = k_never;
      for (const UndercutSample& sample : samples)
        room = std::min(room, std::max(pull.travel, pulls_.release().free_length(sample, pull.direction)));
      action.clear_to = room * diagonal;
    } else if (!pull.about && pull.kind != ActionKind::insert) {
      pull = pulls_.in_the_middle(samples, {pull.direction, pull.source}, pull.kind);
      pulls_.set_travel(deepest(column, samples, pull.direction), k_fine_step, pull);
    }
    const bool slides = pull.kind == ActionKind::slide || pull.kind == ActionKind::inclined;
    action.travel = pull.travel * diagonal + (slides ? settings_.clearance_mm * unit_per_mm_ : 0.0);
    action.direction = pull.direction;
    action.interval = pull.interval;
    action.core_side = pull.core_side;
    return action;
  }

  /// Where a travel is found: what lies farthest against the pull, and some of the rest.
  [[nodiscard]] std::vector<UndercutSample> deepest(const Column& column,
                                                    const std::vector<UndercutSample>& samples,
                                                    const glm::dvec3& pull) const {
    const auto some = static_cast<std::ptrdiff_t>(std::min(samples.size(), 2 * k_corners));
    std::vector<UndercutSample> chosen(samples.begin(), samples.begin() + some);
    for (const std::size_t k : column.atoms) {
      if (!atoms_[k].whole) continue;
      const auto corners =
          deepest_corners(model_, split_, undercuts_.patches[atoms_[k].patch], pull, k_corners);
      chosen.insert(chosen.end(), corners.begin(), corners.end());
    }
    return chosen;
  }

  /// Pieces of an undercut that was split go with the sample that is nearest.
  void assign_pieces(const std::vector<std::int32_t>& of_atom, ActionPlan& plan) const {
    std::vector<std::vector<std::size_t>> atoms(undercuts_.patches.size());
    for (std::size_t k = 0; k < atoms_.size(); ++k) atoms[atoms_[k].patch].push_back(k);
    plan.action_of_piece.assign(split_.pieces.size(), k_no_action_of_piece);
    for (std::size_t patch = 0; patch < atoms.size(); ++patch) {
      const bool alike = std::ranges::all_of(
          atoms[patch], [&](std::size_t k) { return of_atom[k] == of_atom[atoms[patch].front()]; });
      for (const std::uint32_t piece : undercuts_.patches[patch].pieces)
        plan.action_of_piece[piece] =
            of_atom[alike ? atoms[patch].front() : nearest_atom(atoms[patch], piece)];
    }
  }

  [[nodiscard]] std::size_t nearest_atom(const std::vector<std::size_t>& atoms, std::uint32_t piece) const {
    glm::dvec3 middle(0.0);
    for (const VertexIndex corner : split_.pieces[piece].corners) middle += split_.vertices[corner] / 3.0;
    const glm::vec3 at = model_.frame.to_unit(middle);
    std::size_t nearest = atoms.front();
    float least = std::numeric_limits<float>::infinity();
    for (const std::size_t k : atoms) {
      for (const UndercutSample& sample : atoms_[k].samples) {
        const float distance = glm::distance(sample.position, at);
        if (distance >= least) continue;
        least = distance;
        nearest = k;
      }
    }
    return nearest;
  }

  void report(ActionPlan& plan) const {
    for (std::size_t k = 0; k < undercuts_.patches.size(); ++k) {
      UndercutReport told;
      told.undercut = undercuts_.patches[k];
      told.blocked_by = blockers(model_, split_, told.undercut, query_.direction);
      place(k, told);
      const SideAction* action = action_of(plan, k);
      if (action != nullptr) {
        const bool slides = action->kind == ActionKind::slide || action->kind == ActionKind::inclined;
        told.depth = action->travel - (slides ? settings_.clearance_mm * unit_per_mm_ : 0.0);
        told.core_side = action->core_side;
      }
      add_formed_surface({model_, split_, faces_, pulls_.release()}, action, told);
      plan.patches.push_back(std::move(told));
    }
  }

  /// Where a pin finds it, and the pin that did.
  void place(std::size_t patch, UndercutReport& told) const {
    const glm::vec3 centre = model_.frame.to_unit(told.undercut.centre);
    float nearest = std::numeric_limits<float>::infinity();
    for (const Atom& atom : atoms_) {
      if (atom.patch != patch) continue;
      if (atom.pin != nullptr) told.pin = *atom.pin;
      for (const UndercutSample& sample : atom.samples) {
        const float distance = glm::distance(sample.position, centre);
        if (distance >= nearest) continue;
        nearest = distance;
        told.point = model_.frame.center + model_.frame.diagonal * glm::dvec3(sample.position);
      }
    }
  }

  const PartModel& model_;
  const SplitMesh& split_;
  const ActionSettings& settings_;
  const Progress& progress_;
  ExactQuery query_;
  PullFinder pulls_;
  Undercuts undercuts_;
  Faces faces_;
  double unit_per_mm_ = 1.0;
  std::vector<Atom> atoms_;
  std::vector<Column> revolved_;  // threads and rings
};

}  // namespace

ActionPlan find_actions(const PartModel& model, const Classification& result, const ActionSettings& settings,
                        const Progress& progress) {
  return Finder(model, result, settings, progress).run();
}

}  // namespace moldlight
