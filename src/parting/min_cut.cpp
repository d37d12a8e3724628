#include "parting/min_cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moldlight {

namespace {

/// Flow in a graph with arcs in pairs: arc k ^ 1 is the other way of arc k.
class Flow {
 public:
  explicit Flow(std::size_t nodes) : first_(nodes, k_none), level_(nodes), next_(nodes) {}

  void add(std::uint32_t from, std::uint32_t to, std::int64_t capacity, std::int64_t back) {
    arcs_.push_back({to, first_[from], capacity});
    first_[from] = static_cast<std::uint32_t>(arcs_.size() - 1);
    arcs_.push_back({from, first_[to], back});
    first_[to] = static_cast<std::uint32_t>(arcs_.size() - 1);
  }

  void run(std::uint32_t source, std::uint32_t sink, const Progress& progress) {
    while (find_levels(source, sink)) {
      progress.report("cutting", 0.0);
      next_ = first_;
      push_paths(source, sink);
    }
  }

  /// After run(): whether the source still reaches the node.
  [[nodiscard]] bool reached(std::uint32_t node) const { return level_[node] != k_none; }

 private:
  static constexpr std::uint32_t k_none = ~0U;
  struct Arc {
    std::uint32_t to, next;
    std::int64_t left;
  };

  bool find_levels(std::uint32_t source, std::uint32_t sink) {
    std::ranges::fill(level_, k_none);
    queue_.assign(1, source);
    level_[source] = 0;
    for (std::size_t k = 0; k < queue_.size(); ++k) {
      const std::uint32_t node = queue_[k];
      for (std::uint32_t arc = first_[node]; arc != k_none; arc = arcs_[arc].next) {
        const std::uint32_t to = arcs_[arc].to;
        if (arcs_[arc].left <= 0 || level_[to] != k_none) continue;
        level_[to] = level_[node] + 1;
        queue_.push_back(to);
      }
    }
    return level_[sink] != k_none;
  }

  /// Fills every shortest path, one after the other, by a walk that steps back where it gets no further.
  void push_paths(std::uint32_t source, std::uint32_t sink) {
    std::vector<std::uint32_t> path;  // arcs
    std::uint32_t node = source;
    for (;;) {
      if (node == sink) {
        std::int64_t least = std::numeric_limits<std::int64_t>::max();
        for (const std::uint32_t arc : path) least = std::min(least, arcs_[arc].left);
        std::size_t full = path.size();
        for (std::size_t k = path.size(); k-- > 0;) {
          arcs_[path[k]].left -= least;
          arcs_[path[k] ^ 1U].left += least;
          if (arcs_[path[k]].left == 0) full = k;
        }
        node = arcs_[path[full] ^ 1U].to;
        path.resize(full);
        continue;
      }
      std::uint32_t& arc = next_[node];
      while (arc != k_none && (arcs_[arc].left <= 0 || level_[arcs_[arc].to] != level_[node] + 1))
        arc = arcs_[arc].next;
      if (arc != k_none) {
        path.push_back(arc);
        node = arcs_[arc].to;
      } else if (node == source) {
        return;
      } else {
        level_[node] = k_none;
        node = arcs_[path.back() ^ 1U].to;
        path.pop_back();
      }
    }
  }

  std::vector<Arc> arcs_;
  std::vector<std::uint32_t> first_, level_, next_, queue_;
};

}  // namespace

std::vector<std::uint8_t> MinCut::solve(const Progress& progress) const {
  double greatest = 0.0;
  for (const auto& cost : costs_) greatest = std::max({greatest, cost[0], cost[1]});
  for (const Link& link : links_) greatest = std::max(greatest, link.cost);
  if (!(greatest > 0.0)) return std::vector<std::uint8_t>(costs_.size(), 1);
  const double scale = std::ldexp(1.0, 40) / greatest;
  const auto whole = [&](double cost) { return static_cast<std::int64_t>(std::llround(cost * scale)); };

  // The source stands for side 0: what is on side 1 cuts the arc from it.
  const auto source = static_cast<std::uint32_t>(costs_.size()), sink = source + 1;
  Flow flow(costs_.size() + 2);
  for (std::uint32_t node = 0; node < costs_.size(); ++node) {
    const double both = std::min(costs_[node][0], costs_[node][1]);
    const std::int64_t zero = whole(costs_[node][0] - both), one = whole(costs_[node][1] - both);
    if (one > 0) flow.add(source, node, one, 0);
    if (zero > 0) flow.add(node, sink, zero, 0);
  }
  for (const Link& link : links_) flow.add(link.a, link.b, whole(link.cost), whole(link.cost));
  flow.run(source, sink, progress);
  std::vector<std::uint8_t> sides(costs_.size());
  for (std::uint32_t node = 0; node < costs_.size(); ++node) sides[node] = flow.reached(node) ? 0 : 1;
  return sides;
}

}  // namespace moldlight
