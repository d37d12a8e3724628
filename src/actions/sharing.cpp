#include "actions/sharing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr double k_same_cosine = 1.0 - 1e-9;
constexpr double k_same_lifter = 1.0 - 1e-6;  // cosine
constexpr double k_bridged = 2.0;  // of the longer undercut along the pull: a gap that a slide passes

class Sharing {
 public:
  Sharing(const std::vector<Atom>& atoms, const PullFinder& pulls, const SharingReach& reach)
      : atoms_(atoms), pulls_(pulls), reach_(reach) {}

  void add(std::vector<Column>& columns, std::size_t atom, const Pull& pull) const {
    if (is_slide(pull.kind)) add_shared(columns, atom, pull);
    if (pull.kind == ActionKind::lifter) add_carried(columns, atom, pull);
    if (!pull.for_sharing) columns.push_back({pull, {atom}});
  }

 private:
  void add_shared(std::vector<Column>& columns, std::size_t first, Pull pull) const {
    std::vector<std::size_t> group = {first};
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (std::size_t k = 0; k < atoms_.size(); ++k) {
        pulls_.release().end_if_cancelled();
        if (std::ranges::find(group, k) != group.end() || !atoms_[k].allows(pull.kind) ||
            !may_share(first, k, pull.direction) || !are_near(group[next], k, pull.direction) ||
            !pulls_.release().releases(atoms_[k].samples, pull.direction, k_never))
          continue;
        group.push_back(k);
        Pull its = pull;
        pulls_.estimate_travel(atoms_[k].samples, its);
        pull.travel = std::max(pull.travel, its.travel);
        pull.way = std::max(pull.way, its.way);
      }
    }
    if (group.size() < 2) return;
    std::ranges::sort(group);
    columns.push_back({pull, std::move(group)});
  }

  /// Neighbours that are nearer than a stem is wide, and that the same lifter clears, stand on one stem.
  void add_carried(std::vector<Column>& columns, std::size_t first, Pull pull) const {
    std::vector<std::size_t> group = {first};
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      const auto its = std::ranges::find_if(atoms_[k].pulls, [&](const Pull& other) {
        return other.kind == ActionKind::lifter && other.core_side == pull.core_side &&
               glm::dot(other.direction, pull.direction) > k_same_lifter;
      });
      if (k == first || its == atoms_[k].pulls.end() || !are_within(group, k, reach_.stem)) continue;
      group.push_back(k);
      pull.travel = std::max(pull.travel, its->travel);
    }
    if (group.size() < 2) return;
    const glm::dvec3 side = pull.core_side ? pulls_.direction() : -pulls_.direction();
    const LifterWay way{pull.direction, side, pull.travel};
    for (const std::size_t k : group) {
      FreeLengths lengths(pulls_.release(), atoms_[k].samples, pull.direction);
      if (!pulls_.release().clears(lengths, way, pulls_.lifter_room())) return;
    }
    std::ranges::sort(group);
    columns.push_back({pull, std::move(group)});
  }

  [[nodiscard]] bool are_within(const std::vector<std::size_t>& group, std::size_t atom, double reach) const {
    return std::ranges::any_of(samples_of(atoms_, group), [&](const UndercutSample& one) {
      return std::ranges::any_of(atoms_[atom].samples, [&](const UndercutSample& other) {
        return glm::distance(glm::dvec3(one.position), glm::dvec3(other.position)) <= reach;
      });
    });
  }

  /// Whether some of their own directions are near enough to each other, or the shapes of both suggest this
  /// very one.
  [[nodiscard]] bool may_share(std::size_t a, std::size_t b, const glm::dvec3& direction) const {
    const double least = std::cos(glm::radians(k_bundle_deg));
    const auto suggests = [&](const Atom& atom) {
      return std::ranges::any_of(
          atom.pulls, [&](const Pull& pull) { return glm::dot(pull.direction, direction) > k_same_cosine; });
    };
    if (suggests(atoms_[a]) && suggests(atoms_[b])) return true;
    return std::ranges::any_of(atoms_[a].pulls, [&](const Pull& one) {
      return std::ranges::any_of(atoms_[b].pulls, [&](const Pull& other) {
        return !one.for_sharing && !other.for_sharing && glm::dot(one.direction, other.direction) >= least;
      });
    });
  }

  /// Whether the one hides the other, seen along the pull.
  [[nodiscard]] bool are_in_line(std::size_t a, std::size_t b, const glm::dvec3& pull) const {
    const glm::dvec3 level = glm::normalize(glm::cross(pulls_.direction(), pull));
    const auto overlap = [&](const glm::dvec3& along) {
      std::array<double, 2> least{k_never, k_never}, greatest{-k_never, -k_never};
      for (const std::size_t side : {0, 1}) {
        for (const UndercutSample& sample : atoms_[side == 0 ? a : b].samples) {
          const double at = glm::dot(glm::dvec3(sample.position), along);
          least[side] = std::min(least[side], at);
          greatest[side] = std::max(greatest[side], at);
        }
      }
      return least[0] < greatest[1] && least[1] < greatest[0];
    };
    return overlap(level) && overlap(glm::cross(pull, level));
  }

  [[nodiscard]] bool are_near(std::size_t a, std::size_t b, const glm::dvec3& pull) const {
    std::array<double, 2> least{k_never, k_never}, greatest{-k_never, -k_never};
    for (const std::size_t which : {a, b}) {
      const std::size_t side = which == a ? 0 : 1;
      for (const UndercutSample& sample : atoms_[which].samples) {
        const double at = glm::dot(glm::dvec3(sample.position), pull);
        least[side] = std::min(least[side], at);
        greatest[side] = std::max(greatest[side], at);
      }
    }
    const double gap = std::max(least[0] - greatest[1], least[1] - greatest[0]);
    const double longer = std::max(greatest[0] - least[0], greatest[1] - least[1]);
    // What lies behind the other is reached through the steel between: a pin through knuckles, but not one
    // through the core of a box.
    if (gap > reach_.along || (gap > k_bridged * longer && are_in_line(a, b, pull))) return false;
    return std::ranges::any_of(atoms_[a].samples, [&](const UndercutSample& one) {
      return std::ranges::any_of(atoms_[b].samples, [&](const UndercutSample& other) {
        const glm::dvec3 between(one.position - other.position);
        return glm::length(between - glm::dot(between, pull) * pull) <= reach_.across;
      });
    });
  }

  const std::vector<Atom>& atoms_;
  const PullFinder& pulls_;
  SharingReach reach_;
};

}  // namespace

void add_pull_columns(const std::vector<Atom>& atoms, const PullFinder& pulls, const SharingReach& reach,
                      std::size_t atom, const Pull& pull, std::vector<Column>& columns) {
  Sharing(atoms, pulls, reach).add(columns, atom, pull);
}

std::vector<Column> pull_columns(const std::vector<Atom>& atoms, const PullFinder& pulls,
                                 const SharingReach& reach) {
  std::vector<Column> columns;
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    for (const Pull& pull : atoms[k].pulls) add_pull_columns(atoms, pulls, reach, k, pull, columns);
  }
  return columns;
}

}  // namespace moldlight
