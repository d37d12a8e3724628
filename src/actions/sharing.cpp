#include "actions/sharing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

namespace moldlight {

namespace {

constexpr double k_bridged = 2.0;    // of the longer undercut along the pull: a gap that a slide passes
constexpr double k_elsewhere = 0.5;  // cosine at most between a pull and another one
constexpr double k_shorter = 0.999;  // of a way, at most, that is shorter

class Sharing {
 public:
  Sharing(const std::vector<UndercutPart>& undercut_parts, const PullFinder& pulls, const SharingReach& reach)
      : undercut_parts_(undercut_parts), pulls_(pulls), reach_(reach) {
    for (const UndercutPart& undercut_part : undercut_parts_) {
      Ball& ball = balls_.emplace_back();
      for (const UndercutSample& sample : undercut_part.samples) ball.centre += glm::dvec3(sample.position);
      ball.centre /= static_cast<double>(std::max<std::size_t>(1, undercut_part.samples.size()));
      for (const UndercutSample& sample : undercut_part.samples) ball.facing += sample.area * sample.normal;
      if (const double area = undercut_part.area(); area > 0.0) ball.facing /= area;
      for (const UndercutSample& sample : undercut_part.samples)
        ball.radius = std::max(ball.radius, glm::distance(glm::dvec3(sample.position), ball.centre));
    }
  }

  void add(std::vector<ActionOption>& options, std::size_t undercut_part, const Pull& pull) const {
    if (is_slide(pull.kind) || (pull.kind == ActionKind::lifter && !pull.lack))
      add_group(options, undercut_part, pull);
    if (!pull.for_sharing) options.push_back({pull, {undercut_part}});
  }

 private:
  struct Ball {
    glm::dvec3 centre{0.0}, facing{0.0};  // the mean normal
    double radius = 0.0;
  };

  /// Of the pull of one undercut: which others have a shorter way out elsewhere, each asked once.
  class Ways {
   public:
    Ways(const Sharing& sharing, std::size_t first, const Pull& pull)
        : sharing_(sharing),
          pull_(pull.direction),
          out_(pull.way + glm::dot(sharing.balls_[first].centre, pull.direction)),
          known_(sharing.balls_.size()) {}

    [[nodiscard]] bool is_shorter_elsewhere(std::size_t k) {
      if (!known_[k]) {
        const double way = out_ - glm::dot(sharing_.balls_[k].centre, pull_);
        known_[k] = std::ranges::any_of(sharing_.undercut_parts_[k].pulls, [&](const Pull& other) {
          return is_slide(other.kind) && glm::dot(other.direction, pull_) < k_elsewhere &&
                 other.way < k_shorter * way;
        });
      }
      return *known_[k];
    }

   private:
    const Sharing& sharing_;
    glm::dvec3 pull_;
    double out_;  // along it
    std::vector<std::optional<bool>> known_;
  };

  /// All that join one that is there; slides are shared first with what has no shorter way out elsewhere.
  void add_group(std::vector<ActionOption>& options, std::size_t first, Pull pull) const {
    const bool slide = is_slide(pull.kind);
    std::vector<std::size_t> group = {first};
    Ways ways(*this, first, pull);
    std::size_t tried = 0;  // beside so many of the group those were that come first
    for (const bool rest : {false, true}) {
      for (std::size_t next = 0; next < group.size(); ++next) {
        for (std::size_t k = 0; k < undercut_parts_.size(); ++k) {
          pulls_.release().end_if_cancelled();
          if (std::ranges::find(group, k) != group.end() || !undercut_parts_[k].allows(pull.kind)) continue;
          const bool joins = slide ? !are_far(group[next], k, pull.direction) &&
                                         (ways.is_shorter_elsewhere(k) ? rest : !rest || next >= tried) &&
                                         join_slide(group, group[next], k, ways, pull)
                                   : !rest && join_lifter(group, group[next], k, pull);
          if (joins) group.push_back(k);
        }
      }
      tried = group.size();
    }
    if (group.size() < 2) return;
    std::ranges::sort(group);
    options.push_back({pull, std::move(group)});
  }

  /// Whether it goes with a group, beside one of it that is `near`; the pull then moves all of them.
  [[nodiscard]] bool join_slide(std::span<const std::size_t> group, std::size_t near, std::size_t k,
                                Ways& ways, Pull& pull) const {
    if (!may_share(group.front(), k, pull.direction) || !are_near(near, k, pull.direction) ||
        is_far_in_line(group, k, pull.direction, ways) ||
        !pulls_.release().releases(undercut_parts_[k].samples, pull.direction, k_never))
      return false;
    Pull its = pull;
    pulls_.estimate_travel(undercut_parts_[k].samples, its);
    pull.travel = std::max(pull.travel, its.travel);
    pull.way = std::max(pull.way, its.way);
    return true;
  }

  [[nodiscard]] bool join_lifter(std::vector<std::size_t> group, std::size_t near, std::size_t k,
                                 Pull& pull) const {
    if (!are_side_by_side(near, k, pull.direction)) return false;
    group.push_back(k);
    const auto shared = pulls_.shared_lifter(samples_of(undercut_parts_, group), pull);
    pull = shared.value_or(pull);
    return shared.has_value();
  }

  /// In a row across the pull, facing the same way, with a gap no wider than either of them.
  [[nodiscard]] bool are_side_by_side(std::size_t a, std::size_t b, const glm::dvec3& pull) const {
    constexpr double k_least_facing = 0.3, k_same_way = 0.9;
    const glm::dvec3 &one_way = balls_[a].facing, &other_way = balls_[b].facing;
    const double lengths = glm::length(one_way) * glm::length(other_way);
    if (lengths < k_least_facing * k_least_facing || glm::dot(one_way, other_way) < k_same_way * lengths)
      return false;
    const Spacing across = spacing(a, b, glm::normalize(glm::cross(pulls_.direction(), pull)));
    return across.gap <= across.shorter && spacing(a, b, pull).gap < 0.0 &&
           spacing(a, b, pulls_.direction()).gap < 0.0;
  }

  /// Whether some of their own directions are near enough to each other, or the shapes of both suggest this
  /// very one, or it is an axis of the part and both are free to turn to it.
  [[nodiscard]] bool may_share(std::size_t a, std::size_t b, const glm::dvec3& direction) const {
    const double least = std::cos(glm::radians(k_bundle_deg));
    const auto suggests = [&](const UndercutPart& undercut_part) {
      return std::ranges::any_of(undercut_part.pulls, [&](const Pull& pull) {
        return glm::dot(pull.direction, direction) > k_same_pull;
      });
    };
    const auto leaves_along = [&](const UndercutPart& undercut_part) {
      return suggests(undercut_part) ||
             (pulls_.is_axis(direction) && pulls_.is_known(undercut_part.pulls, direction));
    };
    if (leaves_along(undercut_parts_[a]) && leaves_along(undercut_parts_[b])) return true;
    return std::ranges::any_of(undercut_parts_[a].pulls, [&](const Pull& one) {
      return std::ranges::any_of(undercut_parts_[b].pulls, [&](const Pull& other) {
        return !one.for_sharing && !other.for_sharing && glm::dot(one.direction, other.direction) >= least;
      });
    });
  }

  /// Whether the one hides the other, seen along the pull.
  [[nodiscard]] bool are_in_line(std::size_t a, std::size_t b, const glm::dvec3& pull) const {
    const glm::dvec3 level = glm::normalize(glm::cross(pulls_.direction(), pull));
    return spacing(a, b, level).gap < 0.0 && spacing(a, b, glm::cross(pull, level)).gap < 0.0;
  }

  /// By the balls around them: certainly not near.
  [[nodiscard]] bool are_far(std::size_t a, std::size_t b, const glm::dvec3& pull) const {
    constexpr double k_rounding = 1e-9;
    const glm::dvec3 between = balls_[a].centre - balls_[b].centre;
    const double along = glm::dot(between, pull);
    const double both = balls_[a].radius + balls_[b].radius + k_rounding;
    return std::abs(along) - both > reach_.along ||
           glm::length(between - along * pull) - both > reach_.across;
  }

  struct Spacing {
    double gap = 0.0;                    // between them along the direction
    double longer = 0.0, shorter = 0.0;  // of the two, there
  };
  [[nodiscard]] Spacing spacing(std::size_t a, std::size_t b, const glm::dvec3& pull) const {
    std::array<double, 2> least{k_never, k_never}, greatest{-k_never, -k_never};
    for (const std::size_t which : {a, b}) {
      const std::size_t side = which == a ? 0 : 1;
      for (const UndercutSample& sample : undercut_parts_[which].samples) {
        const double at = glm::dot(glm::dvec3(sample.position), pull);
        least[side] = std::min(least[side], at);
        greatest[side] = std::max(greatest[side], at);
      }
    }
    const auto [shorter, longer] = std::minmax({greatest[0] - least[0], greatest[1] - least[1]});
    return {std::max(least[0] - greatest[1], least[1] - greatest[0]), longer, shorter};
  }

  /// What lies behind another is reached through the steel between: a pin through knuckles, or through ribs,
  /// from each to the next, but not one through the core of a box to what has a shorter way out on its other
  /// side.
  [[nodiscard]] bool is_far_in_line(std::span<const std::size_t> group, std::size_t k, const glm::dvec3& pull,
                                    Ways& ways) const {
    bool is_far = false;
    for (const std::size_t one : group) {
      const Spacing between = spacing(one, k, pull);
      if (!are_in_line(one, k, pull)) continue;
      if (between.gap <= k_bridged * between.longer) return false;
      const bool one_behind = glm::dot(balls_[one].centre, pull) < glm::dot(balls_[k].centre, pull);
      is_far = is_far || ways.is_shorter_elsewhere(one_behind ? one : k);
    }
    return is_far;
  }

  [[nodiscard]] bool are_near(std::size_t a, std::size_t b, const glm::dvec3& pull) const {
    if (spacing(a, b, pull).gap > reach_.along) return false;
    return std::ranges::any_of(undercut_parts_[a].samples, [&](const UndercutSample& one) {
      return std::ranges::any_of(undercut_parts_[b].samples, [&](const UndercutSample& other) {
        const glm::dvec3 between(one.position - other.position);
        return glm::length(between - glm::dot(between, pull) * pull) <= reach_.across;
      });
    });
  }

  const std::vector<UndercutPart>& undercut_parts_;
  const PullFinder& pulls_;
  SharingReach reach_;
  std::vector<Ball> balls_;  // around the samples of each undercut part
};

}  // namespace

void add_pull_options(const std::vector<UndercutPart>& undercut_parts, const PullFinder& pulls,
                      const SharingReach& reach, std::size_t undercut_part, const Pull& pull,
                      std::vector<ActionOption>& options) {
  Sharing(undercut_parts, pulls, reach).add(options, undercut_part, pull);
}

std::vector<ActionOption> pull_options(const std::vector<UndercutPart>& undercut_parts,
                                       const PullFinder& pulls, const SharingReach& reach) {
  const Sharing sharing(undercut_parts, pulls, reach);
  std::vector<std::vector<ActionOption>> of_atoms(undercut_parts.size());
  tbb::parallel_for(std::size_t{0}, undercut_parts.size(), [&](std::size_t k) {
    for (const Pull& pull : undercut_parts[k].pulls) sharing.add(of_atoms[k], k, pull);
  });
  std::vector<ActionOption> options;
  for (std::vector<ActionOption>& of_atom : of_atoms) std::ranges::move(of_atom, std::back_inserter(options));
  return options;
}

}  // namespace moldlight
