#include "parting/halves/plane_mesh.hpp"

#include <cmath>

#include "base/check.hpp"

namespace moldlight {

namespace {

__extension__ typedef __int128 Wide;

constexpr double k_grid = 35184372088832.0;  // 2^45

std::int64_t whole(double coordinate) { return static_cast<std::int64_t>(std::llround(coordinate * k_grid)); }

/// Above 0 where d lies in the circle through a, b, c; up to rounding, as a share of the greatest term.
bool surely_in_circle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const glm::dvec2 p = a - d, q = b - d, r = c - d;
  const double pp = p.x * p.x + p.y * p.y, qq = q.x * q.x + q.y * q.y, rr = r.x * r.x + r.y * r.y;
  const double one = pp * (q.x * r.y - q.y * r.x), two = qq * (r.x * p.y - r.y * p.x),
               three = rr * (p.x * q.y - p.y * q.x);
  const double size = pp * (std::abs(q.x * r.y) + std::abs(q.y * r.x)) +
                      qq * (std::abs(r.x * p.y) + std::abs(r.y * p.x)) +
                      rr * (std::abs(p.x * q.y) + std::abs(p.y * q.x));
  return one + two + three > 1e-13 * size;
}

std::uint32_t next(std::uint32_t side) { return side == 2 ? 0 : side + 1; }
std::uint32_t last(std::uint32_t side) { return side == 0 ? 2 : side - 1; }

}  // namespace

int PlaneMesh::side_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const double quick = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  const double size = std::abs((b.x - a.x) * (c.y - a.y)) + std::abs((b.y - a.y) * (c.x - a.x));
  if (std::abs(quick) > 1e-14 * size) return quick > 0.0 ? 1 : -1;
  const std::int64_t ax = whole(a.x), ay = whole(a.y);
  const Wide exact =
      Wide{whole(b.x) - ax} * Wide{whole(c.y) - ay} - Wide{whole(b.y) - ay} * Wide{whole(c.x) - ax};
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

PlaneMesh::PlaneMesh(const glm::dvec2& low, const glm::dvec2& high)
    : points_{low, {high.x, low.y}, high, {low.x, high.y}} {
  triangles_.push_back({{0, 1, 2}, {k_none, k_none, 1}, {k_rim, k_rim, 0}, false});
  triangles_.push_back({{0, 2, 3}, {0, k_none, k_none}, {0, k_rim, k_rim}, false});
  triangle_at_ = {0, 0, 0, 1};
}

std::uint32_t PlaneMesh::side_towards(std::uint32_t triangle, std::uint32_t neighbour) const {
  const auto& across = triangles_[triangle].across;
  return across[0] == neighbour ? 0 : across[1] == neighbour ? 1 : 2;
}

void PlaneMesh::set_across(std::uint32_t triangle, std::uint32_t neighbour, std::uint32_t becomes) {
  if (triangle != k_none) triangles_[triangle].across[side_towards(triangle, neighbour)] = becomes;
}

void PlaneMesh::note(std::uint32_t triangle) {
  for (const std::uint32_t corner : triangles_[triangle].corners) triangle_at_[corner] = triangle;
}

std::uint32_t PlaneMesh::locate(const glm::dvec2& at) const {
  std::uint32_t triangle = last_ < triangles_.size() ? last_ : 0;
  // A walk in a Delaunay triangulation ends; segments may send it around, so it turns another way by times.
  for (std::size_t step = 0; step < 4 * triangles_.size() + 16; ++step) {
    const Triangle& t = triangles_[triangle];
    std::uint32_t towards = k_none;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t side = (k + static_cast<std::uint32_t>(step % 3)) % 3;
      if (side_of(points_[t.corners[side]], points_[t.corners[next(side)]], at) < 0) {
        towards = t.across[side];
        CHECK(towards != k_none);
        break;
      }
    }
    if (towards == k_none) return last_ = triangle;
    triangle = towards;
  }
  for (triangle = 0; triangle < triangles_.size(); ++triangle) {
    const Triangle& t = triangles_[triangle];
    bool within = true;
    for (std::uint32_t side = 0; side < 3; ++side)
      within = within && side_of(points_[t.corners[side]], points_[t.corners[next(side)]], at) >= 0;
    if (within) return last_ = triangle;
  }
  CHECK(false);
  return k_none;
}

std::uint32_t PlaneMesh::add_point(const glm::dvec2& at) {
  const std::uint32_t triangle = locate(at);
  const Triangle t = triangles_[triangle];
  std::uint32_t on_side = k_none;
  for (std::uint32_t side = 0; side < 3; ++side) {
    if (points_[t.corners[side]] == at) return t.corners[side];
    if (side_of(points_[t.corners[side]], points_[t.corners[next(side)]], at) == 0) on_side = side;
  }
  const auto point = static_cast<std::uint32_t>(points_.size());
  points_.push_back(at);
  triangle_at_.push_back(triangle);
  std::vector<Edge> edges;
  if (on_side == k_none) {
    split_triangle(triangle, point, edges);
  } else {
    split_side({triangle, on_side}, point, edges);
  }
  legalize(std::move(edges));
  return point;
}

void PlaneMesh::split_triangle(std::uint32_t triangle, std::uint32_t point, std::vector<Edge>& edges) {
  const Triangle t = triangles_[triangle];
  const auto first = static_cast<std::uint32_t>(triangles_.size());
  const std::array<std::uint32_t, 3> numbers = {triangle, first, first + 1};
  triangles_.resize(triangles_.size() + 2);
  for (std::uint32_t k = 0; k < 3; ++k) {
    triangles_[numbers[k]] = {{t.corners[k], t.corners[next(k)], point},
                              {t.across[k], numbers[next(k)], numbers[last(k)]},
                              {t.fixed[k], 0, 0},
                              t.inside,
                              t.region};
    set_across(t.across[k] == k_none ? k_none : t.across[k], triangle, numbers[k]);
    edges.push_back({numbers[k], 0});
  }
  for (const std::uint32_t number : numbers) note(number);
}

void PlaneMesh::split_side(const Edge& edge, std::uint32_t point, std::vector<Edge>& edges) {
  // Each triangle at the side becomes two: (a, point, tip) and (point, b, tip).
  const std::uint32_t here = edge.triangle, there = triangles_[here].across[edge.side];
  const auto here_new = static_cast<std::uint32_t>(triangles_.size());
  const std::uint32_t there_new = there == k_none ? k_none : here_new + 1;
  const std::uint32_t there_side = there == k_none ? 0 : side_towards(there, here);
  triangles_.resize(triangles_.size() + (there == k_none ? 1 : 2));
  const auto halve = [&](std::uint32_t number, std::uint32_t fresh, std::uint32_t side, std::uint32_t other,
                         std::uint32_t other_fresh) {
    const Triangle t = triangles_[number];
    const std::uint32_t a = t.corners[side], b = t.corners[next(side)], tip = t.corners[last(side)];
    const std::uint8_t fixed = t.fixed[side];
    // Runs the other way over there: its first half lies at our second.
    triangles_[number] = {{a, point, tip},
                          {other_fresh, fresh, t.across[last(side)]},
                          {fixed, 0, t.fixed[last(side)]},
                          t.inside,
                          t.region};
    triangles_[fresh] = {{point, b, tip},
                         {other, t.across[next(side)], number},
                         {fixed, t.fixed[next(side)], 0},
                         t.inside,
                         t.region};
    set_across(t.across[next(side)], number, fresh);
    edges.push_back({number, 2});
    edges.push_back({fresh, 1});
  };
  halve(here, here_new, edge.side, there, there_new);
  if (there != k_none) {
    halve(there, there_new, there_side, here, here_new);
    note(there);
    note(there_new);
  }
  note(here);
  note(here_new);
}

bool PlaneMesh::should_flip(const Edge& edge) const {
  const Triangle& t = triangles_[edge.triangle];
  if (t.fixed[edge.side] != 0 || t.across[edge.side] == k_none) return false;
  const Triangle& u = triangles_[t.across[edge.side]];
  const std::uint32_t other = u.corners[last(side_towards(t.across[edge.side], edge.triangle))];
  const glm::dvec2 &a = points_[t.corners[edge.side]], &b = points_[t.corners[next(edge.side)]],
                   &tip = points_[t.corners[last(edge.side)]], &far = points_[other];
  return surely_in_circle(a, b, tip, far) && side_of(tip, a, far) > 0 && side_of(far, b, tip) > 0;
}

void PlaneMesh::flip(const Edge& edge) {
  const std::uint32_t here = edge.triangle, there = triangles_[here].across[edge.side];
  const std::uint32_t back = side_towards(there, here);
  const Triangle t = triangles_[here], u = triangles_[there];
  const std::uint32_t a = t.corners[edge.side], b = t.corners[next(edge.side)],
                      tip = t.corners[last(edge.side)], far = u.corners[last(back)];
  // (a, b, tip) and (b, a, far) become (tip, a, far) and (far, b, tip).
  triangles_[here] = {{tip, a, far},
                      {t.across[last(edge.side)], u.across[next(back)], there},
                      {t.fixed[last(edge.side)], u.fixed[next(back)], 0},
                      t.inside,
                      t.region};
  triangles_[there] = {{far, b, tip},
                       {u.across[last(back)], t.across[next(edge.side)], here},
                       {u.fixed[last(back)], t.fixed[next(edge.side)], 0},
                       t.inside,
                       t.region};
  set_across(u.across[next(back)], there, here);
  set_across(t.across[next(edge.side)], here, there);
  note(here);
  note(there);
}

void PlaneMesh::legalize(std::vector<Edge> edges) {
  // Flips go on only where they are surely better, so they come to an end; the bound is for rounding.
  std::size_t left = 64 * (edges.size() + 1) + 16 * triangles_.size();
  while (!edges.empty() && left-- > 0) {
    const Edge edge = edges.back();
    edges.pop_back();
    if (!should_flip(edge)) continue;
    const std::uint32_t there = triangles_[edge.triangle].across[edge.side];
    flip(edge);
    for (const std::uint32_t number : {edge.triangle, there}) {
      edges.push_back({number, 0});
      edges.push_back({number, 1});
    }
  }
}

template <typename Visit>
void PlaneMesh::visit_around(std::uint32_t point, const Visit& visit) const {
  // One way and, where the border ends that, the other.
  for (const bool forward : {true, false}) {
    std::uint32_t triangle = triangle_at_[point];
    const std::uint32_t first = triangle;
    do {
      const Triangle& t = triangles_[triangle];
      const std::uint32_t k = t.corners[0] == point ? 0 : t.corners[1] == point ? 1 : 2;
      if (visit(Edge{triangle, k})) return;
      triangle = t.across[forward ? last(k) : k];
    } while (triangle != k_none && triangle != first);
    if (triangle == first) return;
  }
}

std::optional<PlaneMesh::Edge> PlaneMesh::edge_between(std::uint32_t a, std::uint32_t b) const {
  std::optional<Edge> found;
  visit_around(a, [&](const Edge& at) {
    const Triangle& t = triangles_[at.triangle];
    if (t.corners[next(at.side)] == b) found = at;
    if (!found && t.corners[last(at.side)] == b) found = Edge{at.triangle, last(at.side)};
    return found.has_value();
  });
  return found;
}

std::optional<PlaneMesh::Obstacle> PlaneMesh::add_segment(std::uint32_t a, std::uint32_t b,
                                                          std::uint8_t kind) {
  const auto fix = [&](const Edge& edge) {
    Triangle& t = triangles_[edge.triangle];
    t.fixed[edge.side] = kind;
    const std::uint32_t there = t.across[edge.side];
    if (there != k_none) triangles_[there].fixed[side_towards(there, edge.triangle)] = kind;
  };
  if (const auto edge = edge_between(a, b)) {
    fix(*edge);
    return std::nullopt;
  }
  // The triangle at a through whose far side the segment leaves.
  const glm::dvec2 &from = points_[a], &to = points_[b];
  std::optional<Edge> leaves;
  std::optional<std::uint32_t> meets;
  const auto ahead = [&](std::uint32_t p) {
    return (points_[p].x - from.x) * (to.x - from.x) + (points_[p].y - from.y) * (to.y - from.y) > 0.0;
  };
  visit_around(a, [&](const Edge& at) {
    const Triangle& t = triangles_[at.triangle];
    const std::uint32_t right = t.corners[next(at.side)], left = t.corners[last(at.side)];
    const int of_right = side_of(from, to, points_[right]), of_left = side_of(from, to, points_[left]);
    if (of_right == 0 && ahead(right)) {
      meets = right;
    } else if (of_left == 0 && ahead(left)) {
      meets = left;
    } else if (of_right < 0 && of_left > 0) {
      leaves = Edge{at.triangle, next(at.side)};
    }
    return meets.has_value() || leaves.has_value();
  });
  if (meets) return Obstacle{.point = *meets};
  if (!leaves) return Obstacle{};
  std::vector<std::array<std::uint32_t, 2>> crossed;  // from right to left
  for (Edge edge = *leaves;;) {
    const Triangle& t = triangles_[edge.triangle];
    const std::uint32_t right = t.corners[edge.side], left = t.corners[next(edge.side)];
    if (t.fixed[edge.side] != 0) return Obstacle{.segment = {right, left}};
    crossed.push_back({right, left});
    const std::uint32_t there = t.across[edge.side], back = side_towards(there, edge.triangle);
    const std::uint32_t tip = triangles_[there].corners[last(back)];
    if (tip == b) break;
    const int side = side_of(from, to, points_[tip]);
    if (side == 0) return Obstacle{.point = tip};
    // Over there the side runs from left to right.
    edge = side > 0 ? Edge{there, next(back)} : Edge{there, last(back)};
    // The side that the segment leaves by has its right end first.
  }
  std::vector<std::array<std::uint32_t, 2>> done;
  std::size_t tries = 64 * crossed.size() * crossed.size() + 64;
  for (std::size_t head = 0; head < crossed.size(); ++head) {
    if (tries-- == 0) return Obstacle{};
    const auto [right, left] = crossed[head];
    const auto edge = edge_between(right, left);
    CHECK(edge.has_value());
    const Triangle& t = triangles_[edge->triangle];
    const std::uint32_t there = t.across[edge->side];
    const std::uint32_t tip = t.corners[last(edge->side)];
    const std::uint32_t far = triangles_[there].corners[last(side_towards(there, edge->triangle))];
    const glm::dvec2 &p = points_[t.corners[edge->side]], &q = points_[t.corners[next(edge->side)]];
    if (side_of(points_[tip], p, points_[far]) <= 0 || side_of(points_[far], q, points_[tip]) <= 0) {
      crossed.push_back(crossed[head]);
      continue;
    }
    flip(*edge);
    const int of_tip = side_of(from, to, points_[tip]), of_far = side_of(from, to, points_[far]);
    if (tip != a && tip != b && far != a && far != b && of_tip * of_far < 0) {
      crossed.push_back({tip, far});
    } else {
      done.push_back({tip, far});
    }
  }
  const auto edge = edge_between(a, b);
  if (!edge) return Obstacle{};
  fix(*edge);
  // Positions of edges change with every flip, so one after the other.
  for (const auto& [p, q] : done) {
    if (const auto again = edge_between(p, q)) legalize({*again});
  }
  return std::nullopt;
}

std::uint32_t PlaneMesh::divide_segment(std::uint32_t a, std::uint32_t b, const glm::dvec2& at) {
  const std::optional<Edge> edge = edge_between(a, b);
  if (!edge || triangles_[edge->triangle].fixed[edge->side] == 0 || at == points_[a] || at == points_[b])
    return k_none;
  // It may lie beside the segment by a cell of the grid, which must not turn a triangle over.
  for (const std::uint32_t number : {edge->triangle, triangles_[edge->triangle].across[edge->side]}) {
    if (number == k_none) continue;
    const Triangle& t = triangles_[number];
    const std::uint32_t side = number == edge->triangle ? edge->side : side_towards(number, edge->triangle);
    const glm::dvec2 &from = points_[t.corners[side]], &to = points_[t.corners[next(side)]],
                     &tip = points_[t.corners[last(side)]];
    if (side_of(at, to, tip) <= 0 || side_of(from, at, tip) <= 0) return k_none;
  }
  const auto point = static_cast<std::uint32_t>(points_.size());
  points_.push_back(at);
  triangle_at_.push_back(edge->triangle);
  std::vector<Edge> edges;
  split_side(*edge, point, edges);
  legalize(std::move(edges));
  return point;
}

}  // namespace moldlight
