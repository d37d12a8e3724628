#include "parting/halves/tidy_solid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <unordered_set>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

constexpr HalfEdgeIndex k_no_edge = ~0U;
constexpr std::size_t k_most_flips = 20;  // a facet, on average

std::uint64_t edge_key(VertexIndex a, VertexIndex b) {
  return a < b ? std::uint64_t{a} << 32U | b : std::uint64_t{b} << 32U | a;
}

/// A mesh whose edges are flipped.
class Flipper {
 public:
  Flipper(TriangleMesh& mesh, const TidyQuery& query) : mesh_(mesh), query_(query) {
    across_.assign(3 * mesh.facets.size(), k_no_edge);
    edges_.reserve(2 * mesh.facets.size());
    EdgeTable(mesh).for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
      edges_.insert(edge_key(low, uses.front().high));
      if (uses.size() != 2) return;
      const HalfEdgeIndex one = uses[0].half_edge, other = uses[1].half_edge;
      if (start_vertex(mesh, one) == start_vertex(mesh, other)) return;
      across_[one] = other;
      across_[other] = one;
    });
  }

  void run() {
    std::vector<HalfEdgeIndex> waiting;
    for (HalfEdgeIndex edge = static_cast<HalfEdgeIndex>(across_.size()); edge-- > 0;) {
      if (across_[edge] != k_no_edge && edge < across_[edge]) waiting.push_back(edge);
    }
    for (std::size_t left = k_most_flips * mesh_.facets.size(); !waiting.empty() && left > 0;) {
      const HalfEdgeIndex edge = waiting.back();
      waiting.pop_back();
      if (across_[edge] == k_no_edge || !should_flip(edge)) continue;
      const HalfEdgeIndex other = across_[edge];
      flip(edge);
      --left;
      for (const FacetIndex facet : {facet_of(edge), facet_of(other)}) {
        for (HalfEdgeIndex k = 0; k < 3; ++k) waiting.push_back(3 * facet + k);
      }
    }
  }

 private:
  static HalfEdgeIndex next(HalfEdgeIndex edge) { return edge % 3 == 2 ? edge - 2 : edge + 1; }

  [[nodiscard]] VertexIndex tip(HalfEdgeIndex edge) const { return end_vertex(mesh_, next(edge)); }

  /// What the facets with these normals, as long as twice the areas, have against the pull.
  struct Against {
    double seen = 0.0, leaning = 0.0;
  };
  [[nodiscard]] Against against(const glm::dvec3& m, const glm::dvec3& n) const {
    Against sum;
    for (const glm::dvec3& normal : {m, n}) {
      const double along = glm::dot(normal, query_.pull);
      sum.seen += std::max(0.0, along);
      if (along > k_leaning_sine * glm::length(normal)) sum.leaning += glm::length(normal);
    }
    return sum;
  }

  [[nodiscard]] bool should_flip(HalfEdgeIndex edge) const {
    const VertexIndex ia = start_vertex(mesh_, edge), ib = end_vertex(mesh_, edge), ic = tip(edge),
                      id = tip(across_[edge]);
    if (ic == id || edges_.contains(edge_key(ic, id))) return false;
    const glm::dvec3 &a = mesh_.vertices[ia], &b = mesh_.vertices[ib], &c = mesh_.vertices[ic],
                     &d = mesh_.vertices[id];
    const glm::dvec3 left = glm::cross(b - a, c - a), right = glm::cross(a - b, d - b);
    // The angles at both tips are more than two right ones together.
    const double sine_c = glm::length(left), sine_d = glm::length(right), cosine_c = glm::dot(a - c, b - c),
                 cosine_d = glm::dot(a - d, b - d);
    const double scale = glm::length(a - c) * glm::length(b - c) * glm::length(a - d) * glm::length(b - d);
    const bool is_rounder = sine_c * cosine_d + cosine_c * sine_d < -1e-9 * scale;
    const glm::dvec3 first = glm::cross(a - c, d - c), second = glm::cross(b - d, c - d),
                     both = first + second;
    const double size = glm::length(both);
    if (std::abs(glm::dot(d - a, left)) > query_.tolerance * size) return false;
    const Against before = against(left, right), after = against(first, second);
    if (after.seen > before.seen || after.leaning > before.leaning) return false;
    if (!is_rounder && after.leaning >= before.leaning) return false;
    return std::ranges::none_of(std::array{first, second}, [&](const glm::dvec3& normal) {
      return glm::dot(normal, both) <= 0.5 * glm::length(normal) * size;
    });
  }

  void flip(HalfEdgeIndex edge) {
    // (a, b, c) and (b, a, d) become (c, a, d) and (d, b, c).
    const HalfEdgeIndex other = across_[edge];
    const VertexIndex a = start_vertex(mesh_, edge), b = end_vertex(mesh_, edge), c = tip(edge),
                      d = tip(other);
    const HalfEdgeIndex bc = across_[next(edge)], ca = across_[next(next(edge))], ad = across_[next(other)],
                        db = across_[next(next(other))];
    const HalfEdgeIndex one = 3 * facet_of(edge), two = 3 * facet_of(other);
    mesh_.facets[facet_of(edge)] = {c, a, d};
    mesh_.facets[facet_of(other)] = {d, b, c};
    const auto join = [&](HalfEdgeIndex x, HalfEdgeIndex y) {
      across_[x] = y;
      if (y != k_no_edge) across_[y] = x;
    };
    join(one, ca);
    join(one + 1, ad);
    join(two, db);
    join(two + 1, bc);
    join(one + 2, two + 2);
    edges_.erase(edge_key(a, b));
    edges_.insert(edge_key(c, d));
  }

  TriangleMesh& mesh_;
  const TidyQuery& query_;
  std::vector<HalfEdgeIndex> across_;
  std::unordered_set<std::uint64_t> edges_;
};

/// Of an edge with more than two facets, the pairs with material between them.
std::vector<std::pair<HalfEdgeIndex, HalfEdgeIndex>> material_pairs(const TriangleMesh& mesh,
                                                                    std::span<const EdgeUse> uses) {
  const VertexIndex from = start_vertex(mesh, uses[0].half_edge), to = end_vertex(mesh, uses[0].half_edge);
  const glm::dvec3 axis = mesh.vertices[to] - mesh.vertices[from];
  const glm::dvec3 reference =
      glm::abs(axis.x) < glm::abs(axis.y) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 y = glm::cross(axis, reference), x = glm::cross(y, axis) / glm::length(axis);
  struct Blade {
    double angle;
    bool ends;  // the material before it, turning about the axis
    HalfEdgeIndex edge;
  };
  std::vector<Blade> blades;
  for (const EdgeUse& use : uses) {
    const glm::dvec3 tip =
        mesh.vertices[end_vertex(mesh, use.half_edge % 3 == 2 ? use.half_edge - 2 : use.half_edge + 1)] -
        mesh.vertices[from];
    blades.push_back({std::atan2(glm::dot(tip, y), glm::dot(tip, x)),
                      start_vertex(mesh, use.half_edge) == from, use.half_edge});
  }
  std::ranges::stable_sort(blades, [](const Blade& p, const Blade& q) {
    return p.angle != q.angle ? p.angle < q.angle : p.ends && !q.ends;
  });
  // Begin where as much material has begun as ends afterwards.
  int depth = 0, least = 0;
  std::size_t start = 0;
  for (std::size_t k = 0; k < blades.size(); ++k) {
    depth += blades[k].ends ? -1 : 1;
    if (depth >= least) continue;
    least = depth;
    start = k + 1;
  }
  std::vector<std::pair<HalfEdgeIndex, HalfEdgeIndex>> pairs;
  std::vector<HalfEdgeIndex> open;
  for (std::size_t k = 0; k < blades.size(); ++k) {
    const Blade& blade = blades[(start + k) % blades.size()];
    if (!blade.ends) {
      open.push_back(blade.edge);
    } else if (!open.empty()) {
      pairs.emplace_back(open.back(), blade.edge);
      open.pop_back();
    }
  }
  return pairs;
}

/// An edge in which a solid touches itself, between two of its facets.
struct TouchingEdge {
  HalfEdgeIndex one = 0, other = 0;
  double share = 0.0;  // of its length, where it is divided
};

/// Vertices on edges keep them apart from others in the same place, even for readers that join equal
/// vertices.
void divide_doubles(TriangleMesh& mesh, std::span<const TouchingEdge> edges) {
  // Of each facet that is divided, its edges with the vertices on them.
  std::map<FacetIndex, std::map<std::uint32_t, VertexIndex>> on_edges;
  for (const auto& [one, other, share] : edges) {
    const glm::dvec3 &a = mesh.vertices[start_vertex(mesh, one)], &b = mesh.vertices[end_vertex(mesh, one)];
    const glm::dvec3 at(glm::vec3(glm::mix(a, b, share)));
    if (at == a || at == b) continue;  // two numbers next to each other
    const auto middle = static_cast<VertexIndex>(mesh.vertices.size());
    mesh.vertices.push_back(at);
    for (const HalfEdgeIndex edge : {one, other}) on_edges[facet_of(edge)][edge % 3] = middle;
  }
  for (const auto& entry : on_edges) {
    const FacetIndex facet = entry.first;
    const std::map<std::uint32_t, VertexIndex>& middles = entry.second;
    std::vector<VertexIndex> outline;
    for (std::uint32_t k = 0; k < 3; ++k) {
      outline.push_back(mesh.facets[facet][k]);
      if (const auto found = middles.find(k); found != middles.end()) outline.push_back(found->second);
    }
    // A fan from a middle, so that no facet lies along an edge; each other middle cuts off a corner.
    while (outline.size() > 3) {
      const auto is_middle = [&](VertexIndex v) {
        return std::ranges::any_of(middles, [&](const auto& middle) { return middle.second == v; });
      };
      const auto corner = std::ranges::find_if(outline, [&](const VertexIndex& v) {
        const std::size_t k = static_cast<std::size_t>(&v - outline.data()), n = outline.size();
        return !is_middle(v) && (is_middle(outline[(k + 1) % n]) || is_middle(outline[(k + n - 1) % n]));
      });
      const std::size_t k = static_cast<std::size_t>(corner - outline.begin()), n = outline.size();
      mesh.facets.push_back({outline[(k + n - 1) % n], *corner, outline[(k + 1) % n]});
      outline.erase(corner);
    }
    mesh.facets[facet] = {outline[0], outline[1], outline[2]};
  }
}

}  // namespace

void drop_fins(TriangleMesh& mesh) {
  struct Place {
    std::array<VertexIndex, 3> corners;  // sorted
    bool even;
    FacetIndex facet;
  };
  std::vector<Place> places;
  places.reserve(mesh.facets.size());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    std::array<VertexIndex, 3> c = mesh.facets[facet];
    std::rotate(c.begin(), std::ranges::min_element(c), c.end());
    const bool even = c[1] < c[2];
    if (!even) std::swap(c[1], c[2]);
    places.push_back({c, even, facet});
  }
  std::ranges::stable_sort(places, {}, &Place::corners);
  std::vector<std::uint8_t> dropped(mesh.facets.size(), 0);
  for (std::size_t first = 0, last = 0; first < places.size(); first = last) {
    std::vector<FacetIndex> even, odd;
    for (; last < places.size() && places[last].corners == places[first].corners; ++last)
      (places[last].even ? even : odd).push_back(places[last].facet);
    for (std::size_t k = 0; k < std::min(even.size(), odd.size()); ++k)
      dropped[even[k]] = dropped[odd[k]] = 1;
  }
  std::size_t kept = 0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (dropped[facet] == 0) mesh.facets[kept++] = mesh.facets[facet];
  }
  mesh.facets.resize(kept);
}

void tidy_solid(TriangleMesh& mesh, const TidyQuery& query) {
  drop_fins(mesh);
  Flipper(mesh, query).run();
  collapse_thin_facets(mesh, query);
  drop_fins(mesh);
}

std::size_t split_touching(TriangleMesh& mesh) {
  UnionFind corners(3 * mesh.facets.size());
  const auto join = [&](HalfEdgeIndex one, HalfEdgeIndex other) {
    const auto after = [](HalfEdgeIndex edge) { return edge % 3 == 2 ? edge - 2 : edge + 1; };
    corners.join(one, after(other));
    corners.join(after(one), other);
  };
  std::size_t touching = 0;
  std::vector<TouchingEdge> doubles;
  EdgeTable(mesh).for_each_edge([&](VertexIndex, std::span<const EdgeUse> uses) {
    if (uses.size() == 2) {
      join(uses[0].half_edge, uses[1].half_edge);
      return;
    }
    ++touching;
    const auto pairs = material_pairs(mesh, uses);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto& [one, other] = pairs[k];
      join(one, other);
      if (k > 0) doubles.push_back({one, other, static_cast<double>(k) / static_cast<double>(pairs.size())});
    }
  });
  std::vector<VertexIndex> number(3 * mesh.facets.size(), ~0U);
  std::vector<glm::dvec3> vertices;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      VertexIndex& known = number[corners.find(3 * facet + k)];
      if (known == ~0U) {
        known = static_cast<VertexIndex>(vertices.size());
        vertices.push_back(mesh.vertices[mesh.facets[facet][k]]);
      }
    }
  }
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    for (std::uint32_t k = 0; k < 3; ++k) mesh.facets[facet][k] = number[corners.find(3 * facet + k)];
  }
  mesh.vertices = std::move(vertices);
  divide_doubles(mesh, doubles);
  return touching;
}

}  // namespace moldlight
