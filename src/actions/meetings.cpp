// A point is on the way of an action if a ray from it against the action's direction first meets the part on
// the surface that the action forms, of a lifter within its length. It is in an undercut if it is hidden from
// both halves.
#include "actions/meetings.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include <glm/geometric.hpp>

namespace moldlight {

struct WayReach {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  void take(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  [[nodiscard]] bool has(double value) const { return value >= least && value <= greatest; }
};

/// In the unit frame.
struct Way {
  std::size_t action = 0, number = 0;  // the number is that of no other way
  ActionKind kind = ActionKind::slide;
  bool core_side = true;
  glm::dvec3 direction{1, 0, 0};
  double end = 0.0;  // along the direction
  std::vector<UndercutSample> samples;

  [[nodiscard]] WayReach extent(const glm::dvec3& along) const {
    WayReach reach;
    for (const UndercutSample& sample : samples) reach.take(glm::dot(glm::dvec3(sample.position), along));
    return reach;
  }
};

/// By what an action forms, and how it moves.
using Ways = std::map<std::vector<double>, Way>;
/// By the numbers of the two.
using MetWays = std::map<std::pair<std::size_t, std::size_t>, bool>;

namespace {

constexpr std::size_t k_way_samples = 64;  // samples of an action
constexpr int k_places = 16;               // on the way of each, where the other may be
constexpr double k_way_beyond = 0.08;      // the part, share of the diagonal
constexpr double k_parallel = 1e-3;        // sine between directions whose ways cannot cross
constexpr double k_least_met = 0.02;       // share of the samples
constexpr int k_places_within = 5;         // in the box round an undercut that another action forms
constexpr double k_least_within = 0.1;
constexpr double k_inside = 1e-6;  // of barycentric coordinates: rounding

class Meetings {
 public:
  Meetings(const PartModel& model, const SplitMesh& split, const Release& release, const ActionPlan& plan,
           Ways& known)
      : model_(model), split_(split), release_(release), plan_(plan) {
    std::vector<Undercut> surfaces(plan.actions.size());
    for (std::uint32_t piece = 0; piece < split.pieces.size(); ++piece) {
      const std::int32_t action = plan.action_of_piece[piece];
      if (action < 0 || plan.actions[static_cast<std::size_t>(action)].kind == ActionKind::strip) continue;
      Undercut& surface = surfaces[static_cast<std::size_t>(action)];
      surface.pieces.push_back(piece);
      surface.area += piece_area(split, split.pieces[piece]);
      pieces_.emplace_back(split.pieces[piece].facet, piece);
    }
    std::ranges::sort(pieces_);
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
      if (surfaces[k].area <= 0.0) continue;
      const SideAction& action = plan.actions[k];
      const ActionMove move = move_of(action);
      std::vector<double> key = {static_cast<double>(action.kind),
                                 action.core_side ? 1.0 : 0.0,
                                 move.direction.x,
                                 move.direction.y,
                                 move.direction.z,
                                 move.travel,
                                 move.room,
                                 static_cast<double>(action.undercuts.size())};
      key.insert(key.end(), action.undercuts.begin(), action.undercuts.end());
      key.insert(key.end(), surfaces[k].pieces.begin(), surfaces[k].pieces.end());
      const auto [at, is_new] = known.try_emplace(std::move(key));
      if (is_new)
        at->second = moved({.number = known.size(),
                            .kind = action.kind,
                            .samples = sample_undercut(model, split, surfaces[k], k_way_samples)},
                           move);
      ways_.push_back(at->second);
      ways_.back().action = k;
    }
  }

  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> pairs(MetWays& known) const {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t a = 0; a < ways_.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const auto [at, is_new] = known.try_emplace(std::minmax(ways_[a].number, ways_[b].number));
        if (is_new) at->second = meet(ways_[a], ways_[b]);
        if (at->second) found.emplace_back(ways_[b].action, ways_[a].action);
      }
    }
    return found;
  }

  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> crossing(const MovedAction& one,
                                                                          const MovedAction& other) const {
    const auto ways_of = [&](const MovedAction& action) {
      std::vector<Way> ways;
      const auto its = std::ranges::find(ways_, action.action, &Way::action);
      for (const ActionMove& move : action.moves) {
        if (its != ways_.end()) ways.push_back(moved(*its, move));
      }
      return ways;
    };
    const std::vector<Way> a = ways_of(one), b = ways_of(other);
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        if (meet(a[i], b[j])) found.emplace_back(i, j);
      }
    }
    return found;
  }

 private:
  [[nodiscard]] bool meet(const Way& one, const Way& other) const {
    return crosses(one, other) || crosses(other, one) || passes_through(one, other) ||
           passes_through(other, one);
  }

  /// Whether a slide goes through the undercut that another action forms.
  [[nodiscard]] bool passes_through(const Way& one, const Way& other) const {
    if (!is_slide(one.kind) || share_undercut(one, other)) return false;
    const glm::dvec3 level = glm::normalize(glm::cross(release_.direction(), one.direction));
    const glm::dvec3 upright = glm::cross(one.direction, level);
    const WayReach along = other.extent(one.direction), wide = other.extent(level),
                   high = other.extent(upright);
    std::size_t met = 0;
    for (const UndercutSample& sample : one.samples) {
      const glm::dvec3 from(release_.start(sample, one.direction));
      if (!wide.has(glm::dot(from, level)) || !high.has(glm::dot(from, upright))) continue;
      const double at = glm::dot(from, one.direction);
      const double first = std::max(0.0, along.least - at), last = along.greatest - at;
      for (int place = 0; place < k_places_within && first < last; ++place) {
        const double share = (place + 0.5) / k_places_within;
        if (!is_within(other, from + (first + (last - first) * share) * one.direction)) continue;
        ++met;
        break;
      }
    }
    return static_cast<double>(met) > k_least_within * static_cast<double>(one.samples.size());
  }

  /// What forms an undercut together stands in one space: where the one ends and the other begins is a
  /// choice.
  [[nodiscard]] bool share_undercut(const Way& one, const Way& other) const {
    const std::vector<std::size_t>& undercuts = plan_.actions[other.action].undercuts;
    return std::ranges::any_of(plan_.actions[one.action].undercuts, [&](std::size_t undercut) {
      return std::ranges::find(undercuts, undercut) != undercuts.end();
    });
  }

  /// Whether a point is hidden from both halves, and from one of them by surface that the action forms.
  [[nodiscard]] bool is_within(const Way& way, const glm::dvec3& point) const {
    bool formed = false;
    for (const glm::dvec3& side : {release_.direction(), -release_.direction()}) {
      const auto hit = model_.rays().first_hit(glm::vec3(point), glm::vec3(side), false);
      if (!hit) return false;
      formed = formed || forms(way, *hit, point + static_cast<double>(hit->distance) * side);
    }
    return formed;
  }

  [[nodiscard]] Way moved(const Way& way, const ActionMove& move) const {
    Way other = way;
    other.direction = move.direction;
    other.core_side = move.core_side;
    const double from = way.kind == ActionKind::lifter ? way.extent(move.direction).greatest
                                                       : release_.reach(move.direction) + k_way_beyond;
    other.end = from + (move.travel + move.room) / model_.frame.diagonal;
    return other;
  }

  /// Whether what `one` moves passes where `other` is.
  [[nodiscard]] bool crosses(const Way& one, const Way& other) const {
    const bool lift = one.kind == ActionKind::lifter && other.kind == ActionKind::lifter;
    if (!lift && !(is_slide(one.kind) && is_slide(other.kind))) return false;
    if (lift && one.core_side != other.core_side) return false;
    const glm::dvec3 normal = glm::cross(one.direction, other.direction);
    const bool parallel = glm::length(normal) < k_parallel;
    if (parallel && (!lift || glm::dot(one.direction, other.direction) > 0.0)) return false;
    // Across the other's way, in the plane of both directions.
    const glm::dvec3 across = one.direction - glm::dot(one.direction, other.direction) * other.direction;
    const WayReach level = other.extent(normal), wide = other.extent(across);
    std::size_t met = 0;
    for (const UndercutSample& sample : one.samples) {
      const glm::dvec3 from(release_.start(sample, one.direction));
      double first = 0.0, last = one.end - glm::dot(from, one.direction);
      if (!parallel) {
        const double height = glm::dot(from, normal);
        if (height < level.least || height > level.greatest) continue;
        const double at = glm::dot(from, across), speed = glm::dot(one.direction, across);
        first = std::max(first, (wide.least - at) / speed);
        last = std::min(last, (wide.greatest - at) / speed);
      }
      for (int place = 0; place < k_places && first < last; ++place) {
        // Those that come at each other meet at their ends first.
        const double share =
            parallel ? 1.0 - static_cast<double>(place) / k_places : (place + 0.5) / k_places;
        if (!is_on(other, from + (first + (last - first) * share) * one.direction)) continue;
        ++met;
        break;
      }
    }
    return static_cast<double>(met) > k_least_met * static_cast<double>(one.samples.size());
  }

  [[nodiscard]] bool is_on(const Way& way, const glm::dvec3& point) const {
    if (glm::dot(point, way.direction) > way.end) return false;
    const auto hit = model_.rays().first_hit(glm::vec3(point), glm::vec3(-way.direction), false);
    return hit && forms(way, *hit, point - static_cast<double>(hit->distance) * way.direction);
  }

  /// Whether the action forms the place (unit frame) where a ray met the part.
  [[nodiscard]] bool forms(const Way& way, const ExactRays::Hit& hit, const glm::dvec3& place) const {
    const glm::dvec3 at = model_.frame.center + model_.frame.diagonal * place;
    auto piece = std::ranges::lower_bound(pieces_, hit.facet, {}, &FacetPiece::first);
    for (; piece != pieces_.end() && piece->first == hit.facet; ++piece) {
      if (plan_.action_of_piece[piece->second] == static_cast<std::int32_t>(way.action) &&
          holds(split_.pieces[piece->second].corners, at))
        return true;
    }
    return false;
  }

  /// Of a point in the plane of a piece.
  [[nodiscard]] bool holds(const std::array<VertexIndex, 3>& corners, const glm::dvec3& point) const {
    const glm::dvec3 &a = split_.vertices[corners[0]], &b = split_.vertices[corners[1]],
                     &c = split_.vertices[corners[2]];
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double least = -k_inside * glm::dot(normal, normal);
    return glm::dot(glm::cross(b - a, point - a), normal) >= least &&
           glm::dot(glm::cross(c - b, point - b), normal) >= least &&
           glm::dot(glm::cross(a - c, point - c), normal) >= least;
  }

  const PartModel& model_;
  const SplitMesh& split_;
  const Release& release_;
  const ActionPlan& plan_;
  using FacetPiece = std::pair<FacetIndex, std::uint32_t>;
  std::vector<FacetPiece> pieces_;  // that they form
  std::vector<Way> ways_;
};

}  // namespace

ActionMove move_of(const SideAction& action) {
  const double room = std::clamp(action.clear_to - action.travel, 0.0, action.room_needed);
  return {action.direction, action.travel, room, action.core_side};
}

struct MeetingFinder::Known {
  Ways ways;
  MetWays met;
};

MeetingFinder::MeetingFinder(const PartModel& model, const SplitMesh& split, const Release& release)
    : model_(model), split_(split), release_(release), known_(std::make_unique<Known>()) {}
MeetingFinder::~MeetingFinder() = default;

void MeetingFinder::find(ActionPlan& plan) {
  for (const auto& [a, b] : Meetings(model_, split_, release_, plan, known_->ways).pairs(known_->met)) {
    plan.actions[a].meets.push_back(b);
    plan.actions[b].meets.push_back(a);
  }
  for (SideAction& action : plan.actions) std::ranges::sort(action.meets);
}

std::vector<std::pair<std::size_t, std::size_t>> MeetingFinder::crossing_moves(const ActionPlan& plan,
                                                                               const MovedAction& one,
                                                                               const MovedAction& other) {
  return Meetings(model_, split_, release_, plan, known_->ways).crossing(one, other);
}

}  // namespace moldlight
