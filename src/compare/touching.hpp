// Which flat pieces of surface hang together.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/progress.hpp"
#include "compare/convex_polygon.hpp"
#include "mesh/union_find.hpp"

namespace moldlight {

/// A polygon and how far around its rim others are one with it; one without corners touches nothing.
struct ReachingPolygon {
  const ConvexPolygon* polygon = nullptr;
  double reach = 0.0;
};

/// Calls `touch` for pairs whose rims come as near to each other as `reach` says, which is asked first and is
/// negative for pairs that do not matter, and at most the sum of theirs; in an order that depends on the
/// polygons alone, a pair perhaps several times. `extent` is about that of all of them. Throws Cancelled.
void visit_touching(const std::vector<ReachingPolygon>& polygons, double extent,
                    const std::function<double(std::uint32_t, std::uint32_t)>& reach,
                    const std::function<void(std::uint32_t, std::uint32_t)>& touch, const Progress& progress);

/// Joins all that touch each other.
[[nodiscard]] UnionFind joined_where_touching(const std::vector<ReachingPolygon>& polygons, double extent,
                                              const Progress& progress);

}  // namespace moldlight
