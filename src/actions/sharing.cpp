#include "actions/sharing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
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

  /// A pull of an undercut part.
  struct Asked {
    std::size_t undercut_part = 0;
    const Pull* pull = nullptr;
  };

  /// Of each of them, in their order.
  [[nodiscard]] std::vector<ActionOption> options(std::span<const Asked> asked) const {
    // Many undercuts have pulls of one direction: what is found of the others along it is found once.
    std::map<std::array<double, 3>, std::vector<std::size_t>> of_directions;
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const glm::dvec3& way = asked[k].pull->direction;
      of_directions[{way.x, way.y, way.z}].push_back(k);
    }
    std::vector<std::span<const std::size_t>> groups;
    for (const auto& [direction, numbers] : of_directions) groups.emplace_back(numbers);
    std::vector<std::vector<ActionOption>> found(asked.size());
    tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t group) {
      Along along(*this, asked[groups[group].front()].pull->direction);
      for (const std::size_t k : groups[group]) add(found[k], asked[k].undercut_part, *asked[k].pull, along);
    });
    std::vector<ActionOption> options;
    for (std::vector<ActionOption>& some : found) std::ranges::move(some, std::back_inserter(options));
    return options;
  }

 private:
  class Along;

  void add(std::vector<ActionOption>& options, std::size_t undercut_part, const Pull& pull,
           Along& along) const {
    if (is_slide(pull.kind) || (pull.kind == ActionKind::lifter && !pull.lack))
      add_group(options, undercut_part, pull, along);
    if (!pull.for_sharing) options.push_back({pull, {undercut_part}});
  }

  struct Ball {
    glm::dvec3 centre{0.0}, facing{0.0};  // the mean normal
    double radius = 0.0;
  };

  enum Axis : std::size_t { k_along, k_level, k_across, k_upright };  // the last is the parting direction
  struct Spacing {
    double gap = 0.0;                    // between them along the direction
    double longer = 0.0, shorter = 0.0;  // of the two, there
  };

  /// What is found of the undercut parts along one direction, each asked once.
  class Along {
   public:
    Along(const Sharing& sharing, const glm::dvec3& pull)
        : sharing_(sharing), pull_(pull), moved_(sharing.undercut_parts_.size()) {
      const glm::dvec3 level = glm::normalize(glm::cross(sharing.pulls_.direction(), pull));
      axes_ = {pull, level, glm::cross(pull, level), sharing.pulls_.direction()};
      extents_.fill(std::vector<std::optional<Extent>>(moved_.size()));
    }

    [[nodiscard]] const glm::dvec3& pull() const { return pull_; }

    /// The part of the pull that one needs; none where the direction does not release it.
    [[nodiscard]] const std::optional<Pull>& moved(std::size_t k, const Pull& pull) {
      if (!moved_[k]) {
        const std::span<const UndercutSample> samples = sharing_.undercut_parts_[k].samples;
        moved_[k].emplace();
        if (sharing_.pulls_.release().releases(samples, pull_, k_never))
          sharing_.pulls_.estimate_travel(samples, moved_[k]->emplace(pull));
      }
      return *moved_[k];
    }

    [[nodiscard]] Spacing spacing(std::size_t a, std::size_t b, Axis axis) {
      const auto [least_a, greatest_a] = extent(a, axis);
      const auto [least_b, greatest_b] = extent(b, axis);
      const auto [shorter, longer] = std::minmax({greatest_a - least_a, greatest_b - least_b});
      return {std::max(least_a - greatest_b, least_b - greatest_a), longer, shorter};
    }

   private:
    using Extent = std::pair<double, double>;

    [[nodiscard]] const Extent& extent(std::size_t k, Axis axis) {
      std::optional<Extent>& known = extents_[axis][k];
      if (known) return *known;
      known = {k_never, -k_never};
      for (const UndercutSample& sample : sharing_.undercut_parts_[k].samples) {
        const double at = glm::dot(glm::dvec3(sample.position), axes_[axis]);
        known->first = std::min(known->first, at);
        known->second = std::max(known->second, at);
      }
      return *known;
    }

    const Sharing& sharing_;
    glm::dvec3 pull_;
    std::array<glm::dvec3, 4> axes_;
    std::vector<std::optional<std::optional<Pull>>> moved_;
    std::array<std::vector<std::optional<Extent>>, 4> extents_;
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
  void add_group(std::vector<ActionOption>& options, std::size_t first, Pull pull, Along& along) const {
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
                                         join_slide(group, group[next], k, ways, along, pull)
                                   : !rest && join_lifter(group, group[next], k, along, pull);
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
                                Ways& ways, Along& along, Pull& pull) const {
    if (!may_share(group.front(), k, pull.direction) || !are_near(near, k, along) ||
        is_far_in_line(group, k, along, ways))
      return false;
    const std::optional<Pull>& its = along.moved(k, pull);
    if (!its) return false;
    pull.travel = std::max(pull.travel, its->travel);
    pull.way = std::max(pull.way, its->way);
    return true;
  }

  [[nodiscard]] bool join_lifter(std::vector<std::size_t> group, std::size_t near, std::size_t k,
                                 Along& along, Pull& pull) const {
    if (!are_side_by_side(near, k, along)) return false;
    group.push_back(k);
    const auto shared = pulls_.shared_lifter(samples_of(undercut_parts_, group), pull);
    pull = shared.value_or(pull);
    return shared.has_value();
  }

  /// In a row across the pull, facing the same way, with a gap no wider than either of them; or one above the
  /// other, where the one lifter's stem would go through the other's head.
  [[nodiscard]] bool are_side_by_side(std::size_t a, std::size_t b, Along& along) const {
    constexpr double k_least_facing = 0.3, k_same_way = 0.9;
    const glm::dvec3 &one_way = balls_[a].facing, &other_way = balls_[b].facing;
    if (along.spacing(a, b, k_along).gap >= 0.0) return false;
    const Spacing across = along.spacing(a, b, k_level);
    if (along.spacing(a, b, k_upright).gap >= 0.0)
      return across.gap < 0.0 && glm::dot(one_way, along.pull()) > k_least_facing &&
             glm::dot(other_way, along.pull()) > k_least_facing;
    const double lengths = glm::length(one_way) * glm::length(other_way);
    return lengths >= k_least_facing * k_least_facing &&
           glm::dot(one_way, other_way) >= k_same_way * lengths && across.gap <= across.shorter;
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
  [[nodiscard]] static bool are_in_line(std::size_t a, std::size_t b, Along& along) {
    return along.spacing(a, b, k_level).gap < 0.0 && along.spacing(a, b, k_across).gap < 0.0;
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

  /// What lies behind another is reached through the steel between: a pin through knuckles, or through ribs,
  /// from each to the next, but not one through the core of a box to what has a shorter way out on its other
  /// side.
  [[nodiscard]] bool is_far_in_line(std::span<const std::size_t> group, std::size_t k, Along& along,
                                    Ways& ways) const {
    bool is_far = false;
    for (const std::size_t one : group) {
      if (!are_in_line(one, k, along)) continue;
      const Spacing between = along.spacing(one, k, k_along);
      if (between.gap <= k_bridged * between.longer) return false;
      const bool one_behind =
          glm::dot(balls_[one].centre, along.pull()) < glm::dot(balls_[k].centre, along.pull());
      is_far = is_far || ways.is_shorter_elsewhere(one_behind ? one : k);
    }
    return is_far;
  }

  [[nodiscard]] bool are_near(std::size_t a, std::size_t b, Along& along) const {
    if (along.spacing(a, b, k_along).gap > reach_.along) return false;
    const glm::dvec3& pull = along.pull();
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

std::vector<ActionOption> pull_options(const std::vector<UndercutPart>& undercut_parts,
                                       const PullFinder& pulls, const SharingReach& reach,
                                       std::size_t undercut_part, std::span<const Pull> further) {
  std::vector<Sharing::Asked> asked;
  for (const Pull& pull : further) asked.push_back({undercut_part, &pull});
  return Sharing(undercut_parts, pulls, reach).options(asked);
}

std::vector<ActionOption> pull_options(const std::vector<UndercutPart>& undercut_parts,
                                       const PullFinder& pulls, const SharingReach& reach) {
  std::vector<Sharing::Asked> asked;
  for (std::size_t k = 0; k < undercut_parts.size(); ++k) {
    for (const Pull& pull : undercut_parts[k].pulls) asked.push_back({k, &pull});
  }
  return Sharing(undercut_parts, pulls, reach).options(asked);
}

}  // namespace moldlight
