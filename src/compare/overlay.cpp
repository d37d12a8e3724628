#include "compare/overlay.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <iterator>
#include <mutex>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "base/error.hpp"
#include "classify/map_comparison.hpp"
#include "mesh/unit_frame.hpp"

namespace moldlight {

namespace {

/// Pieces that face farther apart than 60 degrees are not one surface.
constexpr double k_least_facing = 0.5;
/// Of the diagonal: what cuts of polygons may be off.
constexpr double k_cut_rounding = 1e-10;
/// More pieces near a polygon than this, and it is asked about in halves.
constexpr std::size_t k_many_near = 512, k_many_over = 48;
constexpr int k_most_halvings = 24, k_most_search_halvings = 8;
/// Halvings one after the other that leave as much near: of needles as long as the part, all are near
/// everywhere.
constexpr int k_most_useless = 6;
constexpr std::string_view k_remedy =
    "unite the bodies of each (--repair union), take one of them (--body), or raise --effort";

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

/// Pieces that may be looked at for one another. Whether that is too much is known by how much there is in
/// all, so that no thread's haste shows.
class LayingWork {
 public:
  explicit LayingWork(std::uint64_t most) : most_(most) {}
  void add(std::uint64_t looks) {
    if ((done_ += looks) > most_)
      throw Error(fmt::format("too much surface lies at each place to compare the parts; {}", k_remedy));
  }
  [[nodiscard]] std::uint64_t done() const { return done_; }

 private:
  std::uint64_t most_;
  std::atomic<std::uint64_t> done_ = 0;
};

/// One piece at a time.
class Laying {
 public:
  Laying(const OverlaySide& side, const OverlaySide& onto, const OverlayTolerance& tolerance,
         LayingWork& work, const Progress& progress)
      : side_(side),
        onto_(onto),
        tolerance_(tolerance),
        work_(work),
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
  template <typename Visit>
  void visit_around(const ConvexPolygon& polygon, double reach, int halvings, const Visit& visit) const {
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
    near_.clear();
    std::uint64_t looks = 1;
    visit_around(polygon, reach, k_most_search_halvings, [&](PieceIndex other) {
      ++looks;
      if (glm::dot(normal, onto_.normal(other)) < k_least_facing || onto_.area(other) <= 0.0) return;
      const glm::dvec3 way = onto_.centre(other) - centre;
      double off = std::max(std::abs(glm::dot(normal, way)) - rounding_, glm::length(way) - radius);
      for (const Rim& rim : rims) off = std::max(off, glm::dot(rim.out, way) - rim.at);
      // What tessellations may be off is asked for only where it matters.
      if (off <= onto_.radius(other) || off <= reach_of(other)) near_.push_back(other);
    });
    work_.add(looks + near_.size());
    std::ranges::sort(near_);
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    const Halvings next = halvings.next(near_.size());
    const bool halve = near_.size() > k_many_near && next.allowed() && radius > reach;
    hulls_.clear();
    hulls_.reserve(near_.size());
    std::vector<const Over*> over;
    for (const PieceIndex other : near_) {
      // What holds the polygon is half as large at least.
      if (halve && (reach_of(other) < 0.5 * radius || !same_region(other))) continue;
      const Nearness within = nearness(other, slack);
      hulls_.push_back({other, within.lateral, onto_.hull(other, within)});
      if (!find_over(polygon, &hulls_.back(), slack, over, result)) return;
    }
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
    work_.add(2 * over.size());
    for (const ConvexPolygon& half : halved(polygon)) {
      std::vector<const Over*> over_half;
      if (std::ranges::all_of(
              over, [&](const Over* one) { return find_over(half, one, slack, over_half, result); }))
        divide(half, over_half, reach, slack, next, result);
    }
  }

  /// Adds one to `over` that is not beside the polygon. False if it is of the same region and holds all of
  /// it, and has taken it: one of another region may be beside one of the same, within the tolerance.
  bool find_over(const ConvexPolygon& polygon, const Over* one, const Slack& slack,
                 std::vector<const Over*>& over, PieceOverlay& result) const {
    const HullSide where = side_of(polygon, one->hull, rounding_);
    if (where == HullSide::outside) return true;
    if (where == HullSide::inside && same_region(one->piece)) {
      take(polygon, *one, slack, result);
      return false;
    }
    over.push_back(one);
    return true;
  }

  void subtract(const ConvexPolygon& polygon, const std::vector<const Over*>& over, const Slack& slack,
                PieceOverlay& result) {
    std::vector<ConvexPolygon> rest = {polygon}, next;
    for (const Over* one : over) {
      // On dense curved surface hulls cut a piece into very many.
      if (progress_.cancelled()) throw Cancelled();
      work_.add(rest.size());
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
  LayingWork& work_;
  const Progress& progress_;
  double rounding_;
  PieceIndex piece_ = 0;
  std::vector<ConvexPolygon> left_;
  std::vector<PieceIndex> near_;  // of the polygon that is laid now
  std::vector<Over> hulls_;
};

template <typename T>
void append(std::vector<T>& all, std::vector<T>& some) {
  std::ranges::move(some, std::back_inserter(all));
}

/// Throws Error where its pieces are too many to look at them one by one.
std::shared_ptr<const SplitMesh> checked(const PartModel& model, std::shared_ptr<const SplitMesh> split) {
  const std::size_t pieces = split->pieces.size();
  if (pieces > most_pieces(model.part.mesh.facets.size(), std::max(1.0, model.part.effort)))
    throw Error(fmt::format("the surface of {} is in {} pieces by what hides it, too many to compare; {}",
                            model.part.file, pieces, k_remedy));
  return split;
}

}  // namespace

OverlaySide::OverlaySide(std::shared_ptr<const PartModel> model, const Classification& result)
    : model_(std::move(model)),
      split_(checked(*model_, result.split)),
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

Overlay lay_on(const OverlaySide& side, const OverlaySide& onto, const OverlayTolerance& tolerance,
               const Progress& progress) {
  constexpr std::size_t k_block = 64;
  const std::size_t count = side.count(), blocks = (count + k_block - 1) / k_block;
  std::mutex mutex;
  std::size_t done = 0;
  constexpr double k_always_looks = 2e7, k_looks_a_facet = 3000.0;  // real parts take up to 1000
  const double effort = std::max({1.0, side.model().part.effort, onto.model().part.effort});
  const std::size_t facets = side.model().part.mesh.facets.size() + onto.model().part.mesh.facets.size();
  LayingWork work(
      static_cast<std::uint64_t>(effort * (k_always_looks + k_looks_a_facet * static_cast<double>(facets))));
  std::vector<PieceOverlay> results(blocks);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, blocks, 1), [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t block = range.begin(); block < range.end(); ++block) {
          Laying laying(side, onto, tolerance, work, progress);
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
