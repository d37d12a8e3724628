#include "mold/exact/facet_encounters.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

namespace moldlight {

namespace {

/// Facets that come nearer than this to a plane only touch it: a few roundings of a coordinate in double.
constexpr double k_facet_touch = 1e-12;
constexpr double k_inside = 1e-9;             // an edge nearer to a facet's side runs along it
constexpr double k_shortest_crossing = 1e-9;  // shorter crossings cut nothing that has an area
constexpr std::uint32_t k_leaf_facets = 6;
constexpr std::uint32_t k_parallel_facets = 8192;  // smaller subtrees are one task
constexpr std::size_t k_leaves_a_task = 64;
/// Where more facets are in front of others (thousands round one edge), they are not noted down.
constexpr std::size_t k_most_in_front_a_facet = 32, k_always_in_front = 1'000'000;
constexpr std::size_t k_counted_at_once = 256;
/// A tessellation has some tens of pairs a facet; loose facets as large as the part have as many as facets.
constexpr std::size_t k_pairs_a_facet = 500, k_always_pairs = 5'000'000;
constexpr std::size_t k_crossings_a_facet = 16, k_always_crossings = 500'000;

struct Box {
  glm::vec3 low, high;
};

/// Single precision, rounded outwards.
Box box_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  constexpr float k_out = 1e-7F;
  return {glm::vec3(glm::min(glm::min(a, b), c)) - k_out, glm::vec3(glm::max(glm::max(a, b), c)) + k_out};
}

bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

/// A balanced tree: node k has the children 2 k + 1 and 2 k + 2; its facets are split at the median.
class BoxTree {
 public:
  BoxTree(const TriangleMesh& mesh, std::span<const glm::dvec3> positions,
          std::span<const FacetIndex> first_equal) {
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      const auto& corners = mesh.facets[facet];
      if (first_equal.empty() || first_equal[facet] == facet) order_.push_back(facet);
      boxes_.push_back(box_of(positions[corners[0]], positions[corners[1]], positions[corners[2]]));
    }
    std::size_t nodes = 1;
    for (std::size_t facets = order_.size(); facets > k_leaf_facets; facets = (facets + 1) / 2) {
      nodes = 2 * nodes + 1;
    }
    nodes_.resize(nodes);
    if (!order_.empty()) build(0, 0, static_cast<std::uint32_t>(order_.size()));
  }

  struct Node {
    Box box{};
    std::uint32_t begin = 0, end = 0;  // of order()
    bool leaf = false;
  };
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<FacetIndex>& order() const { return order_; }

  [[nodiscard]] bool overlap(FacetIndex a, FacetIndex b) const {
    return moldlight::overlap(boxes_[a], boxes_[b]);
  }

  /// Calls visit(facet, other) for every pair, the lower number first, of a facet of a leaf with one of this
  /// or a later leaf, whose boxes are within `distance` of each other.
  template <typename Visit>
  void for_each_near(const Node& leaf, double distance, const Visit& visit) const {
    const auto wider = [&](const Box& box, double by) {
      return Box{box.low - static_cast<float>(by), box.high + static_cast<float>(by)};
    };
    const auto meet = [&](std::uint32_t k, std::uint32_t other) {
      const auto [a, b] = std::minmax({order_[k], order_[other]});
      if (moldlight::overlap(boxes_[b], wider(boxes_[a], distance))) visit(a, b);
    };
    const Box box = wider(leaf.box, 2.0 * distance);  // whatever rounding does
    std::array<std::uint32_t, 64> stack{};
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const std::uint32_t number = stack[--depth];
      const Node& node = nodes_[number];
      if (node.end <= leaf.begin || !moldlight::overlap(node.box, box)) continue;
      if (!node.leaf) {
        stack[depth++] = 2 * number + 2;
        stack[depth++] = 2 * number + 1;
        continue;
      }
      for (std::uint32_t other = node.begin; other < node.end; ++other) {
        if (!moldlight::overlap(boxes_[order_[other]], box)) continue;
        for (std::uint32_t k = leaf.begin; k < std::min(leaf.end, other); ++k) meet(k, other);
      }
    }
  }

 private:
  void build(std::uint32_t number, std::uint32_t begin, std::uint32_t end) {
    Node& node = nodes_[number];
    node.begin = begin;
    node.end = end;
    node.box = boxes_[order_[begin]];
    glm::vec3 low(node.box.low + node.box.high), high = low;
    for (std::uint32_t k = begin; k < end; ++k) {
      const Box& box = boxes_[order_[k]];
      node.box.low = glm::min(node.box.low, box.low);
      node.box.high = glm::max(node.box.high, box.high);
      low = glm::min(low, box.low + box.high);
      high = glm::max(high, box.low + box.high);
    }
    if (2 * static_cast<std::size_t>(number) + 2 >= nodes_.size() || end - begin <= 1) {
      node.leaf = true;
      return;
    }
    const glm::vec3 extent = high - low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin + 1) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](FacetIndex a, FacetIndex b) {
                       const float at_a = boxes_[a].low[axis] + boxes_[a].high[axis];
                       const float at_b = boxes_[b].low[axis] + boxes_[b].high[axis];
                       return at_a != at_b ? at_a < at_b : a < b;
                     });
    const auto first = [&] { build(2 * number + 1, begin, middle); };
    const auto second = [&] { build(2 * number + 2, middle, end); };
    if (end - begin > k_parallel_facets) {
      tbb::parallel_invoke(first, second);
    } else {
      first();
      second();
    }
  }

  std::vector<FacetIndex> order_;
  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
};

/// What a facet has to do with another one.
template <typename Item>
struct Found {
  FacetIndex facet, other;
  Item item;
};

/// Of what the threads found: by facet, those of one in the order of the others. Throws Cancelled.
template <typename Lists, typename Item>
FacetLists<Item> by_facet(Lists& found, std::vector<Found<Item>> Lists::value_type::*which,
                          std::size_t facets, const Progress& progress) {
  FacetLists<Item> lists;
  lists.first.assign(facets + 1, 0);
  for (const auto& some : found) {
    for (const Found<Item>& one : some.*which) ++lists.first[one.facet + 1];
  }
  std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
  std::vector<std::pair<FacetIndex, Item>> placed(lists.first.back());
  std::vector<std::uint32_t> next(lists.first.begin(), lists.first.end() - 1);
  for (auto& some : found) {
    for (const Found<Item>& one : some.*which) placed[next[one.facet]++] = {one.other, one.item};
    some.*which = {};
  }
  progress.report("finding crossings", 1.0);
  for (std::size_t facet = 0; facet < facets; ++facet) {
    std::stable_sort(placed.begin() + lists.first[facet], placed.begin() + lists.first[facet + 1],
                     [](const auto& x, const auto& y) { return x.first < y.first; });
  }
  lists.items.reserve(placed.size());
  for (const auto& [other, item] : placed) lists.items.push_back(item);
  return lists;
}

int shared_corners(const std::array<VertexIndex, 3>& a, const std::array<VertexIndex, 3>& b) {
  int count = 0;
  for (const VertexIndex vertex : a) count += std::count(b.begin(), b.end(), vertex) > 0 ? 1 : 0;
  return count;
}

/// Where the corners of a triangle lie over a plane.
struct Heights {
  std::array<bool, 3> touches{};
  bool above = false, below = false, in_front = false;

  /// Whether the plane touches the triangle, or cuts it.
  [[nodiscard]] bool meets() const { return (above && below) || touches[0] || touches[1] || touches[2]; }
};

Heights heights_over(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& origin,
                     const glm::dvec3& normal) {
  Heights heights;
  double lowest = 1e300, highest = -1e300;
  for (std::size_t k = 0; k < 3; ++k) {
    const double height = glm::dot(normal, corners[k] - origin);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
    heights.touches[k] = std::abs(height) <= k_facet_touch;
  }
  heights.above = highest > k_facet_touch;
  heights.below = lowest < -k_facet_touch;
  heights.in_front = highest > k_least_in_front && lowest < k_most_in_front;
  return heights;
}

/// The part of a line in b's plane that lies in b.
bool clipped(const CrossingQuery& query, const std::array<glm::dvec3, 2>& ends, FacetCrossing& crossing) {
  const glm::dvec3* b = query.b;
  double begin = 0.0, end = 1.0;
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3 side = b[(k + 1) % 3] - b[k];
    const double length = glm::length(side);
    if (length <= 0.0) return false;
    const glm::dvec3 inward = glm::cross(query.normal_b, side / length);
    const double from = glm::dot(inward, ends[0] - b[k]) + query.slack;
    const double to = glm::dot(inward, ends[1] - b[k]) + query.slack;
    if (from < 0.0 && to < 0.0) return false;
    if (from < 0.0) begin = std::max(begin, from / (from - to));
    if (to < 0.0) end = std::min(end, from / (from - to));
  }
  if (end <= begin) return false;
  crossing = {ends[0] + begin * (ends[1] - ends[0]), ends[0] + end * (ends[1] - ends[0])};
  return glm::distance(crossing.start, crossing.end) > k_shortest_crossing;
}

/// An edge of a that lies in b's plane, as far as it runs inside b: facets on its two sides may cross b
/// there, though each of them only touches it.
bool edge_inside(const Heights& heights, const CrossingQuery& query, FacetCrossing& crossing) {
  const auto& touches = heights.touches;
  if (touches[0] + touches[1] + touches[2] != 2) return false;
  const std::size_t from = !touches[0] ? 1 : !touches[1] ? 2 : 0;
  return clipped(query, {query.a[from], query.a[(from + 1) % 3]}, crossing);
}

}  // namespace

bool triangle_crossing(const CrossingQuery& query, FacetCrossing& crossing) {
  const glm::dvec3* a = query.a;
  const glm::dvec3* b = query.b;
  std::array<double, 3> heights{};
  for (int k = 0; k < 3; ++k) heights[k] = glm::dot(query.normal_b, a[k] - b[0]);
  if (std::max({heights[0], heights[1], heights[2]}) <= k_facet_touch ||
      std::min({heights[0], heights[1], heights[2]}) >= -k_facet_touch) {
    return false;
  }
  // The line through a: from a side that rises through b's plane to one that falls.
  std::array<glm::dvec3, 2> ends{};
  int count = 0;
  for (int k = 0; k < 3 && count < 2; ++k) {
    const double from = heights[k], to = heights[(k + 1) % 3];
    if ((from > 0.0) == (to > 0.0)) continue;
    ends[count++] = a[k] + (from / (from - to)) * (a[(k + 1) % 3] - a[k]);
  }
  if (count < 2) return false;
  return clipped(query, ends, crossing);
}

EncounterBudget encounter_budget(std::size_t facets, double effort) {
  const auto of = [&](std::size_t always, std::size_t a_facet) {
    return static_cast<std::size_t>(effort * static_cast<double>(always + a_facet * facets));
  };
  return {.pairs = of(k_always_pairs, k_pairs_a_facet),
          .crossings = of(k_always_crossings, k_crossings_a_facet),
          .coplanar = false,
          .in_front = true};
}

FacetEncounters facet_encounters(const TriangleMesh& mesh, std::span<const glm::dvec3> positions,
                                 std::span<const glm::dvec3> normals, std::span<const FacetIndex> first_equal,
                                 const EncounterBudget& budget, const Progress& progress) {
  const BoxTree tree(mesh, positions, first_equal);
  const auto corners_of = [&](FacetIndex facet) {
    const auto& corners = mesh.facets[facet];
    return std::array<glm::dvec3, 3>{positions[corners[0]], positions[corners[1]], positions[corners[2]]};
  };
  struct Lists {
    std::vector<Found<FacetCrossing>> crossings;
    std::vector<Found<FacetIndex>> in_front;
    std::size_t uncounted = 0;  // of those in front
    std::size_t uncounted_pairs = 0, counted_crossings = 0;
  };
  const auto add_crossings = [&](FacetIndex facet, FacetIndex other, const Heights& here_over,
                                 const Heights& there_over, std::vector<Found<FacetCrossing>>& found) {
    const auto corners = corners_of(facet), other_corners = corners_of(other);
    FacetCrossing crossing;
    const auto lies_on = [](const Heights& heights) { return !heights.above && !heights.below; };
    if (budget.coplanar && lies_on(here_over) && lies_on(there_over)) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (clipped({corners.data(), other_corners.data(), normals[other], -k_inside},
                    {corners[k], corners[next]}, crossing))
          found.push_back({other, facet, crossing});
        if (clipped({other_corners.data(), corners.data(), normals[facet], -k_inside},
                    {other_corners[k], other_corners[next]}, crossing))
          found.push_back({facet, other, crossing});
      }
      return;
    }
    if (shared_corners(mesh.facets[facet], mesh.facets[other]) >= 2) return;
    if (edge_inside(there_over, {other_corners.data(), corners.data(), normals[facet], -k_inside}, crossing))
      found.push_back({facet, other, crossing});
    if (edge_inside(here_over, {corners.data(), other_corners.data(), normals[other], -k_inside}, crossing))
      found.push_back({other, facet, crossing});
    if (!(here_over.above && here_over.below && there_over.above && there_over.below)) return;
    const CrossingQuery here{corners.data(), other_corners.data(), normals[other], 0.0};
    if (!triangle_crossing(here, crossing)) return;
    found.push_back({facet, other, crossing});
    const CrossingQuery there{other_corners.data(), corners.data(), normals[facet], 0.0};
    if (triangle_crossing(there, crossing)) found.push_back({other, facet, crossing});
  };
  std::atomic<std::size_t> counted = 0;
  const std::size_t most_in_front = k_most_in_front_a_facet * mesh.facets.size() + k_always_in_front;
  const auto add_in_front = [&](FacetIndex facet, FacetIndex other, Lists& found) {
    if (counted.load(std::memory_order_relaxed) > most_in_front) return;
    found.in_front.push_back({facet, other, other});
    if (++found.uncounted < k_counted_at_once) return;
    counted += std::exchange(found.uncounted, 0);
  };
  // Whether there is too much is known by how much there is in all, so that no thread's haste shows.
  std::atomic<std::size_t> pairs = 0, crossings = 0;
  const auto count_work = [&](Lists& found) {
    pairs += std::exchange(found.uncounted_pairs, 0);
    crossings += found.crossings.size() - std::exchange(found.counted_crossings, found.crossings.size());
  };
  const auto too_much = [&] { return pairs > budget.pairs || crossings > budget.crossings; };
  const auto add_pair = [&](FacetIndex facet, FacetIndex other, Lists& found) {
    if (++found.uncounted_pairs >= k_counted_at_once) count_work(found);
    if (normals[other] == glm::dvec3(0.0) || too_much()) return;
    if (!budget.in_front && !budget.coplanar && shared_corners(mesh.facets[facet], mesh.facets[other]) >= 2)
      return;
    const Heights here_over =
        heights_over(corners_of(facet), positions[mesh.facets[other][0]], normals[other]);
    if (!budget.in_front && !here_over.meets()) return;
    const Heights there_over =
        heights_over(corners_of(other), positions[mesh.facets[facet][0]], normals[facet]);
    if (budget.in_front && there_over.in_front) add_in_front(facet, other, found);
    if (budget.in_front && here_over.in_front) add_in_front(other, facet, found);
    if (tree.overlap(facet, other)) add_crossings(facet, other, here_over, there_over, found.crossings);
  };
  const double distance = budget.in_front ? k_most_in_front : 0.0;
  tbb::enumerable_thread_specific<Lists> found;
  const std::span<const BoxTree::Node> nodes = tree.nodes();
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, nodes.size(), k_leaves_a_task), [&](const auto& range) {
        Lists& mine = found.local();
        for (std::size_t k = range.begin(); k < range.end() && !progress.cancelled() && !too_much(); ++k) {
          if (!nodes[k].leaf) continue;
          tree.for_each_near(nodes[k], distance, [&](FacetIndex facet, FacetIndex other) {
            if (normals[facet] != glm::dvec3(0.0)) add_pair(facet, other, mine);
          });
        }
        count_work(mine);
      });
  progress.report("finding crossings", 1.0);
  if (too_much())
    return {.crossings = {{}, std::vector<std::uint32_t>(mesh.facets.size() + 1, 0)},
            .complete = false,
            .in_front = {}};
  // By how many there are in all, whichever thread found them.
  for (const Lists& some : found) counted += some.uncounted;
  FacetEncounters encounters{.crossings = by_facet(found, &Lists::crossings, mesh.facets.size(), progress),
                             .in_front = {}};
  if (budget.in_front && counted <= most_in_front)
    encounters.in_front = by_facet(found, &Lists::in_front, mesh.facets.size(), progress);
  return encounters;
}

}  // namespace moldlight
