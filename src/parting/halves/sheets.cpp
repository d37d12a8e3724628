#include "parting/halves/sheets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

constexpr int k_most_sheet_rounds = 8;

}  // namespace

/// Numbers of points; `cell` is the edge length of a cell, over 0.
class Sheets::PlaneGrid {
 public:
  PlaneGrid(double cell, std::span<const glm::dvec2> points) : cell_(cell) {
    while (first_.size() <= points.size()) first_.resize(2 * first_.size());
    first_.resize(first_.size() + 1);
    std::vector<std::uint64_t> keys;
    keys.reserve(points.size());
    for (const glm::dvec2& at : points)
      ++first_[bucket(keys.emplace_back(key(place(at.x), place(at.y)))) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    placed_.resize(points.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t item = 0; item < points.size(); ++item)
      placed_[next[bucket(keys[item])]++] = {keys[item], item};
  }

  /// Every item within half a cell of the point, and others.
  template <typename Visit>
  void for_each_near(const glm::dvec2& at, const Visit& visit) const {
    const std::int64_t x0 = place(at.x - 0.5 * cell_), x1 = place(at.x + 0.5 * cell_),
                       y0 = place(at.y - 0.5 * cell_), y1 = place(at.y + 0.5 * cell_);
    for (std::int64_t x = x0; x <= x1; ++x) {
      for (std::int64_t y = y0; y <= y1; ++y) visit_cell(x, y, visit);
    }
  }

  /// Every item within a quarter of a cell of the segment, and others.
  template <typename Visit>
  void for_each_along(const glm::dvec2& a, const glm::dvec2& b, const Visit& visit) const {
    const double reach = 0.25 * cell_;
    const std::int64_t first = place(std::min(a.x, b.x) - reach), last = place(std::max(a.x, b.x) + reach);
    const double slope = a.x == b.x ? 0.0 : (b.y - a.y) / (b.x - a.x);
    for (std::int64_t x = first; x <= last; ++x) {
      double y0 = std::min(a.y, b.y), y1 = std::max(a.y, b.y);
      if (a.x != b.x && first != last) {
        const double left = a.y + (static_cast<double>(x) * cell_ - reach - a.x) * slope,
                     right = a.y + (static_cast<double>(x + 1) * cell_ + reach - a.x) * slope;
        y0 = std::max(y0, std::min(left, right));
        y1 = std::min(y1, std::max(left, right));
      }
      for (std::int64_t y = place(y0 - reach); y <= place(y1 + reach); ++y) visit_cell(x, y, visit);
    }
  }

 private:
  [[nodiscard]] std::int64_t place(double at) const {
    return static_cast<std::int64_t>(std::floor(at / cell_));
  }
  [[nodiscard]] static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return (static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL) ^
           (static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fULL);
  }
  template <typename Visit>
  void visit_cell(std::int64_t x, std::int64_t y, const Visit& visit) const {
    const std::uint64_t its = key(x, y);
    const std::size_t in = bucket(its);
    for (std::uint32_t k = first_[in]; k < first_[in + 1]; ++k)
      if (placed_[k].key == its) visit(placed_[k].item);
  }
  [[nodiscard]] std::size_t bucket(std::uint64_t key) const {
    return (key ^ (key >> 32U)) & (first_.size() - 2);
  }

  struct Placed {
    std::uint64_t key;
    std::uint32_t item;
  };
  double cell_;
  std::vector<std::uint32_t> first_ = std::vector<std::uint32_t>(1);  // of each bucket, and one more
  std::vector<Placed> placed_;                                        // by bucket, rising in each
};

/// What the rounds of putting columns in have in common: columns and ends stay where they are.
struct Sheets::Passing {
  std::optional<PlaneGrid> grid;       // of the columns
  std::vector<std::uint64_t> by_none;  // keys of the edges that pass no column, rising
};

glm::dvec2 on_grid(const glm::dvec2& at) {
  constexpr double k_cells = 35184372088832.0;  // 2^45
  return glm::round(at * k_cells) / k_cells;
}

PlanePoint Sheets::add_column(const glm::dvec2& at) {
  columns.push_back(on_grid(at));
  moved.push_back(0.0);
  return static_cast<PlanePoint>(columns.size() - 1);
}

SheetVertex Sheets::add_vertex(PlanePoint column, double z) {
  vertices.emplace_back(columns[column].x, columns[column].y, z);
  column_of.push_back(column);
  return static_cast<SheetVertex>(vertices.size() - 1);
}

std::vector<SheetEdge> Sheets::ends(unsigned sheets, unsigned turned, bool in_columns) const {
  struct Use {
    SheetVertex high;
    int count;
  };
  const auto for_each_use = [&](const auto& visit) {
    for (const SheetFacet& facet : facets) {
      if ((bit(facet.sheet) & sheets) == 0) continue;
      const int sign = (bit(facet.sheet) & turned) != 0 ? -1 : 1;
      for (std::size_t k = 0; k < 3; ++k) {
        const SheetVertex from = facet.corners[k], to = facet.corners[(k + 1) % 3];
        if (in_columns && (column_of[from] == k_no_plane_point || column_of[to] == k_no_plane_point))
          continue;
        visit(std::min(from, to), Use{std::max(from, to), from < to ? sign : -sign});
      }
    }
  };
  // By the lower vertex; counted two places on, so that while uses are put in, first[low + 1] is where the
  // next goes.
  std::vector<std::uint32_t> first(vertices.size() + 2, 0);
  for_each_use([&](SheetVertex low, const Use&) { ++first[low + 2]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Use> uses(first.back());
  for_each_use([&](SheetVertex low, const Use& use) { uses[first[low + 1]++] = use; });
  std::vector<SheetEdge> found;
  for (SheetVertex low = 0; low < vertices.size(); ++low) {
    const std::span here(uses.data() + first[low], first[low + 1] - first[low]);
    std::ranges::sort(here, {}, &Use::high);
    for (std::size_t k = 0; k < here.size();) {
      const SheetVertex high = here[k].high;
      int count = 0;
      for (; k < here.size() && here[k].high == high; ++k) count += here[k].count;
      if (count > 0) found.push_back({low, high, count});
      if (count < 0) found.push_back({high, low, -count});
    }
  }
  return found;
}

std::vector<SegmentEdges> Sheets::by_segment(std::span<const SheetEdge> edges) const {
  struct Placed {
    std::uint64_t key;
    SegmentEdge edge;
  };
  std::vector<Placed> placed;
  placed.reserve(edges.size());
  for (const SheetEdge& edge : edges) {
    const PlanePoint from = column_of[edge.from], to = column_of[edge.to];
    if (from == to || from == k_no_plane_point || to == k_no_plane_point) continue;
    placed.push_back(from < to ? Placed{edge_key(from, to), {edge.from, edge.to, edge.count}}
                               : Placed{edge_key(from, to), {edge.to, edge.from, -edge.count}});
  }
  std::ranges::stable_sort(placed, {}, &Placed::key);
  std::vector<SegmentEdges> segments;
  for (const Placed& one : placed) {
    const auto a = static_cast<PlanePoint>(one.key >> 32U), b = static_cast<PlanePoint>(one.key);
    if (segments.empty() || segments.back().a != a || segments.back().b != b) segments.push_back({a, b, {}});
    segments.back().edges.push_back(one.edge);
  }
  return segments;
}

void Sheets::make_columns(double tolerance) {
  std::vector<SheetVertex> ends_at;
  for (const Sheet sheet : k_standing_sheets) {
    for (const SheetEdge& edge : ends(bit(sheet))) {
      ends_at.push_back(edge.from);
      ends_at.push_back(edge.to);
    }
  }
  std::ranges::sort(ends_at);
  ends_at.erase(std::unique(ends_at.begin(), ends_at.end()), ends_at.end());
  UnionFind joined(ends_at.size());
  std::vector<glm::dvec2> places;
  for (const SheetVertex vertex : ends_at) places.emplace_back(vertices[vertex]);
  const PlaneGrid grid(2.0 * tolerance, places);
  for (std::uint32_t k = 0; k < places.size(); ++k) {
    grid.for_each_near(places[k], [&](std::uint32_t other) {
      if (other < k && glm::distance(places[other], places[k]) <= tolerance) joined.join(k, other);
    });
  }
  std::vector<PlanePoint> column(ends_at.size(), k_no_plane_point);
  for (std::uint32_t k = 0; k < ends_at.size(); ++k) {
    const std::uint32_t root = joined.find(k);
    const SheetVertex vertex = ends_at[k];
    if (column[root] == k_no_plane_point) column[root] = add_column(glm::dvec2(vertices[ends_at[root]]));
    column_of[vertex] = column[root];
    moved[column[root]] =
        std::max(moved[column[root]], glm::distance(columns[column[root]], glm::dvec2(vertices[vertex])));
    vertices[vertex].x = columns[column[root]].x;
    vertices[vertex].y = columns[column[root]].y;
  }
}

std::optional<glm::dvec3> Sheets::insert_columns(double tolerance, Passing& passing) {
  std::array<std::vector<SheetEdge>, k_standing_sheets.size()> edges;
  for (std::size_t k = 0; k < edges.size(); ++k) edges[k] = ends(bit(k_standing_sheets[k]), 0, true);
  if (!passing.grid) {
    double length = 0.0;
    std::size_t count = 1;
    for (const std::vector<SheetEdge>& of_sheet : edges) {
      count += of_sheet.size();
      for (const SheetEdge& edge : of_sheet)
        length += glm::distance(glm::dvec2(vertices[edge.from]), glm::dvec2(vertices[edge.to]));
    }
    passing.grid.emplace(std::max({length / static_cast<double>(count), 4.0 * tolerance, 1e-4}), columns);
  }

  OnEdges on_edges;
  std::vector<std::pair<double, PlanePoint>> passed;
  std::vector<std::uint64_t> by_none;
  for (const std::vector<SheetEdge>& of_sheet : edges) {
    const auto before = static_cast<std::ptrdiff_t>(by_none.size());
    auto known = passing.by_none.begin();
    for (const SheetEdge& edge : of_sheet) {
      const SheetVertex low = std::min(edge.from, edge.to), high = std::max(edge.from, edge.to);
      const std::uint64_t key = edge_key(low, high);
      known = std::find_if(known, passing.by_none.end(), [&](std::uint64_t its) { return its >= key; });
      if (known != passing.by_none.end() && *known == key) {
        by_none.push_back(key);
        continue;
      }
      if (column_of[low] == column_of[high] || on_edges.contains(key)) continue;
      const glm::dvec2 a(vertices[low]), b(vertices[high]);
      const double squared = glm::dot(b - a, b - a);
      passed.clear();
      passing.grid->for_each_along(a, b, [&](PlanePoint column) {
        if (column == column_of[low] || column == column_of[high]) return;
        const double share = glm::dot(columns[column] - a, b - a) / squared;
        if (share <= 0.0 || share >= 1.0) return;
        if (glm::distance(a + share * (b - a), columns[column]) <= tolerance)
          passed.emplace_back(share, column);
      });
      if (passed.empty()) {
        by_none.push_back(key);
        continue;
      }
      std::ranges::sort(passed);
      std::vector<SheetVertex>& on_edge = on_edges[key];
      for (const auto& [share, column] : passed) {
        if (!on_edge.empty() && column_of[on_edge.back()] == column) continue;
        moved[column] = std::max(moved[column], glm::distance(a + share * (b - a), columns[column]));
        on_edge.push_back(add_vertex(column, glm::mix(vertices[low].z, vertices[high].z, share)));
      }
    }
    std::inplace_merge(by_none.begin(), by_none.begin() + before, by_none.end());
  }
  passing.by_none = std::move(by_none);
  if (on_edges.empty()) return std::nullopt;
  divide_edges(on_edges);
  return vertices.back();
}

void Sheets::divide(const SheetFacet& facet, const OnEdges& on_edges, std::vector<SheetFacet>& parts) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const SheetVertex a = facet.corners[k], b = facet.corners[(k + 1) % 3], tip = facet.corners[(k + 2) % 3];
    const auto found = on_edges.find(edge_key(a, b));
    if (found == on_edges.end()) continue;
    // Fans from the opposite corner; the first and the last have the facet's other edges.
    const std::vector<SheetVertex>& between = found->second;
    SheetVertex before = a;
    for (std::size_t i = 0; i <= between.size(); ++i) {
      const std::size_t place = a < b ? i : between.size() - 1 - i;
      const SheetVertex next = i == between.size() ? b : between[place];
      divide({{before, next, tip}, facet.sheet}, on_edges, parts);
      before = next;
    }
    return;
  }
  parts.push_back(facet);
}

void Sheets::divide_edges(const OnEdges& on_edges) {
  std::vector<char> has(vertices.size(), 0);  // an edge with vertices on it
  for (const auto& on_edge : on_edges) has[on_edge.first >> 32U] = has[on_edge.first & ~0U] = 1;
  std::vector<SheetFacet> divided;
  divided.reserve(facets.size() + 2 * on_edges.size());
  for (const SheetFacet& facet : facets) {
    const auto& [a, b, c] = facet.corners;
    if (has[a] + has[b] + has[c] >= 2)
      divide(facet, on_edges, divided);
    else
      divided.push_back(facet);
  }
  facets = std::move(divided);
}

void Sheets::weld_columns(double tolerance) {
  using Standing = std::tuple<PlanePoint, double, SheetVertex>;
  std::vector<Standing> standing;
  for (SheetVertex vertex = 0; vertex < vertices.size(); ++vertex) {
    if (column_of[vertex] != k_no_plane_point)
      standing.emplace_back(column_of[vertex], vertices[vertex].z, vertex);
  }
  std::ranges::sort(standing, std::less());
  std::vector<SheetVertex> becomes(vertices.size());
  std::iota(becomes.begin(), becomes.end(), 0U);
  SheetVertex kept = 0;
  for (std::size_t k = 0; k < standing.size(); ++k) {
    const SheetVertex vertex = std::get<2>(standing[k]);
    if (k > 0 && column_of[kept] == column_of[vertex] && vertices[vertex].z - vertices[kept].z <= tolerance) {
      becomes[vertex] = kept;
    } else {
      kept = vertex;
    }
  }
  std::erase_if(facets, [&](SheetFacet& facet) {
    for (SheetVertex& corner : facet.corners) corner = becomes[corner];
    const auto& [a, b, c] = facet.corners;
    return a == b || b == c || c == a;
  });
}

double Sheets::volume() const {
  long double sum = 0.0L;
  for (const SheetFacet& facet : facets) {
    if (facet.sheet == Sheet::parting) continue;
    const glm::dvec3 &a = vertices[facet.corners[0]], &b = vertices[facet.corners[1]],
                     &c = vertices[facet.corners[2]];
    const double seen = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    sum += static_cast<long double>((facet.sheet == Sheet::beside ? -seen : seen) * (a.z + b.z + c.z)) / 6.0L;
  }
  return static_cast<double>(sum);
}

void Sheets::keep_volume(double assigned, double most) {
  const double lacking = assigned - volume();
  if (lacking == 0.0 || std::abs(lacking) > most) return;
  // How the volume changes with a column's place; upright surface adds nothing to it.
  std::vector<glm::dvec2> gradient(columns.size(), glm::dvec2(0.0));
  for (const SheetFacet& facet : facets) {
    if (facet.sheet == Sheet::parting) continue;
    double height = 0.0;
    for (const SheetVertex v : facet.corners) height += vertices[v].z / 6.0;
    if (facet.sheet == Sheet::beside) height = -height;
    for (std::size_t k = 0; k < 3; ++k) {
      const PlanePoint column = column_of[facet.corners[k]];
      if (column == k_no_plane_point) continue;
      const glm::dvec3 along = vertices[facet.corners[(k + 2) % 3]] - vertices[facet.corners[(k + 1) % 3]];
      gradient[column] += height * glm::dvec2(-along.y, along.x);
    }
  }
  double reach = 0.0;
  for (PlanePoint column = 0; column < columns.size(); ++column)
    reach += moved[column] * glm::length(gradient[column]);
  if (reach <= 0.0) return;
  const double share = std::clamp(lacking / reach, -0.5, 0.5);
  for (PlanePoint column = 0; column < columns.size(); ++column) {
    const double steep = glm::length(gradient[column]);
    if (moved[column] > 0.0 && steep > 0.0)
      columns[column] = on_grid(columns[column] + share * moved[column] / steep * gradient[column]);
  }
  for (SheetVertex vertex = 0; vertex < vertices.size(); ++vertex) {
    if (column_of[vertex] == k_no_plane_point) continue;
    vertices[vertex].x = columns[column_of[vertex]].x;
    vertices[vertex].y = columns[column_of[vertex]].y;
  }
}

std::optional<glm::dvec3> Sheets::align_ends(double tolerance) {
  make_columns(tolerance);
  weld_columns(tolerance);
  std::optional<glm::dvec3> place;
  Passing passing;
  for (int round = 0; round < k_most_sheet_rounds; ++round) {
    place = insert_columns(tolerance, passing);
    weld_columns(tolerance);
    if (!place) break;
  }
  return place;
}

std::optional<glm::dvec3> most_moved(const Sheets& sheets) {
  std::optional<glm::dvec3> place;
  double most = -1.0;
  for (SheetVertex v = 0; v < sheets.vertices.size(); ++v) {
    const PlanePoint column = sheets.column_of[v];
    if (column == k_no_plane_point || sheets.moved[column] <= most) continue;
    most = sheets.moved[column];
    place = sheets.vertices[v];
  }
  return place;
}

Bounds box_of(const Sheets& sheets) {
  Bounds box;
  for (const SheetFacet& facet : sheets.facets) {
    for (const SheetVertex v : facet.corners) box.add(sheets.vertices[v]);
  }
  return box;
}

}  // namespace moldlight
