#include "actions/undercut.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/ext/vector_int3_sized.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <tbb/parallel_for.h>

#include "actions/release.hpp"
#include "classify/map_comparison.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/union_find.hpp"
#include "mold/map_frame.hpp"

namespace moldlight {

namespace {

using PieceIndex = std::uint32_t;

/// Of a cube of the grid in which corners are looked for.
std::size_t cell_hash(const glm::i64vec3& cell) {
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis)
    hash = std::rotl((hash ^ static_cast<std::uint64_t>(cell[axis])) * 0x9E3779B97F4A7C15U, 31);
  return hash;
}

constexpr double k_infinite = std::numeric_limits<double>::infinity();

struct Box {
  glm::dvec3 low{k_infinite}, high{-k_infinite};

  void take(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  [[nodiscard]] bool meets(const Box& other, double reach) const {
    return glm::all(glm::lessThanEqual(low - reach, other.high)) &&
           glm::all(glm::lessThanEqual(other.low - reach, high));
  }
};

/// Boxes around undercuts, by where they begin along x.
class UndercutBoxes {
 public:
  UndercutBoxes(const std::vector<Box>& boxes, std::vector<std::uint32_t> undercuts)
      : boxes_(boxes), boxed_(std::move(undercuts)) {
    std::ranges::sort(boxed_, {}, [&](std::uint32_t undercut) { return boxes_[undercut].low.x; });
    for (const std::uint32_t undercut : boxed_)
      highest_.push_back(std::max(boxes_[undercut].high.x, highest_.empty() ? -k_infinite : highest_.back()));
  }

  /// Of the other undercuts that come as near as `reach` to the undercut's box. Counts those that it asks.
  [[nodiscard]] std::vector<Box> near(std::uint32_t undercut, double reach, std::size_t& asked) const {
    const Box& own = boxes_[undercut];
    std::vector<Box> found;
    auto place = std::ranges::upper_bound(boxed_, own.high.x + reach, {},
                                          [&](std::uint32_t other) { return boxes_[other].low.x; }) -
                 boxed_.begin();
    while (place-- > 0 && highest_[static_cast<std::size_t>(place)] >= own.low.x - reach) {
      const std::uint32_t other = boxed_[static_cast<std::size_t>(place)];
      ++asked;
      if (other != undercut && boxes_[other].meets(own, reach)) found.push_back(boxes_[other]);
    }
    return found;
  }

 private:
  const std::vector<Box>& boxes_;
  std::vector<std::uint32_t> boxed_;
  std::vector<double> highest_;  // of this undercut's end along x and those before
};

/// Places in `pieces` of those that come as near as `reach` to the box around another undercut: only they may
/// join two of them.
std::vector<std::uint32_t> near_others(const SplitMesh& split, std::span<const PieceIndex> pieces,
                                       double reach, UnionFind& joined, const Progress& progress) {
  std::vector<Box> boxes(pieces.size());  // of undercuts, at their roots
  std::vector<std::uint32_t> root_of, roots, order(pieces.size());
  for (std::uint32_t place = 0; place < pieces.size(); ++place) {
    root_of.push_back(static_cast<std::uint32_t>(joined.find(place)));
    if (root_of[place] == place) roots.push_back(place);
    for (std::size_t k = 0; k < 3; ++k) boxes[root_of[place]].take(split.corner(pieces[place], k));
    order[place] = place;
  }
  std::ranges::stable_sort(order, {}, [&](std::uint32_t place) { return root_of[place]; });
  const UndercutBoxes undercuts(boxes, std::move(roots));
  std::vector<Box> others;
  std::vector<std::uint32_t> near;
  // Ten thousand undercuts, and to ask on takes longer than to join pieces in vain.
  constexpr std::size_t k_most_asked = 100'000'000;
  std::size_t asked = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (progress.cancelled()) throw Cancelled();
    if (asked > k_most_asked) {
      near.push_back(order[k]);
      continue;
    }
    if (k == 0 || root_of[order[k]] != root_of[order[k - 1]])
      others = undercuts.near(root_of[order[k]], reach, asked);
    asked += others.size();
    Box own;
    for (std::size_t c = 0; c < 3; ++c) own.take(split.corner(pieces[order[k]], c));
    if (std::ranges::any_of(others, [&](const Box& other) { return other.meets(own, reach); }))
      near.push_back(order[k]);
  }
  std::ranges::sort(near);
  return near;
}

/// Joins pieces whose corners are within `reach` (model units) of each other and face the same way. Cells of
/// the grid are as large as the reach, so that neighbours of a corner lie in the 27 cells around it.
void join_near(const PartModel& model, const SplitMesh& split, std::span<const PieceIndex> pieces,
               double reach, UnionFind& joined, const Progress& progress) {
  if (reach <= 0.0) return;
  constexpr double k_same_place = 0.1;  // of the reach
  constexpr double k_same_facing = 0.9;
  const std::vector<std::uint32_t> near = near_others(split, pieces, reach, joined, progress);
  // Corners of a bucket in a chain: cells that share one are told apart by the distance, which is asked for
  // in any case. A list for each cell takes ten times the memory where pieces are as small as the reach.
  struct Corner {
    std::uint32_t place, k;  // in `pieces`, of the piece
    std::uint32_t next;      // k_none: the last one
  };
  constexpr std::uint32_t k_none = ~0U;
  std::vector<Corner> corners;
  std::vector<std::uint32_t> first(std::bit_ceil(std::max<std::size_t>(near.size(), 1)), k_none);
  const auto cell_of = [&](const glm::dvec3& at) {
    return glm::i64vec3(glm::floor((at - model.frame.center) / reach));
  };
  const auto bucket_of = [&](const glm::i64vec3& cell) -> std::uint32_t& {
    return first[cell_hash(cell) & (first.size() - 1)];
  };
  const auto visit = [&](std::uint32_t bucket, const auto& act) {
    for (std::uint32_t other = bucket; other != k_none; other = corners[other].next) {
      const Corner& corner = corners[other];
      if (act(split.corner(pieces[corner.place], corner.k),
              model.geometry.normals[split.pieces[pieces[corner.place]].facet], corner.place))
        return true;
    }
    return false;
  };
  for (const std::uint32_t place : near) {
    if (progress.cancelled()) throw Cancelled();
    const glm::dvec3& normal = model.geometry.normals[split.pieces[pieces[place]].facet];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const glm::dvec3 at = split.corner(pieces[place], k);
      const glm::i64vec3 cell = cell_of(at);
      // One of an undercut in a place, facing one way, is enough.
      const bool known =
          visit(bucket_of(cell), [&](const glm::dvec3& there, const glm::dvec3& facing, std::uint32_t other) {
            return glm::distance(there, at) <= k_same_place * reach && cell_of(there) == cell &&
                   glm::dot(facing, normal) > k_same_facing && joined.find(other) == joined.find(place);
          });
      if (known) continue;
      for (int around = 0; around < 27; ++around) {
        const glm::i64vec3 beside(around % 3 - 1, around / 3 % 3 - 1, around / 9 - 1);
        visit(bucket_of(cell + beside),
              [&](const glm::dvec3& there, const glm::dvec3& facing, std::uint32_t other) {
                if (glm::distance(there, at) <= reach && glm::dot(facing, normal) > 0.0)
                  joined.join(place, other);
                return false;
              });
      }
      std::uint32_t& bucket = bucket_of(cell);
      corners.push_back({place, k, std::exchange(bucket, static_cast<std::uint32_t>(corners.size()))});
    }
  }
}

void measure_area(const SplitMesh& split, Undercut& undercut) {
  glm::dvec3 sum(0.0);
  for (const PieceIndex piece : undercut.pieces) {
    const double area = piece_area(split, split.pieces[piece]);
    undercut.area += area;
    sum += area * split.middle(piece);
  }
  const glm::dvec3 any = split.corner(undercut.pieces.front(), 0);
  undercut.centre = undercut.area > 0.0 ? sum / undercut.area : any;
}

void measure_extents(const SplitMesh& split, const glm::dvec3& direction, Undercut& undercut) {
  const MapFrame frame = map_frame(direction);
  const auto extent = [&](const glm::dvec3& along) { return extent_along(split, undercut, along); };
  undercut.size_along = extent(direction);
  constexpr int k_turns = 36;
  for (int k = 0; k < k_turns; ++k) {
    const double angle = std::numbers::pi * k / k_turns;
    undercut.size_across =
        std::max(undercut.size_across, extent(std::cos(angle) * frame.x + std::sin(angle) * frame.y));
  }
}

/// Whether all of it is within `radius` of its centre.
bool fits(const SplitMesh& split, const Undercut& undercut, double radius) {
  return std::ranges::all_of(undercut.pieces, [&](PieceIndex piece) {
    bool within = true;
    for (std::size_t k = 0; k < 3; ++k)
      within = within && glm::distance(split.corner(piece, k), undercut.centre) <= radius;
    return within;
  });
}

/// Length of the edges that one of its pieces alone has.
double border_length(const SplitMesh& split, const Undercut& undercut) {
  std::vector<std::pair<VertexIndex, VertexIndex>> edges;
  for (const PieceIndex piece : undercut.pieces) {
    const auto& corners = split.pieces[piece].corners;
    for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(std::minmax(corners[k], corners[(k + 1) % 3]));
  }
  std::ranges::sort(edges);
  double length = 0.0;
  for (std::size_t k = 0; k < edges.size();) {
    const std::size_t first = k;
    while (k < edges.size() && edges[k] == edges[first]) ++k;
    if (k == first + 1)
      length += glm::distance(split.vertices[edges[first].first], split.vertices[edges[first].second]);
  }
  return length;
}

/// The corner of its pieces that is nearest to its centre.
glm::dvec3 place_on(const SplitMesh& split, const Undercut& undercut) {
  glm::dvec3 nearest = split.corner(undercut.pieces.front(), 0);
  for (const PieceIndex piece : undercut.pieces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 at = split.corner(piece, k);
      if (glm::distance(at, undercut.centre) < glm::distance(nearest, undercut.centre)) nearest = at;
    }
  }
  return nearest;
}

/// What decides whether an undercut counts; lengths in the part's unit, but for the depth.
struct Floors {
  double width = 0.0;
  double area = 0.0;
  double depth = 0.0;  // share of the diagonal
};

/// A strip's width is twice its area by the length of its border.
bool is_narrow(const SplitMesh& split, const Undercut& undercut, double width) {
  return 2.0 * undercut.area < width * border_length(split, undercut);
}

/// Whether no more of it is deeper than what would be a speck by itself.
bool is_shallow(const Release& release, std::span<const UndercutSample> samples, const Floors& floors) {
  double total = 0.0, deep = 0.0;
  for (const UndercutSample& sample : samples) total += sample.area;
  return std::ranges::all_of(samples, [&](const UndercutSample& sample) {
    deep += release.is_shallow(sample, floors.depth) ? 0.0 : sample.area;
    return deep <= std::max(k_blocked_share * total, floors.area);
  });
}

/// By the places of their facets, those of a facet together.
void put_in_order(const TriangleMesh& mesh, const SplitMesh& split, const PartAxes& axes,
                  std::vector<PieceIndex>& pieces) {
  std::vector<std::tuple<PlaceKey, FacetIndex, PlaceKey, PieceIndex>> keys;
  for (const PieceIndex piece : pieces) {
    const FacetIndex facet = split.pieces[piece].facet;
    keys.emplace_back(place_key(axes, mesh.middle(facet)), facet, place_key(axes, split.middle(piece)),
                      piece);
  }
  std::ranges::sort(keys);
  std::ranges::transform(keys, pieces.begin(), [](const auto& key) { return std::get<3>(key); });
}

/// The largest first; of those that rounding alone distinguishes the lower one, and so on.
template <typename Ordered, typename Place>
void put_in_order(const PartAxes& axes, std::vector<Ordered>& all, const Place& place) {
  constexpr double k_steps = 1e4;  // of the logarithm of an area
  std::ranges::stable_sort(all, {}, [&](const Ordered& one) {
    return std::pair(-std::llround(k_steps * std::log(std::max(one.area, 1e-300))),
                     place_key(axes, place(one)));
  });
}

/// Without their extents.
Undercuts join_undercuts(const PartModel& model, const SplitMesh& split, const ExactQuery& query,
                         const Progress& progress, double least_travel_mm) {
  constexpr double k_least_share = 1e-3;  // of all undercut
  progress.report("joining undercuts", 0.0);
  std::vector<PieceIndex> pieces;
  for (PieceIndex piece = 0; piece < split.pieces.size(); ++piece) {
    if (split.pieces[piece].region == Region::undercut) pieces.push_back(piece);
  }
  UnionFind joined(pieces.size());
  constexpr std::uint32_t k_none = ~0U;
  std::vector<std::uint32_t> at_vertex(split.vertices.size(), k_none);  // a place in `pieces`
  for (std::uint32_t place = 0; place < pieces.size(); ++place) {
    for (const VertexIndex vertex : split.pieces[pieces[place]].corners) {
      if (at_vertex[vertex] == k_none) {
        at_vertex[vertex] = place;
      } else {
        joined.join(place, at_vertex[vertex]);
      }
    }
  }
  const double lateral = query.lateral * model.frame.diagonal;
  progress.report("joining undercuts", 0.2);
  join_near(model, split, pieces, 2.0 * lateral, joined, progress);
  progress.report("joining undercuts", 0.5);

  std::vector<std::uint32_t> number(pieces.size(), k_none);  // of the undercut, at its root
  std::vector<Undercut> all;
  for (std::uint32_t place = 0; place < pieces.size(); ++place) {
    std::uint32_t& undercut = number[joined.find(place)];
    if (undercut == k_none) {
      undercut = static_cast<std::uint32_t>(all.size());
      all.emplace_back();
    }
    all[undercut].pieces.push_back(pieces[place]);
  }
  Undercuts found{.counted = {}, .specks = {}, .axes = part_axes(model, query.direction)};
  double total = 0.0;
  for (Undercut& undercut : all) {
    if (progress.cancelled()) throw Cancelled();
    put_in_order(model.part.mesh, split, found.axes, undercut.pieces);
    measure_area(split, undercut);
    total += undercut.area;
  }
  const double depth = least_depth(model, query, least_travel_mm), width = depth * model.frame.diagonal;
  const Floors floors{.width = width,
                      .area = std::max(std::numbers::pi * width * width, k_least_share * total),
                      .depth = depth};
  std::vector<std::optional<SpeckReason>> specks(all.size());
  progress.report("joining undercuts", 0.7);
  const Release release(model, query, &progress);
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t k) {
    constexpr std::size_t k_asked = 48;
    const Undercut& undercut = all[k];
    if (undercut.area <= floors.area || fits(split, undercut, floors.width)) {
      specks[k] = SpeckReason::small;
    } else if (is_narrow(split, undercut, floors.width)) {
      specks[k] = SpeckReason::narrow;
    } else if (is_shallow(release, sample_undercut(model, split, undercut, k_asked), floors)) {
      specks[k] = SpeckReason::shallow;
    }
  });
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (specks[k]) {
      found.specks.push_back({all[k].area, place_on(split, all[k]), *specks[k]});
    } else {
      found.counted.push_back(std::move(all[k]));
    }
  }
  put_in_order(found.axes, found.counted, [](const Undercut& undercut) { return undercut.centre; });
  put_in_order(found.axes, found.specks, [](const Speck& speck) { return speck.place; });
  return found;
}

}  // namespace

std::string_view speck_text(SpeckReason reason) {
  switch (reason) {
    case SpeckReason::small:
      return "too small to count";
    case SpeckReason::narrow:
      return "narrower than the least travel";
    case SpeckReason::shallow:
      return "clear within the least travel";
  }
  return "";
}

double unit_per_mm(const Part& part) { return 1.0 / mm_per_unit(part.unit); }

double least_depth(const PartModel& model, const ExactQuery& query, double least_travel_mm) {
  constexpr double k_least_size_mm = 10.0;
  const double size_mm = model.frame.diagonal / unit_per_mm(model.part);
  return std::max(query.lateral, least_travel_mm / std::max(size_mm, k_least_size_mm));
}

Undercuts find_undercuts(const PartModel& model, const SplitMesh& split, const ExactQuery& query,
                         const Progress& progress, double least_travel_mm) {
  Undercuts found = join_undercuts(model, split, query, progress, least_travel_mm);
  for (Undercut& undercut : found.counted) {
    if (progress.cancelled()) throw Cancelled();
    measure_extents(split, query.direction, undercut);
  }
  return found;
}

UndercutTotals totals_of(const Undercuts& undercuts) {
  UndercutTotals totals{.count = undercuts.counted.size(), .specks = undercuts.specks.size()};
  for (const Undercut& undercut : undercuts.counted) totals.area += undercut.area;
  for (const Speck& speck : undercuts.specks) totals.speck_area += speck.area;
  return totals;
}

UndercutTotals count_undercuts(const PartModel& model, const UndercutCount& asked, const Progress& progress) {
  const SplitMesh split = exact_split_around(model.exact(progress), asked.query, asked.facets, progress);
  return totals_of(join_undercuts(model, split, asked.query, progress, asked.least_travel_mm));
}

double extent_along(const SplitMesh& split, const Undercut& undercut, const glm::dvec3& direction) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const PieceIndex piece : undercut.pieces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = glm::dot(split.corner(piece, k) - undercut.centre, direction);
      least = std::min(least, at);
      greatest = std::max(greatest, at);
    }
  }
  return greatest - least;
}

}  // namespace moldlight
