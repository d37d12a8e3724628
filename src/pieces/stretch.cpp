#include "pieces/stretch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <tbb/parallel_for.h>

namespace moldlight {

namespace {

constexpr std::size_t k_most_heights = 96, k_place_samples = 64;
constexpr double k_beside = 1e-7;        // of a vertex, where a section lies, in diagonals
constexpr double k_round_share = 0.5;    // of an outline, for an undercut to go round it
constexpr double k_least_round = 0.05;   // square of an outline's perimeter, of the undercut's area
constexpr double k_least_strain = 1e-3;  // else nothing has to widen
constexpr double k_cut_off = 0.02;       // of a perimeter
constexpr int k_ways = 24;               // across the pull that are tried for a sample
constexpr int k_steps = 48, k_halvings = 20;
constexpr float k_off_surface = 1e-4F;  // unit frame
constexpr double k_infinite = std::numeric_limits<double>::infinity();

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// An outline of a section: the solid lies on its left.
struct Outline {
  std::vector<glm::dvec2> points;
  std::vector<FacetIndex> facets;  // of the stretch that ends at each point
  std::vector<double> lengths;     // of it
  double perimeter = 0.0, area = 0.0;
  glm::dvec2 low{k_infinite}, high{-k_infinite};
  std::vector<std::size_t> next;  // outlines of the same sense over it, in the section after this
  bool closed = false;            // a hole whose air ends there

  [[nodiscard]] bool is_hole() const { return area < 0.0; }
};

/// Length of the band around the points.
double band(std::vector<glm::dvec2> points) {
  std::ranges::sort(points,
                    [](const auto& a, const auto& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
  double length = 0.0;
  std::vector<glm::dvec2> hull;
  for (int half = 0; half < 2; ++half) {
    hull.clear();
    for (const glm::dvec2& point : points) {
      while (hull.size() > 1 && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0)
        hull.pop_back();
      hull.push_back(point);
    }
    for (std::size_t k = 1; k < hull.size(); ++k) length += glm::distance(hull[k - 1], hull[k]);
    std::ranges::reverse(points);
  }
  return length;
}

bool holds(const Outline& outline, const glm::dvec2& point) {
  if (point.x < outline.low.x || point.x > outline.high.x || point.y < outline.low.y ||
      point.y > outline.high.y)
    return false;
  bool inside = false;
  for (std::size_t k = 0; k < outline.points.size(); ++k) {
    const glm::dvec2 &a = outline.points[k], &b = outline.points[(k + 1) % outline.points.size()];
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y))
      inside = !inside;
  }
  return inside;
}

/// By a few of their corners.
bool overlap(const Outline& a, const Outline& b) {
  if (a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y) return false;
  constexpr std::size_t k_corners = 8;
  for (std::size_t k = 0; k < k_corners; ++k) {
    if (holds(b, a.points[k * a.points.size() / k_corners]) ||
        holds(a, b.points[k * b.points.size() / k_corners]))
      return true;
  }
  return false;
}

/// The sections of a part across one direction, and what a band on each outline meets on its way along it.
class Sections {
 public:
  Sections(const PartModel& model, const glm::dvec3& direction, const Progress& progress)
      : model_(model), direction_(direction) {
    const glm::dvec3 axis = std::abs(direction.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    right_ = glm::normalize(glm::cross(axis, direction));
    up_ = glm::cross(direction, right_);
    for (const glm::dvec3& vertex : model.part.mesh.vertices) reach_.push_back(glm::dot(vertex, direction));
    const double beside = k_beside * model.frame.diagonal;
    std::vector<double> vertices = reach_;
    std::ranges::sort(vertices);
    std::vector<double> heights;
    for (const double height : vertices)
      if (heights.empty() || height > heights.back() + 4.0 * beside) heights.push_back(height);
    const std::size_t count = std::min(heights.size(), k_most_heights);
    for (std::size_t k = 0; k < count; ++k) {
      const double height = heights[k * (heights.size() - 1) / std::max<std::size_t>(count - 1, 1)];
      heights_.insert(heights_.end(), {height - beside, height + beside});
    }
    sections_.resize(heights_.size());
    tbb::parallel_for(std::size_t{0}, heights_.size(), [&](std::size_t k) {
      if (!progress.cancelled()) cut(k);
    });
    if (progress.cancelled()) throw Cancelled();
    tbb::parallel_for(std::size_t{0}, sections_.size() - 1, [&](std::size_t k) { follow(k); });
  }

  /// That asks for the greatest strain, of what the polygons go round; none where they go round nothing. The
  /// perimeter is 0 where the way is closed.
  [[nodiscard]] std::optional<Neck> neck(std::span<const LeftPolygon> left, const LeftPlace& place) const {
    std::map<FacetIndex, std::pair<double, double>> spans;
    for (const std::size_t polygon : place.polygons) {
      auto [span, added] = spans.try_emplace(left[polygon].facet, k_infinite, -k_infinite);
      for (const glm::dvec3& corner : left[polygon].corners) {
        span->second.first = std::min(span->second.first, glm::dot(corner, direction_));
        span->second.second = std::max(span->second.second, glm::dot(corner, direction_));
      }
    }
    std::optional<Neck> worst;
    for (std::size_t k = 0; k < heights_.size(); ++k) {
      for (const Outline& outline : sections_[k]) {
        double round = 0.0;
        for (std::size_t i = 0; i < outline.facets.size(); ++i) {
          const auto found = spans.find(outline.facets[i]);
          if (found != spans.end() && found->second.first <= heights_[k] &&
              heights_[k] <= found->second.second)
            round += outline.lengths[i];
        }
        if (round < k_round_share * outline.perimeter ||
            outline.perimeter * outline.perimeter < k_least_round * place.area)
          continue;
        const Neck neck = neck_of(k, outline);
        if (!worst || neck.strain() > worst->strain()) worst = neck;
      }
    }
    return worst && worst->strain() < k_least_strain ? std::nullopt : worst;
  }

 private:
  [[nodiscard]] Neck neck_of(std::size_t number, const Outline& outline) const;
  void cut(std::size_t number);
  void follow(std::size_t number);
  [[nodiscard]] bool is_closed_above(const Outline& hole, std::size_t above) const;

  const PartModel& model_;
  glm::dvec3 direction_, right_{}, up_{};
  std::vector<double> reach_, heights_;  // of vertices, of sections, rising
  std::vector<std::vector<Outline>> sections_;
};

void Sections::cut(std::size_t number) {
  const TriangleMesh& mesh = model_.part.mesh;
  const double height = heights_[number];
  const auto is_above = [&](VertexIndex vertex) { return reach_[vertex] > height; };
  /// The side through which a facet is left with the solid on the left.
  const auto way_out = [&](FacetIndex facet) -> int {
    for (int k = 0; k < 3; ++k) {
      const auto& corners = mesh.facets[facet];
      if (!is_above(corners[static_cast<std::size_t>(k)]) &&
          is_above(corners[static_cast<std::size_t>((k + 1) % 3)]))
        return k;
    }
    return -1;
  };
  std::vector<std::uint8_t> passed(mesh.facets.size(), 0);
  for (FacetIndex first = 0; first < mesh.facets.size(); ++first) {
    if (passed[first] != 0 || way_out(first) < 0) continue;
    Outline outline;
    FacetIndex facet = first;
    while (facet != k_no_facet && passed[facet] == 0) {
      passed[facet] = 1;
      const auto side = static_cast<std::size_t>(way_out(facet));
      const VertexIndex a = mesh.facets[facet][side], b = mesh.facets[facet][(side + 1) % 3];
      const glm::dvec3 at = mesh.vertices[a] + (mesh.vertices[b] - mesh.vertices[a]) *
                                                   ((height - reach_[a]) / (reach_[b] - reach_[a]));
      outline.points.emplace_back(glm::dot(at, right_), glm::dot(at, up_));
      outline.facets.push_back(facet);
      outline.low = glm::min(outline.low, outline.points.back());
      outline.high = glm::max(outline.high, outline.points.back());
      facet = model_.adjacency.across[facet][side];
    }
    if (facet != first) continue;  // open
    for (std::size_t k = 0; k < outline.points.size(); ++k) {
      const glm::dvec2 &before = outline.points[(k + outline.points.size() - 1) % outline.points.size()],
                       &here = outline.points[k];
      outline.lengths.push_back(glm::distance(before, here));
      outline.perimeter += outline.lengths.back();
      outline.area += 0.5 * cross(before - outline.points[0], here - outline.points[0]);
    }
    if (outline.perimeter > 0.0) sections_[number].push_back(std::move(outline));
  }
}

/// Of a hole whose air ends there.
bool Sections::is_closed_above(const Outline& hole, std::size_t above) const {
  const double off = 1e-3 * glm::distance(hole.low, hole.high);
  std::size_t inside = 0, asked = 0;
  for (std::size_t k = 0; k < hole.points.size(); ++k, ++asked) {
    const glm::dvec2 &a = hole.points[k], &b = hole.points[(k + 1) % hole.points.size()];
    const double length = glm::distance(a, b);
    const glm::dvec2 at =
        0.5 * (a + b) + (length > 0.0 ? off / length : 0.0) * glm::dvec2(b.y - a.y, a.x - b.x);
    int around = 0;
    for (const Outline& outline : sections_[above])
      around += holds(outline, at) ? (outline.is_hole() ? -1 : 1) : 0;
    inside += around > 0 ? 1 : 0;
  }
  return 2 * inside > asked;
}

void Sections::follow(std::size_t number) {
  for (Outline& outline : sections_[number]) {
    const std::vector<Outline>& above = sections_[number + 1];
    for (std::size_t k = 0; k < above.size(); ++k)
      if (above[k].is_hole() == outline.is_hole() && overlap(outline, above[k])) outline.next.push_back(k);
    outline.closed = outline.is_hole() && outline.next.empty() && is_closed_above(outline, number + 1);
  }
}

/// How far outlines reach from a point, in even steps all round.
class Reach {
 public:
  Reach(const glm::dvec2& centre, bool hole)
      : centre_(centre), hole_(hole), far_(k_rays, hole ? k_infinite : 0.0) {}

  /// The nearest of what bounds a hole, the farthest of what does not.
  void add(const Outline& outline) {
    constexpr double k_step = 2.0 * std::numbers::pi / k_rays;
    all_round_ = all_round_ && (!hole_ || holds(outline, centre_));
    for (std::size_t k = 0; k < outline.points.size(); ++k) {
      const glm::dvec2 from = outline.points[k] - centre_,
                       way = outline.points[(k + 1) % outline.points.size()] - outline.points[k];
      const double first = std::atan2(from.y, from.x),
                   turn = std::atan2(cross(from, way), glm::dot(from, from + way));
      const double low = std::min(first, first + turn), high = std::max(first, first + turn);
      for (double at = std::ceil(low / k_step); at * k_step <= high; at += 1.0) {
        const glm::dvec2 ray(std::cos(at * k_step), std::sin(at * k_step));
        const double far = cross(from, way) / cross(ray, way);
        if (!(far > 0.0 && far < k_infinite)) continue;
        double& kept = far_[static_cast<std::size_t>(static_cast<int>(at) + 2 * k_rays) % k_rays];
        kept = hole_ ? std::min(kept, far) : std::max(kept, far);
      }
    }
  }
  /// Of what is within reach of all that was added, or of any, as a band has it; none where a hole has left
  /// the point.
  [[nodiscard]] std::optional<double> perimeter() const {
    if (!all_round_) return std::nullopt;
    std::vector<glm::dvec2> points;
    for (int k = 0; k < k_rays; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / k_rays, far = far_[static_cast<std::size_t>(k)];
      if (far < k_infinite) points.push_back(far * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    if (!hole_) return band(std::move(points));
    double length = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k)
      length += glm::distance(points[k], points[(k + 1) % points.size()]);
    return length;
  }

 private:
  static constexpr int k_rays = 360;
  glm::dvec2 centre_;
  bool hole_, all_round_ = true;
  std::vector<double> far_;
};

/// Straight along the direction: what winds up, as a thread, is in the way all round.
Neck Sections::neck_of(std::size_t number, const Outline& outline) const {
  const bool hole = outline.is_hole();
  glm::dvec2 centre(0.0);
  for (const glm::dvec2& point : outline.points) centre += point / static_cast<double>(outline.points.size());
  Reach reach(centre, hole);
  reach.add(outline);
  Neck neck{.perimeter = outline.perimeter, .widest = band(outline.points)};
  if (hole) neck.perimeter = std::max(neck.perimeter, neck.widest);  // what it is itself is no throat
  std::vector<std::size_t> here = {static_cast<std::size_t>(&outline - sections_[number].data())};
  for (; !here.empty() && number + 1 < sections_.size(); ++number) {
    std::vector<std::size_t> next;
    for (const std::size_t k : here) {
      const Outline& at = sections_[number][k];
      if (at.closed) return {.perimeter = 0.0, .widest = neck.widest};
      next.insert(next.end(), at.next.begin(), at.next.end());
    }
    std::ranges::sort(next);
    next.erase(std::unique(next.begin(), next.end()), next.end());
    std::vector<glm::dvec2> all;
    double greatest = 0.0;
    for (const std::size_t k : next) {
      const Outline& above = sections_[number + 1][k];
      all.insert(all.end(), above.points.begin(), above.points.end());
      greatest = std::max(greatest, above.perimeter);
      reach.add(above);
    }
    if (hole && !next.empty()) neck.perimeter = std::min(neck.perimeter, greatest);
    if (!hole && !next.empty()) neck.widest = std::max(neck.widest, band(std::move(all)));
    here = std::move(next);
  }
  // Between rays corners are cut off: only what differs by more is another perimeter.
  const double swept = reach.perimeter().value_or(neck.perimeter);
  if (hole && swept < (1.0 - k_cut_off) * neck.perimeter) neck.perimeter = swept;
  if (!hole) neck.widest = std::max(neck.widest, swept);
  neck.perimeter = std::min(neck.perimeter, neck.widest);
  return neck;
}

/// How far the material on a sample must move across the pull until nothing is in its way, in the unit frame.
std::optional<double> depth_at(const PartModel& model, const SurfaceSample& sample,
                               const glm::dvec3& direction) {
  const glm::dvec3& normal = model.geometry.normals[sample.facet];
  const glm::dvec3 across = normal - glm::dot(normal, direction) * direction;
  if (glm::length(across) < 0.05) return std::nullopt;
  const glm::dvec3 ahead = glm::normalize(across), beside = glm::cross(direction, ahead);
  const glm::vec3 from = sample.position + k_off_surface * glm::vec3(normal), along(direction);
  const auto is_free = [&](const glm::vec3& at) { return !model.rays().first_hit(at, along, false); };
  std::optional<double> least;
  for (int way = -k_ways / 4; way <= k_ways / 4; ++way) {
    const double turn = 2.0 * std::numbers::pi * way / k_ways;
    const glm::vec3 to(std::cos(turn) * ahead + std::sin(turn) * beside);
    const auto wall = model.rays().first_hit(from, to, false);
    const double most = std::min(wall ? static_cast<double>(wall->distance) : 1.0, least.value_or(1.0));
    const auto at = [&](double far) { return from + static_cast<float>(far) * to; };
    for (int step = 0; step <= k_steps; ++step) {
      double far = most * step / k_steps;
      if (!is_free(at(far))) continue;
      double blocked = step == 0 ? 0.0 : most * (step - 1) / k_steps;
      for (int k = 0; k < k_halvings; ++k) {
        const double middle = 0.5 * (blocked + far);
        (is_free(at(middle)) ? far : blocked) = middle;
      }
      least = std::min(least.value_or(far), far);
      break;
    }
  }
  return least;
}

}  // namespace

std::vector<StretchedUndercut> stretches(const PartModel& model, std::span<const glm::dvec3> directions,
                                         std::span<const LeftPolygon> left, std::span<const LeftPlace> places,
                                         const Progress& progress) {
  std::vector<StretchedUndercut> found(places.size());
  std::vector<std::tuple<double, double>> best(places.size(), {k_infinite, k_infinite});
  std::vector<std::vector<SurfaceSample>> samples;
  for (const LeftPlace& place : places) {
    std::vector<LeftPolygon> own;
    for (const std::size_t polygon : place.polygons) own.push_back(left[polygon]);
    samples.push_back(left_samples(model, own, k_place_samples));
  }
  for (std::uint32_t d = 0; d < directions.size(); ++d) {
    progress.report("measuring undercuts", static_cast<double>(d) / static_cast<double>(directions.size()));
    const Sections sections(model, directions[d], progress);
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t k) {
      if (progress.cancelled()) return;
      StretchedUndercut stretch{
          .place = k, .direction = d, .depth = {}, .neck = sections.neck(left, places[k])};
      std::size_t asked = 0, free = 0;
      for (const SurfaceSample& sample : samples[k]) {
        const glm::dvec3& normal = model.geometry.normals[sample.facet];
        asked += std::abs(glm::dot(normal, directions[d])) < 0.998 ? 1 : 0;
        if (const auto depth = depth_at(model, sample, directions[d])) {
          ++free;
          stretch.depth = std::max(stretch.depth.value_or(0.0), *depth * model.frame.diagonal);
        }
      }
      if (2 * free < asked) stretch.depth.reset();
      const std::tuple cost(stretch.neck ? stretch.neck->strain() : 0.0, stretch.depth.value_or(k_infinite));
      if (d != 0 && cost >= best[k]) return;
      best[k] = cost;
      found[k] = stretch;
    });
    if (progress.cancelled()) throw Cancelled();
  }
  for (StretchedUndercut& stretch : found)
    if (stretch.neck && !(stretch.neck->strain() < k_infinite))
      stretch = {.place = stretch.place, .direction = stretch.direction};
  return found;
}

}  // namespace moldlight
