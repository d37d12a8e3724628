#include "parting/halves/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

using Facets = std::vector<std::array<SheetVertex, 3>>;

double height_of(const Sheets& sheets, const SegmentEdge& edge) {
  return sheets.vertices[edge.a].z + sheets.vertices[edge.b].z;
}

/// Facets between two chains of vertices, both from below upwards or from one end to the other: the chain on
/// the right of an observer outside is `right`.
void add_strip(const std::vector<glm::dvec3>& vertices, const std::vector<SheetVertex>& left,
               const std::vector<SheetVertex>& right, bool turned, Facets& facets) {
  const auto add = [&](SheetVertex a, SheetVertex b, SheetVertex c) {
    if (a == b || b == c || c == a) return;
    facets.push_back(turned ? std::array{a, c, b} : std::array{a, b, c});
  };
  std::size_t i = 0, j = 0;
  while (i + 1 < left.size() || j + 1 < right.size()) {
    bool up_left = j + 1 == right.size();
    if (!up_left && i + 1 < left.size()) {
      up_left = glm::distance(vertices[left[i + 1]], vertices[right[j]]) <
                glm::distance(vertices[left[i]], vertices[right[j + 1]]);
    }
    if (up_left) {
      add(left[i], right[j], left[i + 1]);
      ++i;
    } else {
      add(left[i], right[j], right[j + 1]);
      ++j;
    }
  }
}

/// The vertices of each column that a body uses, from below.
class Columns {
 public:
  Columns(const Sheets& sheets, const std::vector<SheetEdge>& edges) : sheets_(sheets) {
    for (const SheetEdge& edge : edges) {
      for (const SheetVertex v : {edge.from, edge.to}) {
        if (sheets.column_of[v] != k_no_plane_point) standing_[sheets.column_of[v]].push_back(v);
      }
    }
    for (auto& [column, list] : standing_) {
      std::ranges::sort(list, {}, [&](SheetVertex v) { return std::pair(sheets.vertices[v].z, v); });
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  }

  /// From one vertex of a column to another above it, or the same.
  [[nodiscard]] std::vector<SheetVertex> between(SheetVertex low, SheetVertex high) const {
    const auto& list = standing_.at(sheets_.column_of[low]);
    const auto first = std::ranges::find(list, low), last = std::ranges::find(list, high);
    return first <= last ? std::vector<SheetVertex>(first, last + 1) : std::vector<SheetVertex>{};
  }

 private:
  const Sheets& sheets_;
  std::unordered_map<PlanePoint, std::vector<SheetVertex>> standing_;
};

/// The walls and the lid of a half, from its open edges.
class BlockSides {
 public:
  BlockSides(Sheets& sheets, double height, bool up, Facets& facets)
      : sheets_(sheets), height_(height), up_(up), facets_(facets) {
    for (const auto& [from, to] : open_edges(facets)) {
      edges_.push_back({from, to});
      for (const SheetVertex v : {from, to}) {
        low_ = glm::min(low_, at(v));
        high_ = glm::max(high_, at(v));
      }
    }
  }

  void run() {
    const glm::dvec2 corners[4] = {low_, {high_.x, low_.y}, high_, {low_.x, high_.y}};
    std::array<SheetVertex, 4> lid{};
    for (std::size_t k = 0; k < 4; ++k) lid[k] = add(corners[k]);
    std::vector<SheetVertex> around;
    for (std::size_t k = 0; k < 4; ++k) {
      around.push_back(lid[k]);
      const auto more = close_side(lid[k], lid[(k + 1) % 4]);
      around.insert(around.end(), more.begin(), more.end());
    }
    if (around.size() == 4) {
      add_lid(lid[0], lid[1], lid[2]);
      add_lid(lid[0], lid[2], lid[3]);
      return;
    }
    const SheetVertex middle = add(0.5 * (low_ + high_));
    for (std::size_t k = 0; k < around.size(); ++k)
      add_lid(middle, around[k], around[(k + 1) % around.size()]);
  }

 private:
  using Edge = std::array<SheetVertex, 2>;

  static std::vector<Edge> open_edges(const Facets& facets) {
    std::map<Edge, int> count;
    for (const auto& facet : facets) {
      for (std::size_t k = 0; k < 3; ++k) {
        const SheetVertex from = facet[k], to = facet[(k + 1) % 3];
        from < to ? ++count[{from, to}] : --count[{to, from}];
      }
    }
    std::vector<Edge> open;
    for (const auto& [edge, uses] : count) {
      if (uses != 0) open.push_back(edge);
    }
    return open;
  }

  [[nodiscard]] glm::dvec2 at(SheetVertex v) const { return glm::dvec2(sheets_.vertices[v]); }
  SheetVertex add(const glm::dvec2& place) {
    sheets_.vertices.emplace_back(place.x, place.y, height_);
    sheets_.column_of.push_back(k_no_plane_point);
    return static_cast<SheetVertex>(sheets_.vertices.size() - 1);
  }
  void add_lid(SheetVertex a, SheetVertex b, SheetVertex c) {
    facets_.push_back(up_ ? std::array{a, b, c} : std::array{a, c, b});
  }

  /// The wall between two of the lid's corners; returns the lid's points between them.
  std::vector<SheetVertex> close_side(SheetVertex first, SheetVertex last) {
    const int fixed = at(first).x == at(last).x ? 0 : 1;  // the coordinate that the side has everywhere
    const double sense = at(last)[1 - fixed] > at(first)[1 - fixed] ? 1.0 : -1.0;
    // Seen from outside, the side runs from left to right.
    const auto along = [&](SheetVertex v) { return sense * at(v)[1 - fixed]; };
    std::vector<SheetVertex> side;
    std::vector<Edge> level;  // from left to right
    bool steps = false;
    for (const auto& [from, to] : edges_) {
      if (at(from)[fixed] != at(first)[fixed] || at(to)[fixed] != at(first)[fixed]) continue;
      side.insert(side.end(), {from, to});
      if (along(from) == along(to)) steps = true;
      if (along(from) != along(to))
        level.push_back(along(from) < along(to) ? Edge{from, to} : Edge{to, from});
    }
    std::ranges::sort(side, {},
                      [&](SheetVertex v) { return std::tuple(along(v), sheets_.vertices[v].z, v); });
    side.erase(std::unique(side.begin(), side.end()), side.end());
    if (!steps) {
      const std::vector<SheetVertex> edge = {first, last};
      add_strip(sheets_.vertices, up_ ? edge : side, up_ ? side : edge, false, facets_);
      return {};
    }
    std::ranges::sort(level, {}, [&](const Edge& edge) { return along(edge[0]); });
    std::vector<SheetVertex> between;
    SheetVertex left = first;
    for (std::size_t k = 0; k < level.size(); ++k) {
      SheetVertex right = last;
      if (k + 1 < level.size()) {
        right = add(at(level[k][1]));
        between.push_back(right);
      }
      add_strip(sheets_.vertices, standing(side, level[k][0], left), standing(side, level[k][1], right),
                false, facets_);
      left = right;
    }
    return between;
  }

  /// What stands between a vertex of the side and the lid, from below.
  [[nodiscard]] std::vector<SheetVertex> standing(const std::vector<SheetVertex>& side, SheetVertex from,
                                                  SheetVertex lid) const {
    std::vector<SheetVertex> list;
    if (!up_) list.push_back(lid);
    const double z = sheets_.vertices[from].z;
    for (const SheetVertex v : side) {
      if (at(v) == at(from) && (up_ ? sheets_.vertices[v].z >= z : sheets_.vertices[v].z <= z))
        list.push_back(v);
    }
    if (up_) list.push_back(lid);
    return list;
  }

  Sheets& sheets_;
  double height_;
  bool up_;
  Facets& facets_;
  std::vector<Edge> edges_;
  glm::dvec2 low_{INFINITY}, high_{-INFINITY};
};

}  // namespace

std::optional<glm::dvec3> close_upright(const Sheets& sheets, const BodySheets& body, Facets& facets) {
  for (const SheetFacet& facet : sheets.facets) {
    if ((Sheets::bit(facet.sheet) & body.sheets) == 0) continue;
    const auto& [a, b, c] = facet.corners;
    facets.push_back((Sheets::bit(facet.sheet) & body.turned) != 0 ? std::array{a, c, b} : facet.corners);
  }
  const std::vector<SheetEdge> edges = sheets.ends(body.sheets, body.turned);
  const Columns columns(sheets, edges);
  std::optional<glm::dvec3> fault;
  const auto on_side = [&](const SegmentEdges& segment) {
    const glm::dvec2 &a = sheets.columns[segment.a], &b = sheets.columns[segment.b];
    return (a.x == b.x && (a.x == body.low.x || a.x == body.high.x)) ||
           (a.y == b.y && (a.y == body.low.y || a.y == body.high.y));
  };
  for (SegmentEdges& segment : sheets.by_segment(edges)) {
    if (on_side(segment)) continue;
    std::ranges::sort(segment.edges, [&](const SegmentEdge& x, const SegmentEdge& y) {
      return height_of(sheets, x) < height_of(sheets, y);
    });
    int open = 0;
    for (std::size_t k = 0; k + 1 < segment.edges.size(); ++k) {
      const SegmentEdge &low = segment.edges[k], &high = segment.edges[k + 1];
      open -= low.sign;
      if (open == 0) continue;
      const auto at_a = columns.between(low.a, high.a), at_b = columns.between(low.b, high.b);
      if (at_a.empty() || at_b.empty()) {
        fault = sheets.vertices[low.a];
        continue;
      }
      for (int copy = 0; copy < std::abs(open); ++copy)
        add_strip(sheets.vertices, at_a, at_b, open < 0, facets);
    }
    if (!segment.edges.empty()) open -= segment.edges.back().sign;
    if (open != 0) fault = sheets.vertices[segment.edges.front().a];
  }
  return fault;
}

void add_block(Sheets& sheets, const BlockHeights& heights, bool up, Facets& facets) {
  BlockSides(sheets, up ? heights.high : heights.low, up, facets).run();
}

BodyCheck check_body(const std::vector<glm::dvec3>& vertices, const Facets& facets) {
  struct Use {
    std::uint64_t key;
    int sense;
  };
  BodyCheck check;
  std::vector<Use> uses;
  uses.reserve(3 * facets.size());
  long double volume = 0.0L;
  for (const auto& facet : facets) {
    volume += static_cast<long double>(
        glm::dot(vertices[facet[0]], glm::cross(vertices[facet[1]], vertices[facet[2]])));
    for (std::size_t k = 0; k < 3; ++k) {
      const SheetVertex from = facet[k], to = facet[(k + 1) % 3];
      uses.push_back({Sheets::edge_key(from, to), from < to ? 1 : -1});
    }
  }
  check.volume = static_cast<double>(volume / 6.0L);
  std::ranges::sort(uses, {}, &Use::key);
  for (std::size_t k = 0; k < uses.size();) {
    const std::uint64_t key = uses[k].key;
    int sum = 0, count = 0;
    for (; k < uses.size() && uses[k].key == key; ++k, ++count) sum += uses[k].sense;
    check.open_edges += sum != 0 ? 1 : 0;
    if (sum != 0) check.open_at = 0.5 * (vertices[key >> 32U] + vertices[key & 0xffffffffU]);
    check.nonmanifold_edges += sum == 0 && count > 2 ? 1 : 0;
  }
  return check;
}

TriangleMesh body_mesh(const std::vector<glm::dvec3>& vertices, const Facets& facets) {
  TriangleMesh mesh;
  std::vector<VertexIndex> number(vertices.size(), ~0U);
  mesh.facets.reserve(facets.size());
  for (auto facet : facets) {
    for (SheetVertex& corner : facet) {
      VertexIndex& known = number[corner];
      if (known == ~0U) {
        known = static_cast<VertexIndex>(mesh.vertices.size());
        mesh.vertices.push_back(vertices[corner]);
      }
      corner = known;
    }
    mesh.facets.push_back(facet);
  }
  return mesh;
}

std::vector<std::vector<std::array<SheetVertex, 3>>> connected_bodies(
    std::size_t vertices, const std::vector<std::array<SheetVertex, 3>>& facets) {
  UnionFind joined(vertices);
  for (const auto& [a, b, c] : facets) {
    joined.join(a, b);
    joined.join(b, c);
  }
  std::map<std::uint32_t, std::vector<std::array<SheetVertex, 3>>> found;
  for (const auto& facet : facets) found[joined.find(facet[0])].push_back(facet);
  std::vector<std::vector<std::array<SheetVertex, 3>>> bodies;
  for (auto& [root, body] : found) bodies.push_back(std::move(body));
  return bodies;
}

bool has_corner(const std::vector<glm::dvec3>& vertices, const Facets& facets, const glm::dvec3& place,
                double near) {
  return std::ranges::any_of(facets, [&](const auto& facet) {
    return std::ranges::any_of(facet,
                               [&](SheetVertex v) { return glm::distance(vertices[v], place) < near; });
  });
}

std::optional<TriangleMesh> half_with_bodies(Sheets sheets, const std::vector<Facets>& bodies, bool up,
                                             const BodySheets& half, const BlockHeights& block) {
  std::vector<std::uint8_t> its(sheets.vertices.size(), 0);
  for (const Facets& body : bodies) {
    for (const auto& facet : body) {
      for (const SheetVertex v : facet) its[v] = 1;
    }
  }
  for (SheetFacet& facet : sheets.facets) {
    if (facet.sheet == Sheet::hidden &&
        std::ranges::all_of(facet.corners, [&](SheetVertex v) { return its[v] != 0; }))
      facet.sheet = up ? Sheet::upper : Sheet::lower;
  }
  Facets facets;
  if (close_upright(sheets, half, facets)) return std::nullopt;
  add_block(sheets, block, up, facets);
  if (check_body(sheets.vertices, facets).open_edges > 0) return std::nullopt;
  return body_mesh(sheets.vertices, facets);
}

std::vector<ContactWall> contact_walls(const Sheets& sheets, double tolerance) {
  const auto upper = Sheets::bit(Sheet::upper), lower = Sheets::bit(Sheet::lower),
             parting = Sheets::bit(Sheet::parting);
  const auto core = sheets.by_segment(sheets.ends(upper | parting)),
             cavity = sheets.by_segment(sheets.ends(lower | parting, parting));
  const auto key = [](const SegmentEdges& s) { return Sheets::edge_key(s.a, s.b); };
  struct Wall {
    ContactWall contact;
    PlanePoint column;
  };
  std::vector<Wall> walls;
  UnionFind joined(sheets.columns.size());
  for (std::size_t i = 0, j = 0; i < core.size() && j < cavity.size();) {
    if (key(core[i]) != key(cavity[j])) {
      ++(key(core[i]) < key(cavity[j]) ? i : j);
      continue;
    }
    struct Step {
      SegmentEdge edge;
      bool of_core;
    };
    std::vector<Step> steps;
    for (const SegmentEdge& edge : core[i].edges) steps.push_back({edge, true});
    for (const SegmentEdge& edge : cavity[j].edges) steps.push_back({edge, false});
    std::ranges::sort(steps, [&](const Step& x, const Step& y) {
      return height_of(sheets, x.edge) < height_of(sheets, y.edge);
    });
    const double length = glm::distance(sheets.columns[core[i].a], sheets.columns[core[i].b]);
    int open_core = 0, open_cavity = 0;
    for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
      (steps[k].of_core ? open_core : open_cavity) -= steps[k].edge.sign;
      const double low = 0.5 * height_of(sheets, steps[k].edge),
                   high = 0.5 * height_of(sheets, steps[k + 1].edge);
      if (open_core == 0 || open_cavity == 0 || high - low <= tolerance) continue;
      const glm::dvec2 middle = 0.5 * (sheets.columns[core[i].a] + sheets.columns[core[i].b]);
      walls.push_back(
          {{glm::dvec3(middle, 0.5 * (low + high)), high - low, length * (high - low)}, core[i].a});
      joined.join(core[i].a, core[i].b);
    }
    ++i;
    ++j;
  }
  std::map<std::uint32_t, ContactWall> together;
  for (const Wall& wall : walls) {
    ContactWall& sum = together[joined.find(wall.column)];
    sum.area += wall.contact.area;
    if (wall.contact.height <= sum.height) continue;
    sum.height = wall.contact.height;
    sum.place = wall.contact.place;
  }
  std::vector<ContactWall> found;
  for (const auto& [column, wall] : together) found.push_back(wall);
  std::ranges::stable_sort(found, std::greater(), &ContactWall::area);
  return found;
}

}  // namespace moldlight
