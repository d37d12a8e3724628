// Pulls for each undercut, those that several can share, and the cheapest set of them.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

#include "actions/atom.hpp"
#include "actions/chosen_action.hpp"
#include "actions/meetings.hpp"
#include "actions/revolved_columns.hpp"
#include "actions/set_cover.hpp"
#include "actions/sharing.hpp"
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
constexpr double k_narrow_cost = 5e-4;  // of a pull that may not turn at all, beside the weights
constexpr double k_travel_cost = 1e-3;  // of the diagonal, beside the weights
constexpr double k_wish_gain = 0.05;    // of a direction of the user's own, off the weights
constexpr double k_pin_reach = 0.02;    // of the diagonal, from a pin to its undercut

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
    progress_.report("looking for threads", 0.4);
    revolved_ = revolved_columns({model_, split_, undercuts_, query_, settings_}, atoms_);
    split_the_rest();
    find_inserts();
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
    const ChosenContext context{model_, split_, undercuts_, pulls_, settings_, unit_per_mm_};
    for (const std::size_t c : cover.columns) {
      Column column = columns[c];
      std::erase_if(column.atoms, [&](std::size_t atom) { return of_atom[atom] >= 0; });
      for (const std::size_t atom : column.atoms) of_atom[atom] = static_cast<std::int32_t>(actions.size());
      actions.push_back(chosen_action(context, atoms_, column));
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
    find_meetings(model_, split_, pulls_.release(), plan);
    report(plan);
    return plan;
  }

 private:
  void sample() {
    double total = 0.0;
    for (const Undercut& patch : undercuts_.patches) total += patch.area;
    for (std::size_t k = 0; k < undercuts_.patches.size(); ++k) {
      const Undercut& patch = undercuts_.patches[k];
      const double wanted = std::clamp(k_samples * patch.area / total, k_least_samples, k_most_samples);
      atoms_.push_back({k, sample_undercut(model_, split_, patch, static_cast<std::size_t>(wanted))});
      atoms_.back().pin = pin_of(settings_.pins, {atoms_.back().samples, patch.area}, model_.frame,
                                 k_pin_reach * model_.frame.diagonal);
    }
    if (model_.health.components > 1) set_covered_apart();
  }

  /// Bodies of a part may overlap. What of an undercut lies within another body becomes an atom of its own.
  void set_covered_apart() {
    for (std::size_t k = 0; k < undercuts_.patches.size(); ++k) {
      Atom covered{.patch = k, .samples = {}, .whole = false, .pin = atoms_[k].pin, .covered = true};
      std::vector<UndercutSample> bare;
      for (const UndercutSample& sample : atoms_[k].samples)
        (pulls_.release().is_covered(sample) ? covered.samples : bare).push_back(sample);
      if (covered.area() <= k_blocked_share * atoms_[k].area()) continue;
      if (bare.empty()) {
        atoms_[k] = std::move(covered);
        continue;
      }
      atoms_[k].samples = std::move(bare);
      atoms_[k].whole = false;
      atoms_.push_back(std::move(covered));
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
        Atom atom{atoms_[k].patch,
                  std::move(parts[k][part].samples),
                  std::move(parts[k][part].pulls),
                  whole,
                  atoms_[k].pin,
                  atoms_[k].covered};
        if (part == 0) {
          atoms_[k] = std::move(atom);
        } else {
          atoms_.push_back(std::move(atom));
        }
      }
    }
  }

  std::vector<Column> find_columns() const {
    progress_.report("choosing the least set", 0.8);
    const double per_mm = unit_per_mm_ / model_.frame.diagonal;
    std::vector<Column> columns = pull_columns(
        atoms_, pulls_,
        {.across = settings_.bundle_across_mm * per_mm, .along = settings_.bundle_along_mm * per_mm});
    columns.insert(columns.begin(), revolved_.begin(), revolved_.end());
    return columns;
  }

  /// Pieces of an undercut that was split go with the sample that is nearest, but rather with an action that
  /// frees their middles and corners, if there is one.
  void assign_pieces(const std::vector<std::int32_t>& of_atom, ActionPlan& plan) const {
    std::vector<std::vector<std::size_t>> atoms(undercuts_.patches.size());
    for (std::size_t k = 0; k < atoms_.size(); ++k) atoms[atoms_[k].patch].push_back(k);
    plan.action_of_piece.assign(split_.pieces.size(), k_no_action_of_piece);
    for (std::size_t patch = 0; patch < atoms.size(); ++patch) {
      const bool alike = std::ranges::all_of(
          atoms[patch], [&](std::size_t k) { return of_atom[k] == of_atom[atoms[patch].front()]; });
      const std::vector<std::uint32_t>& pieces = undercuts_.patches[patch].pieces;
      tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t k) {
        plan.action_of_piece[pieces[k]] =
            alike ? of_atom[atoms[patch].front()] : action_for(pieces[k], atoms[patch], of_atom, plan);
      });
    }
  }

  [[nodiscard]] std::int32_t action_for(std::uint32_t piece, const std::vector<std::size_t>& atoms,
                                        const std::vector<std::int32_t>& of_atom,
                                        const ActionPlan& plan) const {
    constexpr double k_inward = 0.1;
    const auto& corners = split_.pieces[piece].corners;
    glm::dvec3 middle(0.0);
    for (const VertexIndex corner : corners) middle += split_.vertices[corner] / 3.0;
    const glm::dvec3& normal = model_.geometry.normals[split_.pieces[piece].facet];
    const auto frees = [&](std::int32_t number) {
      if (number < 0) return false;
      const SideAction& action = plan.actions[static_cast<std::size_t>(number)];
      return is_freed({model_.frame.to_unit(middle), normal, 0.0}, action) &&
             std::ranges::all_of(corners, [&](VertexIndex corner) {
               const glm::dvec3 at = glm::mix(split_.vertices[corner], middle, k_inward);
               return is_freed({model_.frame.to_unit(at), normal, 0.0}, action);
             });
    };
    const std::int32_t nearest = of_atom[nearest_atom(atoms, model_.frame.to_unit(middle))];
    // Facets without area have no normal.
    if (nearest < 0 || normal == glm::dvec3(0.0) || frees(nearest)) return nearest;
    const auto other = std::ranges::find_if(atoms, [&](std::size_t k) { return frees(of_atom[k]); });
    return other != atoms.end() ? of_atom[*other] : nearest;
  }

  [[nodiscard]] bool is_freed(const UndercutSample& sample, const SideAction& action) const {
    const Release& release = pulls_.release();
    if (action.about) return true;
    const double length = release.free_length(sample, action.direction);
    if (action.kind == ActionKind::insert && release.covered(sample, action.direction)) return false;
    if (action.kind != ActionKind::lifter) return length == k_never;
    const double travel = action.travel / model_.frame.diagonal;
    return length >= travel && release.clear(sample, action.direction, travel,
                                             action.core_side ? query_.direction : -query_.direction);
  }

  [[nodiscard]] std::size_t nearest_atom(const std::vector<std::size_t>& atoms, const glm::vec3& at) const {
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
        told.depth = action->travel - (is_slide(action->kind) ? settings_.clearance_mm * unit_per_mm_ : 0.0);
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
