#include "compare/overlay.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <utility>

#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "classify/map_comparison.hpp"
#include "mesh/unit_frame.hpp"

namespace moldlight {

namespace {

/// Pieces that face farther apart than 60 degrees are not one surface.
constexpr double k_least_facing = 0.5;
/// Of the diagonal: what cuts of polygons may be off.
constexpr double k_cut_rounding = 1e-10;
/// Of the radius asked for: single precision of the search tree, in its unit frame.
constexpr float k_search_margin = 1e-6F;
/// More pieces near a polygon than this, and it is asked about in halves.
constexpr std::size_t k_many_near = 512, k_many_over = 48;
constexpr int k_most_halvings = 24, k_most_search_halvings = 8;
/// Halvings one after the other that leave as much near: of needles as long as the part, all are near
/// everywhere.
constexpr int k_most_useless = 6;

struct PieceOverlay {
  std::vector<PieceShare> shares;
  std::vector<LeftOver> left;
  std::vector<OtherRegion> regions;
};

std::array<ConvexPolygon, 2> halved(const ConvexPolygon& polygon) {
  std::size_t longest = 0;
  double length = -1.0;
  const std::size_t corners = polygon.size();
  for (std::size_t k = 0; k < corners; ++k) {
    const double here = glm::distance(polygon[k], polygon[(k + 1) % corners]);
    if (here > length) {
      length = here;
      longest = k;
    }
  }
  const glm::dvec3 middle = 0.5 * (polygon[longest] + polygon[(longest + 1) % corners]);
  std::array<ConvexPolygon, 2> halves;
  const std::size_t across = corners / 2 + 1;
  halves[0].push_back(middle);
  for (std::size_t k = 1; k <= across; ++k) halves[0].push_back(polygon[(longest + k) % corners]);
  halves[1].push_back(middle);
  for (std::size_t k = across; k <= corners; ++k) halves[1].push_back(polygon[(longest + k) % corners]);
  return halves;
}

/// One piece at a time.
class Laying {
 public:
  Laying(const OverlaySide& side, const OverlaySide& onto, const OverlayTolerance& tolerance,
         const Progress& progress)
      : side_(side),
        onto_(onto),
        tolerance_(tolerance),
        progress_(progress),
        rounding_(k_cut_rounding * std::max(side.model().frame.diagonal, onto.model().frame.diagonal)) {}

  void lay(PieceIndex piece, PieceOverlay& result) {
    piece_ = piece;
    const auto corners = side_.corners(piece);
    left_.clear();
    lay({corners.begin(), corners.end()}, {tolerance_.rounding, false}, {}, result);
    const std::vector<ConvexPolygon> left = std::move(left_);
    left_.clear();
    for (const ConvexPolygon& polygon : left) lay(polygon, {tolerance_.apart, true}, {}, result);
    for (ConvexPolygon& polygon : left_) {
      const double area = polygon_area(polygon);
      result.left.push_back({piece, std::move(polygon), area});
    }
  }

 private:
  struct Over {
    PieceIndex piece;
    double lateral;  // by how much the hull reaches beyond the piece's rim
    TriangleHull hull;
  };

  /// What counts as on the other part; `explaining`: with what the tessellations may be off.
  struct Slack {
    double base = 0.0;
    bool explaining = false;
  };

  /// How a polygon came about.
  struct Halvings {
    int count = 0, useless = 0;
    std::size_t near = ~std::size_t{0};  // before the last

    /// With so many near now.
    [[nodiscard]] Halvings next(std::size_t count_near) const {
      return {count + 1, count_near < near ? 0 : useless + 1, count_near};
    }
    [[nodiscard]] bool allowed() const { return count <= k_most_halvings && useless < k_most_useless; }
  };

  [[nodiscard]] Nearness nearness(PieceIndex other, const Slack& slack) const {
    if (!slack.explaining) return {slack.base, slack.base};
    const FacetIndex here = side_.facet(piece_), there = onto_.facet(other);
    const ChordDeviation &own = side_.chords(), &others = onto_.chords();
    const double normal = slack.base + own.normal[here] + others.normal[there];
    // Above a bend there is a wedge that no facet's own prism holds.
    return {normal, slack.base + own.lateral[here] + others.lateral[there] + normal * others.spread[there]};
  }

  /// An edge of a polygon: how far off its centre it is, along what leads out of the polygon.
  struct Rim {
    glm::dvec3 out;
    double at;
  };

  /// Most of what is around a long polygon is beside it.
  [[nodiscard]] std::vector<Rim> rims_of(const ConvexPolygon& polygon, const glm::dvec3& centre,
                                         const glm::dvec3& normal) const {
    std::vector<Rim> rims;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const glm::dvec3 out = glm::cross(polygon[(k + 1) % polygon.size()] - polygon[k], normal);
      const double length = glm::length(out);
      if (length > rounding_)
        rims.push_back({out / length, glm::dot(out / length, polygon[k] - centre) + rounding_});
    }
    return rims;
  }

  /// Calls `visit` for what is so near to a polygon, and for some beside it; maybe more than once. Around a
  /// large polygon there is much of a finely divided part: its halves have less around them.
  void visit_around(const ConvexPolygon& polygon, double reach, int halvings,
                    const std::function<void(PieceIndex)>& visit) const {
    constexpr double k_few = 4.0;  // pieces across
    const glm::dvec3 centre = polygon_centre(polygon);
    const double radius = reach_from(centre, polygon);
    if (halvings == 0 || radius <= reach + k_few * onto_.mean_radius())
      return visit_pieces(onto_, centre, radius + reach, visit);
    for (const ConvexPolygon& half : halved(polygon)) visit_around(half, reach, halvings - 1, visit);
  }

  /// Gives what lies on the other part to the result, and the rest to left_.
  void lay(const ConvexPolygon& polygon, const Slack& slack, const Halvings& halvings, PieceOverlay& result) {
    const glm::dvec3 centre = polygon_centre(polygon), normal = side_.normal(piece_);
    const double radius = reach_from(centre, polygon);
    const double chords = side_.chords().lateral[side_.facet(piece_)] + onto_.chords().greatest;
    // A hull's corners reach out half as far again.
    const double reach = 2.0 * (slack.base + (slack.explaining ? chords : 0.0));
    const auto reach_of = [&](PieceIndex other) {
      const Nearness within = nearness(other, slack);
      return onto_.radius(other) + 2.0 * (within.normal + within.lateral);
    };
    const std::vector<Rim> rims = rims_of(polygon, centre, normal);
    std::vector<PieceIndex> near;
    visit_around(polygon, reach, k_most_search_halvings, [&](PieceIndex other) {
      const glm::dvec3 way = onto_.centre(other) - centre;
      double off = std::max(std::abs(glm::dot(normal, way)) - rounding_, glm::length(way) - radius);
      for (const Rim& rim : rims) off = std::max(off, glm::dot(rim.out, way) - rim.at);
      if (glm::dot(normal, onto_.normal(other)) < k_least_facing || onto_.area(other) <= 0.0) return;
      // What tessellations may be off is asked for only where it matters.
      if (off <= onto_.radius(other) || off <= reach_of(other)) near.push_back(other);
    });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    const Halvings next = halvings.next(near.size());
    const bool halve = near.size() > k_many_near && next.allowed() && radius > reach;
    std::vector<Over> hulls;
    for (const PieceIndex other : near) {
      // What holds the polygon is half as large at least.
      if (halve && (reach_of(other) < 0.5 * radius || !same_region(other))) continue;
      const Nearness within = nearness(other, slack);
      hulls.push_back(
          {other, within.lateral, hull_around(onto_.corners(other), onto_.normal(other), within)});
    }
    std::vector<const Over*> candidates, over;
    for (const Over& one : hulls) candidates.push_back(&one);
    if (!find_over(polygon, candidates, slack, over, result)) return;
    if (!halve) {
      divide(polygon, over, reach, slack, next, result);
      return;
    }
    if (progress_.cancelled()) throw Cancelled();
    for (const ConvexPolygon& half : halved(polygon)) lay(half, slack, next, result);
  }

  /// The same where all that may be over the polygon is known.
  void divide(const ConvexPolygon& polygon, std::vector<const Over*>& over, double reach, const Slack& slack,
              const Halvings& halvings, PieceOverlay& result) {
    const Halvings next = halvings.next(over.size());
    if (over.size() <= k_many_over || !next.allowed() ||
        reach_from(polygon_centre(polygon), polygon) <= reach) {
      std::stable_partition(over.begin(), over.end(),
                            [&](const Over* one) { return same_region(one->piece); });
      subtract(polygon, over, slack, result);
      return;
    }
    if (progress_.cancelled()) throw Cancelled();
    for (const ConvexPolygon& half : halved(polygon)) {
      std::vector<const Over*> over_half;
      if (find_over(half, over, slack, over_half, result))
        divide(half, over_half, reach, slack, next, result);
    }
  }

  /// Finds those that are not beside the polygon. False if one of the same region holds all of it, and has
  /// taken it: one of another region may be beside one of the same, within the tolerance.
  bool find_over(const ConvexPolygon& polygon, const std::vector<const Over*>& candidates, const Slack& slack,
                 std::vector<const Over*>& over, PieceOverlay& result) const {
    for (const Over* one : candidates) {
      const HullSide where = side_of(polygon, one->hull, rounding_);
      if (where == HullSide::outside) continue;
      if (where == HullSide::inside && same_region(one->piece)) {
        take(polygon, *one, slack, result);
        return false;
      }
      over.push_back(one);
    }
    return true;
  }

  void subtract(const ConvexPolygon& polygon, const std::vector<const Over*>& over, const Slack& slack,
                PieceOverlay& result) {
    std::vector<ConvexPolygon> rest = {polygon}, next;
    for (const Over* one : over) {
      // On dense curved surface hulls cut a piece into very many.
      if (progress_.cancelled()) throw Cancelled();
      next.clear();
      for (ConvexPolygon& part : rest) {
        if (side_of(part, one->hull, rounding_) == HullSide::outside) {
          next.push_back(std::move(part));
          continue;
        }
        const ConvexPolygon inside = cut_by(part, one->hull, rounding_, next);
        if (!inside.empty()) take(inside, *one, slack, result);
      }
      std::swap(rest, next);
      if (rest.empty()) return;
    }
    for (ConvexPolygon& part : rest) left_.push_back(std::move(part));
  }

  void take(const ConvexPolygon& polygon, const Over& over, const Slack& slack, PieceOverlay& result) const {
    const double area = polygon_area(polygon);
    result.shares.push_back({piece_, over.piece, area});
    if (!same_region(over.piece)) result.regions.push_back({piece_, over.piece, polygon, area});
    if (slack.explaining) result.left.push_back({piece_, polygon, area, over.lateral});
  }

  [[nodiscard]] bool same_region(PieceIndex other) const {
    return side_.region(piece_) == onto_.region(other);
  }

  const OverlaySide& side_;
  const OverlaySide& onto_;
  OverlayTolerance tolerance_;
  const Progress& progress_;
  double rounding_;
  PieceIndex piece_ = 0;
  std::vector<ConvexPolygon> left_;
};

template <typename T>
void append(std::vector<T>& all, std::vector<T>& some) {
  std::ranges::move(some, std::back_inserter(all));
}

}  // namespace

OverlaySide::OverlaySide(std::shared_ptr<const PartModel> model, const Classification& result)
    : model_(std::move(model)),
      split_(result.split),
      direction_(result.direction),
      tau_deg_(result.settings.tau_deg),
      faces_(part_faces(model_->part, model_->geometry, model_->adjacency)),
      chords_(chord_deviation(*model_, faces_)),
      rays_([&] {
        const TriangleMesh mesh = piece_mesh(*split_);
        return ExactRays(mesh, unit_positions(mesh, model_->frame));
      }()) {
  measures_.reserve(count());
  for (PieceIndex piece = 0; piece < count(); ++piece) {
    const auto [a, b, c] = corners(piece);
    const glm::dvec3 centre = (a + b + c) / 3.0;
    measures_.push_back(
        {.centre = centre,
         .normal = model_->geometry.normals[facet(piece)],
         .radius = std::max({glm::distance(a, centre), glm::distance(b, centre), glm::distance(c, centre)}),
         .area = piece_area(*split_, split_->pieces[piece])});
    mean_radius_ += measures_.back().radius / static_cast<double>(count());
  }
}

void visit_pieces(const OverlaySide& side, const glm::dvec3& point, double reach,
                  const std::function<void(PieceIndex)>& visit) {
  const UnitFrame& frame = side.model().frame;
  const float radius = static_cast<float>(reach / frame.diagonal) + k_search_margin;
  side.rays().visit_near(frame.to_unit(point), radius, [&](FacetIndex piece) {
    visit(piece);
    return radius;
  });
}

Overlay lay_on(const OverlaySide& side, const OverlaySide& onto, const OverlayTolerance& tolerance,
               const Progress& progress) {
  constexpr std::size_t k_block = 64;
  const std::size_t count = side.count(), blocks = (count + k_block - 1) / k_block;
  std::mutex mutex;
  std::size_t done = 0;
  std::vector<PieceOverlay> results(blocks);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, blocks, 1), [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t block = range.begin(); block < range.end(); ++block) {
          Laying laying(side, onto, tolerance, progress);
          for (std::size_t k = block * k_block; k < std::min(count, (block + 1) * k_block); ++k) {
            const auto piece = static_cast<PieceIndex>(k);
            if (progress.cancelled()) throw Cancelled();
            if (side.area(piece) > 0.0) laying.lay(piece, results[block]);
          }
          const std::lock_guard lock(mutex);
          progress.report("laying surfaces on each other",
                          static_cast<double>(++done) / static_cast<double>(blocks));
        }
      });
  Overlay overlay;
  for (PieceOverlay& one : results) {
    append(overlay.shares, one.shares);
    append(overlay.left, one.left);
    append(overlay.regions, one.regions);
  }
  return overlay;
}

}  // namespace moldlight
