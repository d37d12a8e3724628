// Pulls for each undercut, those that several can share, and the cheapest set of them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

#include "actions/atom.hpp"
#include "actions/chosen_action.hpp"
#include "actions/least_set.hpp"
#include "actions/revolved_columns.hpp"
#include "actions/sharing.hpp"
#include "actions/side_action.hpp"
#include "actions/undercut_report.hpp"
#include "classify/map_comparison.hpp"
#include "mesh/faces.hpp"

namespace moldlight {

namespace {

constexpr double k_samples = 6000.0;                              // over all undercuts
constexpr double k_least_samples = 48.0, k_most_samples = 600.0;  // of one of them
constexpr double k_across = 0.7;      // cosine, at most, between a way and one across it
constexpr double k_pin_reach = 0.02;  // of the diagonal, from a pin to its undercut

class Finder {
 public:
  Finder(const PartModel& model, const Classification& result, const ActionSettings& settings,
         const Progress& progress)
      : model_(model),
        split_(*result.split),
        settings_(settings),
        progress_(progress),
        query_(exact_query(model, result.query())),
        pulls_(model, query_, settings, progress),
        undercuts_(find_undercuts(model, split_, query_, progress)),
        faces_(part_faces(model.part, model.geometry, model.adjacency)),
        unit_per_mm_(unit_per_mm(model.part)) {}

  ActionPlan run() {
    sample();
    find_pulls();
    progress_.report("looking for threads", 0.4);
    revolved_ = revolved_columns({model_, split_, undercuts_, query_, settings_, progress_}, atoms_);
    split_the_rest();
    find_inserts();
    std::vector<Column> columns = find_columns();
    const ChosenContext context{model_, split_, undercuts_, pulls_, settings_, unit_per_mm_};
    ActionPlan plan = least_set(
        context, atoms_, std::move(columns), [&](std::size_t atom) { return ways_round(atom); }, progress_);
    plan.dropped = undercuts_.dropped;
    plan.dropped_area = undercuts_.dropped_area;
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

  [[nodiscard]] SharingReach sharing_reach() const {
    const double per_mm = unit_per_mm_ / model_.frame.diagonal;
    return {.across = settings_.bundle_across_mm * per_mm, .along = settings_.bundle_along_mm * per_mm};
  }

  std::vector<Column> find_columns() const {
    std::vector<Column> columns = pull_columns(atoms_, pulls_, sharing_reach());
    columns.insert(columns.begin(), revolved_.begin(), revolved_.end());
    return columns;
  }

  /// What else releases an atom whose slide or lifter meets another: its own slides turned, inclined ones,
  /// lifters, those across its own ways, too.
  std::vector<Column> ways_round(std::size_t number) const {
    const Atom& atom = atoms_[number];
    std::vector<Pull> pulls = pulls_.turned(atom.samples, atom.pulls);
    for (const ActionKind kind : {ActionKind::inclined, ActionKind::lifter}) {
      if (!atom.allows(kind)) continue;
      const std::vector<Pull> more = pulls_.find(atom.samples, candidates(atom), kind);
      pulls.insert(pulls.end(), more.begin(), more.end());
    }
    if (atom.allows(ActionKind::lifter)) {
      std::vector<PullCandidate> across = candidates(atom);
      std::erase_if(across, [&](const PullCandidate& tried) {
        return std::ranges::any_of(atom.pulls, [&](const Pull& pull) {
          return std::abs(glm::dot(tried.direction, pull.direction)) > k_across;
        });
      });
      const std::vector<Pull> more = pulls_.find(atom.samples, across, ActionKind::lifter);
      pulls.insert(pulls.end(), more.begin(), more.end());
    }
    std::vector<Column> columns;
    for (const Pull& pull : pulls) add_pull_columns(atoms_, pulls_, sharing_reach(), number, pull, columns);
    return columns;
  }

  void report(ActionPlan& plan) const {
    for (std::size_t k = 0; k < undercuts_.patches.size(); ++k) {
      progress_.report("describing undercuts", 0.9);
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
  double unit_per_mm_;
  std::vector<Atom> atoms_;
  std::vector<Column> revolved_;  // threads and rings
};

}  // namespace

ActionPlan find_actions(const PartModel& model, const Classification& result, const ActionSettings& settings,
                        const Progress& progress) {
  return Finder(model, result, settings, progress).run();
}

}  // namespace moldlight
