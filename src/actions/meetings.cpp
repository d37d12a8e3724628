// A point is on the way of a slide if a ray from it against the slide's direction first meets the part on the
// surface that the slide forms.
#include "actions/meetings.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

constexpr std::size_t k_asked = 64;   // samples of a slide
constexpr int k_places = 16;          // on the way of each, where the other may be
constexpr double k_beyond = 0.08;     // the part, share of the diagonal
constexpr double k_parallel = 1e-3;   // sine between directions whose ways cannot cross
constexpr double k_least_met = 0.02;  // share of the samples
constexpr double k_inside = 1e-6;     // of barycentric coordinates: rounding

struct Reach {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  void take(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
};

/// In the unit frame.
struct Way {
  std::size_t action = 0;
  glm::dvec3 direction{1, 0, 0};
  double end = 0.0;  // along the direction
  std::vector<UndercutSample> samples;

  [[nodiscard]] Reach extent(const glm::dvec3& along) const {
    Reach reach;
    for (const UndercutSample& sample : samples) reach.take(glm::dot(glm::dvec3(sample.position), along));
    return reach;
  }
};

class Meetings {
 public:
  Meetings(const PartModel& model, const SplitMesh& split, const Release& release, const ActionPlan& plan)
      : model_(model), split_(split), release_(release), plan_(plan) {
    std::vector<Undercut> surfaces(plan.actions.size());
    for (std::uint32_t piece = 0; piece < split.pieces.size(); ++piece) {
      const std::int32_t action = plan.action_of_piece[piece];
      if (action < 0 || !is_slide(plan.actions[static_cast<std::size_t>(action)].kind)) continue;
      Undercut& surface = surfaces[static_cast<std::size_t>(action)];
      surface.pieces.push_back(piece);
      surface.area += piece_area(split, split.pieces[piece]);
      pieces_.emplace(split.pieces[piece].facet, piece);
    }
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
      if (surfaces[k].area <= 0.0) continue;
      ways_.push_back({.action = k, .samples = sample_undercut(model, split, surfaces[k], k_asked)});
      const SideAction& action = plan.actions[k];
      ways_.back() = moved(ways_.back(), {action.direction, action.travel});
    }
  }

  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> pairs() const {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t a = 0; a < ways_.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (crosses(ways_[a], ways_[b]) || crosses(ways_[b], ways_[a]))
          found.emplace_back(ways_[b].action, ways_[a].action);
      }
    }
    return found;
  }

  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> crossing(const MovedSlide& one,
                                                                          const MovedSlide& other) const {
    const auto ways_of = [&](const MovedSlide& slide) {
      std::vector<Way> ways;
      const auto its = std::ranges::find(ways_, slide.action, &Way::action);
      for (const SlideMove& move : slide.moves) {
        if (its != ways_.end()) ways.push_back(moved(*its, move));
      }
      return ways;
    };
    const std::vector<Way> a = ways_of(one), b = ways_of(other);
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        if (crosses(a[i], b[j]) || crosses(b[j], a[i])) found.emplace_back(i, j);
      }
    }
    return found;
  }

 private:
  [[nodiscard]] Way moved(const Way& way, const SlideMove& move) const {
    Way other = way;
    other.direction = move.direction;
    other.end = release_.reach(move.direction) + k_beyond + move.travel / model_.frame.diagonal;
    return other;
  }

  /// Whether what `one` moves passes where `other` is.
  [[nodiscard]] bool crosses(const Way& one, const Way& other) const {
    const glm::dvec3 normal = glm::cross(one.direction, other.direction);
    if (glm::length(normal) < k_parallel) return false;
    // Across the other's way, in the plane of both directions.
    const glm::dvec3 across = one.direction - glm::dot(one.direction, other.direction) * other.direction;
    const Reach level = other.extent(normal), wide = other.extent(across);
    std::size_t met = 0;
    for (const UndercutSample& sample : one.samples) {
      const glm::dvec3 from(sample.position);
      const double height = glm::dot(from, normal);
      if (height < level.least || height > level.greatest) continue;
      const double at = glm::dot(from, across), speed = glm::dot(one.direction, across);
      const double first = std::max(0.0, (wide.least - at) / speed);
      const double last = std::min(one.end - glm::dot(from, one.direction), (wide.greatest - at) / speed);
      for (int place = 0; place < k_places && first < last; ++place) {
        const double gone = first + (last - first) * (place + 0.5) / k_places;
        if (!is_on(other, from + gone * one.direction)) continue;
        ++met;
        break;
      }
    }
    return static_cast<double>(met) > k_least_met * static_cast<double>(one.samples.size());
  }

  [[nodiscard]] bool is_on(const Way& way, const glm::dvec3& point) const {
    if (glm::dot(point, way.direction) > way.end) return false;
    const auto hit = model_.rays().first_hit(glm::vec3(point), glm::vec3(-way.direction), false);
    if (!hit) return false;
    const glm::dvec3 at =
        model_.frame.center +
        model_.frame.diagonal * (point - static_cast<double>(hit->distance) * way.direction);
    const auto [begin, end] = pieces_.equal_range(hit->facet);
    return std::any_of(begin, end, [&](const auto& entry) {
      return plan_.action_of_piece[entry.second] == static_cast<std::int32_t>(way.action) &&
             holds(split_.pieces[entry.second].corners, at);
    });
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
  std::unordered_multimap<FacetIndex, std::uint32_t> pieces_;  // that slides form, by their facet
  std::vector<Way> ways_;
};

}  // namespace

void find_meetings(const PartModel& model, const SplitMesh& split, const Release& release, ActionPlan& plan) {
  for (const auto& [a, b] : Meetings(model, split, release, plan).pairs()) {
    plan.actions[a].meets.push_back(b);
    plan.actions[b].meets.push_back(a);
  }
  for (SideAction& action : plan.actions) std::ranges::sort(action.meets);
}

std::vector<std::pair<std::size_t, std::size_t>> crossing_moves(const PartModel& model,
                                                                const SplitMesh& split,
                                                                const Release& release,
                                                                const ActionPlan& plan, const MovedSlide& one,
                                                                const MovedSlide& other) {
  return Meetings(model, split, release, plan).crossing(one, other);
}

}  // namespace moldlight
