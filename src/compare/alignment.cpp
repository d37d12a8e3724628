#include "compare/alignment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include "base/numbers.hpp"
#include "compare/overlay.hpp"
#include "mesh/faces.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/symmetric_eigen.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_few_samples = 250, k_samples = 3000;
constexpr std::size_t k_starts_tried = 24, k_starts_followed = 3;
constexpr int k_most_steps = 60;
/// Shares of the diagonal: points farther off than that have no part in a step; the last is above rounding.
constexpr double k_first_reach = 0.05, k_last_reach = 1e-6, k_reach_shrinks = 0.7;
/// Moments nearer to each other than this share do not distinguish axes.
constexpr double k_alike_moments = 0.02;
constexpr int k_turns = 24;

struct Placement {
  glm::dmat3 rotation{1.0};
  glm::dvec3 shift{0.0};
};

struct Frame {
  glm::dvec3 centre{0.0};
  std::array<double, 3> moments{};
  std::array<glm::dvec3, 3> axes{};
};

/// Of the surface: its centre and the principal axes of its area.
Frame principal_frame(const PartModel& model) {
  const TriangleMesh& mesh = model.part.mesh;
  Frame frame;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet)
    frame.centre += model.geometry.areas[facet] * mesh.middle(facet);
  if (model.geometry.total_area > 0.0) frame.centre /= model.geometry.total_area;
  glm::dmat3 sum(0.0);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    // Exact for a square function: the middles of the edges.
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 at = 0.5 * (mesh.corner(facet, k) + mesh.corner(facet, (k + 1) % 3)) - frame.centre;
      sum += model.geometry.areas[facet] / 3.0 * glm::outerProduct(at, at);
    }
  }
  const auto eigen = symmetric_eigen<3>(sum);
  for (std::size_t k = 0; k < 3; ++k) {
    frame.moments[k] = eigen.values[k];
    frame.axes[k] = eigen.vectors[k];
  }
  return frame;
}

glm::dmat3 about(const glm::dvec3& axis, double angle) {
  return glm::mat3_cast(glm::angleAxis(angle, glm::normalize(axis)));
}

/// Rotations that take the axes of `b` to those of `a`; where moments are alike, turns of them, too.
std::vector<glm::dmat3> starts(const Frame& a, const Frame& b) {
  std::vector<glm::dmat3> rotations = {glm::dmat3(1.0)};
  const glm::dmat3 to_a(a.axes[0], a.axes[1], a.axes[2]);
  const auto add = [&](const glm::dmat3& turned_a) {
    for (int signs = 0; signs < 8; ++signs) {
      const auto sign = [&](int bit) { return (signs >> bit & 1) != 0 ? -1.0 : 1.0; };
      const glm::dmat3 from_b(sign(0) * b.axes[0], sign(1) * b.axes[1], sign(2) * b.axes[2]);
      const glm::dmat3 rotation = turned_a * glm::transpose(from_b);
      if (glm::determinant(rotation) > 0.0) rotations.push_back(rotation);
    }
  };
  const auto alike = [&](std::size_t i, std::size_t k) {
    return std::abs(a.moments[i] - a.moments[k]) <= k_alike_moments * a.moments[2];
  };
  const bool low = alike(0, 1), high = alike(1, 2);
  if (!low && !high) add(to_a);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool free = axis == 2 ? low : axis == 0 ? high : low && high;
    for (int turn = 0; free && turn < k_turns; ++turn)
      add(about(a.axes[axis], std::numbers::pi * turn / k_turns) * to_a);
  }
  return rotations;
}

struct SurfacePoint {
  glm::dvec3 point, normal;
  double distance = 0.0;
  FacetIndex facet = k_no_facet;
};

/// The sooner the nearer `guess` is; the same whatever it is.
SurfacePoint nearest_on(const PartModel& part, const glm::dvec3& from, FacetIndex guess = k_no_facet) {
  const TriangleMesh& mesh = part.part.mesh;
  const double diagonal = part.frame.diagonal;
  SurfacePoint best{from, {0, 0, 1}, std::numeric_limits<double>::infinity(), k_no_facet};
  const glm::dvec3 outside = glm::max(glm::dvec3(0.0), glm::abs(from - part.frame.center) - 0.5 * diagonal);
  const auto reach = static_cast<float>((glm::length(outside) / diagonal + 2.0));
  const auto visit = [&](FacetIndex facet) {
    const glm::dvec3 at =
        nearest_in_triangle(from, {mesh.corner(facet, 0), mesh.corner(facet, 1), mesh.corner(facet, 2)});
    const double distance = glm::distance(at, from);
    // Facets that meet in an edge are equally near: the lowest decides, in whatever order they are visited.
    if (distance < best.distance || (distance == best.distance && facet < best.facet))
      best = {at, part.geometry.normals[facet], distance, facet};
    return std::min(reach, static_cast<float>(1.0001 * best.distance / diagonal) + 1e-6F);
  };
  part.rays().visit_near(part.frame.to_unit(from), guess != k_no_facet ? visit(guess) : reach, visit);
  return best;
}

/// Samples of B's surface, even, mirrored across x if asked for.
std::vector<glm::dvec3> even_samples(const PartModel& model, std::size_t count, bool mirrored) {
  const SurfaceSamples samples = sample_surface_evenly(model.part.mesh, model.geometry, model.frame, count);
  std::vector<glm::dvec3> points;
  for (const SurfaceSample& sample : samples.samples) {
    glm::dvec3 point = model.frame.center + model.frame.diagonal * glm::dvec3(sample.position);
    if (mirrored) point.x = -point.x;
    points.push_back(point);
  }
  return points;
}

/// `former`: those of a placement nearby, or none.
std::vector<SurfacePoint> nearest_points(const PartModel& a, const std::vector<glm::dvec3>& points,
                                         const Placement& placement, std::vector<SurfacePoint> former = {}) {
  std::vector<SurfacePoint> nearest = std::move(former);
  nearest.resize(points.size());
  // A task is worth its start: there are a hundred steps, each of which waits for the last one.
  constexpr std::size_t k_grain = 64;
  tbb::parallel_for(tbb::blocked_range(std::size_t{0}, points.size(), k_grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t k = range.begin(); k < range.end(); ++k)
                        nearest[k] =
                            nearest_on(a, placement.rotation * points[k] + placement.shift, nearest[k].facet);
                    });
  return nearest;
}

double median_distance(const std::vector<SurfacePoint>& nearest) {
  std::vector<double> distances;
  for (const SurfacePoint& one : nearest) distances.push_back(one.distance);
  return distances.empty() ? 0.0 : median(distances);
}

/// Mean distance, what is far off counting as if it were a 50th of the diagonal off.
double misfit(const PartModel& a, const std::vector<SurfacePoint>& nearest) {
  const double most = 0.02 * a.frame.diagonal;
  double sum = 0.0;
  for (const SurfacePoint& one : nearest) sum += std::min(one.distance, most);
  return nearest.empty() ? 0.0 : sum / static_cast<double>(nearest.size());
}

using Vector6 = std::array<double, 6>;
using Matrix6 = std::array<Vector6, 6>;

/// Solves a symmetric positive system by elimination.
Vector6 solved(Matrix6 matrix, Vector6 right) {
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t row = k + 1; row < 6; ++row) {
      const double factor = matrix[row][k] / matrix[k][k];
      for (std::size_t column = k; column < 6; ++column) matrix[row][column] -= factor * matrix[k][column];
      right[row] -= factor * right[k];
    }
  }
  for (std::size_t k = 6; k-- > 0;) {
    for (std::size_t column = k + 1; column < 6; ++column) right[k] -= matrix[k][column] * right[column];
    right[k] /= matrix[k][k];
  }
  return right;
}

/// One step: the small motion after which the points lie best on the planes of their nearest ones. Points
/// farther off than `most` and three times the median have no part in it. Returns how far it moves the part,
/// as share of its size. `nearest`: those of the step before, or none; then those of this one.
double step(const PartModel& a, const std::vector<glm::dvec3>& points, double most, Placement& placement,
            std::vector<SurfacePoint>& nearest) {
  nearest = nearest_points(a, points, placement, std::move(nearest));
  most = std::max(most, 3.0 * median_distance(nearest));
  const double size = a.frame.diagonal;
  Matrix6 matrix{};
  Vector6 right{};
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (nearest[k].distance > most) continue;
    const glm::dvec3 at = (placement.rotation * points[k] + placement.shift - a.frame.center) / size;
    const glm::dvec3 turning = glm::cross(at, nearest[k].normal);
    const Vector6 row = {turning.x,           turning.y,           turning.z,
                         nearest[k].normal.x, nearest[k].normal.y, nearest[k].normal.z};
    const double off = glm::dot(nearest[k].normal, (nearest[k].point - a.frame.center) / size - at);
    for (std::size_t i = 0; i < 6; ++i) {
      right[i] += row[i] * off;
      for (std::size_t j = 0; j < 6; ++j) matrix[i][j] += row[i] * row[j];
    }
  }
  // What turns or slides along itself is held by nothing else.
  double trace = 0.0;
  for (std::size_t i = 0; i < 6; ++i) trace += matrix[i][i];
  if (trace <= 0.0) return 0.0;
  for (std::size_t i = 0; i < 6; ++i) matrix[i][i] += 1e-9 * trace;
  const Vector6 motion = solved(matrix, right);
  const glm::dvec3 turn(motion[0], motion[1], motion[2]), shift(motion[3], motion[4], motion[5]);
  const double angle = glm::length(turn);
  const glm::dmat3 rotation = angle > 0.0 ? about(turn, angle) : glm::dmat3(1.0);
  placement.shift = rotation * (placement.shift - a.frame.center) + a.frame.center + size * shift;
  placement.rotation = rotation * placement.rotation;
  return angle + glm::length(shift);
}

/// Steps until it rests. What stayed lies ever nearer, faster than the reach shrinks; what changed is left
/// out in the end. By the median alone, planes that slide along themselves would be most, and the few that
/// hold them left out.
void settle(const PartModel& a, const std::vector<glm::dvec3>& points, Placement& placement,
            const Progress& progress) {
  double most = k_first_reach * a.frame.diagonal;
  std::vector<SurfacePoint> nearest;
  for (int k = 0; k < k_most_steps; ++k) {
    progress.report("aligning", 0.0);
    const bool rests = step(a, points, most, placement, nearest) < 1e-13;
    if (rests && most <= k_last_reach * a.frame.diagonal) break;
    most = std::max(k_reach_shrinks * most, k_last_reach * a.frame.diagonal);
  }
}

struct Fit {
  Placement placement;
  double misfit = 0.0;
};

Fit best_fit(const PartModel& a, const PartModel& b, bool mirrored, const Progress& progress) {
  Frame from = principal_frame(b);
  if (mirrored) {
    from.centre.x = -from.centre.x;
    for (glm::dvec3& axis : from.axes) axis.x = -axis.x;
  }
  const Frame to = principal_frame(a);
  const std::vector<glm::dvec3> few = even_samples(b, k_few_samples, mirrored),
                                many = even_samples(b, k_samples, mirrored);
  std::vector<Fit> fits = {{Placement{}, 0.0}};  // as it lies
  for (const glm::dmat3& rotation : starts(to, from))
    fits.push_back({{rotation, to.centre - rotation * from.centre}, 0.0});
  const auto measure = [&](Fit& fit, const std::vector<glm::dvec3>& points) {
    progress.report("aligning", 0.0);
    fit.misfit = misfit(a, nearest_points(a, points, fit.placement));
  };
  // Of a part that is nearly its own image the few samples find which of its poses is the exact one.
  for (Fit& fit : fits) measure(fit, few);
  for (const auto& [points, followed] :
       {std::pair(&few, k_starts_tried), std::pair(&many, k_starts_followed)}) {
    std::ranges::stable_sort(fits, {}, &Fit::misfit);
    fits.resize(std::min(fits.size(), followed));
    for (Fit& fit : fits) {
      settle(a, *points, fit.placement, progress);
      measure(fit, *points);
    }
  }
  // The first of those that are alike but for rounding.
  Fit best = fits.front();
  for (const Fit& fit : fits)
    if (fit.misfit < best.misfit - 1e-7 * a.frame.diagonal) best = fit;
  return best;
}

Alignment measured(const PartModel& a, const PartModel& b, const Placement& placement) {
  Alignment alignment{.rotation = placement.rotation, .shift = placement.shift};
  const std::vector<SurfacePoint> nearest = nearest_points(a, even_samples(b, k_samples, false), placement);
  double squares = 0.0;
  for (const SurfacePoint& one : nearest) {
    squares += one.distance * one.distance;
    alignment.largest = std::max(alignment.largest, one.distance);
  }
  if (!nearest.empty()) alignment.rms = std::sqrt(squares / static_cast<double>(nearest.size()));
  alignment.median = median_distance(nearest);
  return alignment;
}

/// A part with even samples of its surface, and how far its facets may be off.
struct SampledSide {
  const PartModel& model;
  std::vector<glm::dvec3> points;
  std::vector<FacetIndex> facets;  // of the points
  std::vector<double> chords;      // of the facets

  explicit SampledSide(const PartModel& part)
      : model(part),
        points(even_samples(part, k_samples, false)),
        chords(chord_deviation(part, part_faces(part.part, part.geometry, part.adjacency)).normal) {
    for (const SurfaceSample& sample :
         sample_surface_evenly(part.part.mesh, part.geometry, part.frame, k_samples).samples)
      facets.push_back(sample.facet);
  }
  /// Points that are farther off the other part than `apart` and what both tessellations may be off there;
  /// `put` lays them on it, where lengths are `factor` times as long.
  double count_off(const SampledSide& other, const std::function<glm::dvec3(const glm::dvec3&)>& put,
                   double apart, double factor) const {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, points.size()), 0.0,
        [&](const tbb::blocked_range<std::size_t>& range, double sum) {
          for (std::size_t k = range.begin(); k < range.end(); ++k) {
            const SurfacePoint nearest = nearest_on(other.model, put(points[k]));
            if (nearest.facet == k_no_facet ||
                nearest.distance > factor * apart + chords[facets[k]] + other.chords[nearest.facet])
              sum += 1.0;
          }
          return sum;
        },
        std::plus<>());
  }
};

}  // namespace

Alignment align(const PartModel& a, const PartModel& b, const Progress& progress) {
  if (a.part.mesh.facets.empty() || b.part.mesh.facets.empty()) return {};
  const Fit fit = best_fit(a, b, false, progress), mirrored = best_fit(a, b, true, progress);
  constexpr double k_far_better = 0.1, k_rounding = 1e-6;
  Alignment alignment = measured(a, b, fit.placement);
  alignment.mirrored =
      mirrored.misfit < k_far_better * fit.misfit && fit.misfit > k_rounding * a.frame.diagonal;
  return alignment;
}

Alignment align_scaled(const PartModel& a, const PartModel& b, const UniformScale& scale) {
  return measured(a, b, {scale.rotation, scale.shift - (scale.factor - 1.0) * principal_frame(a).centre});
}

std::optional<std::pair<LengthUnit, LengthUnit>> mistaken_units(double factor) {
  constexpr double k_same = 1e-3;
  for (const std::string_view of_a : {"mm", "in", "cm", "m"}) {
    for (const std::string_view of_b : {"mm", "in", "cm", "m"}) {
      const LengthUnit a = *find_length_unit(of_a), b = *find_length_unit(of_b);
      if (of_a != of_b && std::abs(factor * b.mm / a.mm - 1.0) < k_same) return std::pair(a, b);
    }
  }
  return std::nullopt;
}

std::optional<UniformScale> find_scale(const PartModel& a, const PartModel& b,
                                       const std::optional<Alignment>& alignment, double apart,
                                       const Progress& progress) {
  constexpr double k_most = 0.1, k_least = 5e-4, k_most_other = 0.2, k_far_better = 0.2;
  if (a.part.mesh.facets.empty() || b.part.mesh.facets.empty()) return std::nullopt;
  const Frame from = principal_frame(b), to = principal_frame(a);
  const Bounds &box_a = a.health.bounds, &box_b = b.health.bounds;
  std::vector<double> factors = {std::sqrt(b.geometry.total_area / a.geometry.total_area)};
  if (a.health.closed && b.health.closed) factors.push_back(std::cbrt(b.health.volume / a.health.volume));
  for (int axis = 0; axis < 3 && !alignment; ++axis)
    factors.push_back((box_b.max[axis] - box_b.min[axis]) / (box_a.max[axis] - box_a.min[axis]));
  std::erase_if(factors, [](double factor) {
    const bool near = std::abs(factor - 1.0) <= k_most || mistaken_units(factor);
    return !near || std::abs(factor - 1.0) < k_least;
  });
  if (factors.empty()) return std::nullopt;
  const SampledSide side_a(a), side_b(b);
  // Of both, each laid on the other by p → (rotation · p + shift) / factor from B to A.
  const auto share_off = [&](const Placement& placement, double factor) {
    progress.report("looking for a scale", 0.0);
    const glm::dmat3 back = glm::transpose(placement.rotation);
    const auto of_a = [&](const glm::dvec3& p) { return back * (factor * p - placement.shift); };
    const auto of_b = [&](const glm::dvec3& p) {
      return (placement.rotation * p + placement.shift) / factor;
    };
    const double off =
        side_a.count_off(side_b, of_a, apart, factor) + side_b.count_off(side_a, of_b, apart, 1.0);
    return off / static_cast<double>(side_a.points.size() + side_b.points.size());
  };
  const double as_it_is =
      share_off(alignment ? Placement{alignment->rotation, alignment->shift} : Placement{}, 1.0);
  UniformScale best{.factor = 1.0, .other = k_far_better * as_it_is};
  for (const double factor : factors) {
    std::vector<Placement> placements;
    if (alignment) {
      Part smaller = b.part;
      for (glm::dvec3& vertex : smaller.mesh.vertices) vertex /= factor;
      placements.push_back(
          best_fit(a, *prepare_part(std::move(smaller), progress), false, progress).placement);
      placements.back().shift *= factor;
    } else {
      for (const glm::dvec3& shift :
           {factor * to.centre - from.centre, glm::dvec3(0.0), factor * box_a.min - box_b.min,
            factor * box_a.center() - box_b.center()})
        placements.push_back({glm::dmat3(1.0), shift});
    }
    for (const Placement& placement : placements) {
      if (best.other == 0.0) break;
      if (const double other = share_off(placement, factor); other < best.other)
        best = {factor, other, placement.rotation, placement.shift};
    }
  }
  return best.factor != 1.0 && best.other <= k_most_other ? std::optional(best) : std::nullopt;
}

std::shared_ptr<const PartModel> moved_part(const PartModel& part, const Alignment& alignment,
                                            const Progress& progress) {
  Part moved = part.part;
  for (glm::dvec3& vertex : moved.mesh.vertices) vertex = alignment(vertex);
  return prepare_part(std::move(moved), progress);
}

}  // namespace moldlight
