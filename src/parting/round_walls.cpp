#include "parting/round_walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/union_find.hpp"
#include "parting/halves/assigned_walls.hpp"

namespace moldlight {

namespace {

/// Facets of a round wall lean by less than the first, as a sine, those that stand by less than the second.
constexpr double k_most_of_round = 0.09, k_stands = 2e-4;
/// Of a round wall's area at least so much stands, or leans as much to one side as to the other.
constexpr double k_least_upright = 0.5;
constexpr double k_smooth = 0.87;  // cosine of the bend
/// A corner is off the chord beside it by at most so much of how far it is from the nearer end.
constexpr double k_steepest = 0.25;
constexpr double k_same_curve = 0.5;    // how much the curve of walls in line may differ from each other's
constexpr double k_wide_cell = 8.0;     // reaches
constexpr double k_one_column = 1e-4;   // corners closer than this, in diagonals, are one
constexpr double k_least_lean = 1e-10;  // a facet stands that is no wider as seen along the direction
constexpr int k_most_divided = 32;      // times

class WallDivider {
 public:
  WallDivider(const TriangleMesh& mesh, const SheetFrame& frame, double reach, const Progress& progress)
      : mesh_(mesh),
        frame_(frame),
        reach_(reach),
        progress_(progress),
        adjacency_(build_adjacency(mesh)),
        in_wall_(mesh.facets.size(), Membership::none),
        column_of_(mesh.vertices.size()) {
    for (const glm::dvec3& vertex : mesh.vertices) own_.push_back(frame.in_mold(vertex));
    at_ = own_;
  }

  std::optional<UprightPart> run() {
    find_walls();
    for (int round = 0; round < k_most_divided; ++round) {
      join_columns();
      divide_edges();
      if (columns_.empty()) break;
      if (auto part = divided()) return part;
    }
    return std::nullopt;
  }

 private:
  using Ends = std::pair<VertexIndex, VertexIndex>;  // of an edge, the lower one first
  static Ends edge(VertexIndex a, VertexIndex b) { return {std::min(a, b), std::max(a, b)}; }

  enum class Membership : std::uint8_t { none, member, waiting };  // to be divided

  struct Wall {
    double stands = 0.0, up = 0.0, down = 0.0;  // twice the areas
  };

  [[nodiscard]] glm::dvec2 seen(VertexIndex vertex) const { return glm::dvec2(at_[vertex]); }
  [[nodiscard]] glm::dvec3 twice_area(FacetIndex facet) const {
    const auto& [a, b, c] = mesh_.facets[facet];
    return glm::cross(at_[b] - at_[a], at_[c] - at_[a]);
  }
  /// How far along the chord from a to b something is seen, as a share of it.
  [[nodiscard]] double share(VertexIndex a, VertexIndex b, VertexIndex at) const {
    const glm::dvec2 chord = seen(b) - seen(a);
    return glm::dot(seen(at) - seen(a), chord) / glm::dot(chord, chord);
  }
  [[nodiscard]] double off(VertexIndex a, VertexIndex b, VertexIndex at) const {
    return glm::distance(seen(at), glm::mix(seen(a), seen(b), share(a, b, at)));
  }
  [[nodiscard]] bool is_beside(VertexIndex a, VertexIndex b, VertexIndex at, double slack) const {
    const double along = share(a, b, at);
    return off(a, b, at) <=
           slack * k_steepest * std::min(along, 1.0 - along) * glm::distance(seen(a), seen(b));
  }

  /// Corners of a facet as seen along the direction: ends of its longest side, and the one between.
  [[nodiscard]] std::array<VertexIndex, 3> along(FacetIndex facet) const {
    std::array<VertexIndex, 3> c = mesh_.facets[facet];
    const auto length = [&](std::size_t k) { return glm::distance(seen(c[k]), seen(c[(k + 1) % 3])); };
    const std::ptrdiff_t longest = length(0) >= std::max(length(1), length(2)) ? 0
                                   : length(1) >= length(2)                    ? 1
                                                                               : 2;
    std::rotate(c.begin(), c.begin() + longest, c.end());
    return c;
  }

  [[nodiscard]] bool may_be_round(FacetIndex facet, const glm::dvec3& normal) const {
    if (normal == glm::dvec3(0.0) || std::abs(normal.z) > k_most_of_round) return false;
    const auto [a, b, c] = along(facet);
    return seen(a) != seen(b) && off(a, b, c) <= reach_;
  }

  /// Smooth surface that leans little and, for the most part, not at all or as much to either side.
  void find_walls() {
    const auto count = static_cast<FacetIndex>(mesh_.facets.size());
    std::vector<glm::dvec3> normals(count, glm::dvec3(0.0));
    std::vector<char> round(count, 0);
    for (FacetIndex facet = 0; facet < count; ++facet) {
      const glm::dvec3 area = twice_area(facet);
      if (glm::length(area) > 0.0) normals[facet] = glm::normalize(area);
      round[facet] = may_be_round(facet, normals[facet]) ? 1 : 0;
    }
    const auto is_smooth = [&](FacetIndex facet, FacetIndex beside) {
      return beside != k_no_facet && glm::dot(normals[facet], normals[beside]) > k_smooth;
    };
    UnionFind walls(count);
    for (FacetIndex facet = 0; facet < count; ++facet) {
      for (const FacetIndex beside : adjacency_.across[facet]) {
        if (round[facet] != 0 && is_smooth(facet, beside) && round[beside] != 0) walls.join(facet, beside);
      }
    }
    std::map<FacetIndex, Wall> found;
    for (FacetIndex facet = 0; facet < count; ++facet) {
      if (round[facet] == 0) continue;
      Wall& wall = found[walls.find(facet)];
      const double lean = normals[facet].z;
      (std::abs(lean) < k_stands ? wall.stands
       : lean > 0.0              ? wall.up
                                 : wall.down) += glm::length(twice_area(facet));
    }
    for (FacetIndex facet = 0; facet < count; ++facet) {
      if (round[facet] == 0) continue;
      const Wall& wall = found[walls.find(facet)];
      const double all = wall.stands + wall.up + wall.down;
      if (wall.stands + 2.0 * std::min(wall.up, wall.down) >= k_least_upright * all)
        in_wall_[facet] = Membership::member;
    }
  }

  using Cell = std::array<std::int64_t, 2>;
  static Cell cell_of(const glm::dvec2& at, double size) {
    const glm::dvec2 cell = glm::floor(at / size);
    return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y)};
  }

  /// Corners of walls that are the same as seen along the direction stand where the first does.
  void join_columns() {
    at_ = own_;
    UnionFind joined(at_.size());
    std::vector<char> in_wall(at_.size(), 0);
    for (FacetIndex facet = 0; facet < in_wall_.size(); ++facet) {
      if (in_wall_[facet] == Membership::none) continue;
      for (const VertexIndex corner : mesh_.facets[facet]) in_wall[corner] = 1;
    }
    // Places that were met, in cells; many corners stand above each other.
    std::map<Cell, std::vector<VertexIndex>> met;
    for (VertexIndex v = 0; v < at_.size(); ++v) {
      if (in_wall[v] == 0) continue;
      const Cell own = cell_of(seen(v), k_one_column);
      bool known = false;
      for (int beside = 0; beside < 9; ++beside) {
        const auto there = met.find({own[0] + beside % 3 - 1, own[1] + beside / 3 - 1});
        if (there == met.end()) continue;
        for (const VertexIndex other : there->second) {
          known = known || seen(other) == seen(v);
          if (glm::distance(seen(other), seen(v)) < k_one_column) joined.join(other, v);
        }
      }
      if (!known) met[own].push_back(v);
    }
    for (VertexIndex v = 0; v < at_.size(); ++v) column_of_[v] = joined.find(v);
    for (VertexIndex v = 0; v < at_.size(); ++v) at_[v] = glm::dvec3(seen(column_of_[v]), at_[v].z);
  }

  /// Facets that lean are divided at their corner between, as is what stands above and below in their wall.
  /// Facets where that does not go are no part of it.
  void divide_edges() {
    columns_.clear();
    std::vector<FacetIndex> next;
    for (FacetIndex facet = 0; facet < in_wall_.size(); ++facet) {
      if (in_wall_[facet] == Membership::none) continue;
      const auto [a, b, c] = along(facet);
      if (column_of_[c] == column_of_[a] || column_of_[c] == column_of_[b]) continue;
      if (off(a, b, c) > k_least_lean && is_beside(a, b, c, 1.0)) {
        in_wall_[facet] = Membership::waiting;
        next.push_back(facet);
      }
    }
    in_line_.clear();
    find_in_line(next);
    while (!next.empty()) {
      progress_.report(k_halves_stage, 0.0);
      const FacetIndex facet = next.back();
      next.pop_back();
      in_wall_[facet] = Membership::member;
      if (!divide(facet, next)) in_wall_[facet] = Membership::none;
    }
  }

  [[nodiscard]] glm::dvec2 facing(FacetIndex facet) const {
    return glm::normalize(glm::dvec2(twice_area(facet)));
  }

  /// Which way the walls face at each of their columns.
  [[nodiscard]] std::map<VertexIndex, glm::dvec2> column_normals() const {
    std::map<VertexIndex, glm::dvec2> normals;
    for (FacetIndex facet = 0; facet < in_wall_.size(); ++facet) {
      if (in_wall_[facet] == Membership::none) continue;
      const std::array<VertexIndex, 3> corners = along(facet);
      for (const VertexIndex corner : corners)
        normals[column_of_[corner]] += facing(facet) / glm::distance(seen(corners[0]), seen(corners[1]));
    }
    for (auto& [column, normal] : normals) {
      if (normal != glm::dvec2(0.0)) normal = glm::normalize(normal);
    }
    return normals;
  }

  /// Walls that go on behind a gap, a branch or a hole, are divided there as before it: columns of one that
  /// are on the curve of the other. Adds facets to `next`.
  void find_in_line(std::vector<FacetIndex>& next) {
    if (reach_ <= 0.0) return;
    const double wide = k_wide_cell * reach_;
    const std::map<VertexIndex, glm::dvec2> normals = column_normals();
    std::map<Cell, std::vector<VertexIndex>> in_cell;
    for (const auto& [column, normal] : normals) in_cell[cell_of(seen(column), wide)].push_back(column);
    for (FacetIndex facet = 0; facet < in_wall_.size(); ++facet) {
      if (in_wall_[facet] == Membership::none) continue;
      const std::array<VertexIndex, 3> ends = along(facet);
      const double bend = std::acos(
          std::clamp(glm::dot(normals.at(column_of_[ends[0]]), normals.at(column_of_[ends[1]])), -1.0, 1.0));
      const auto low = cell_of(glm::min(seen(ends[0]), seen(ends[1])) - reach_, wide),
                 high = cell_of(glm::max(seen(ends[0]), seen(ends[1])) + reach_, wide);
      std::vector<VertexIndex> found;
      for (std::int64_t x = low[0]; x <= high[0]; ++x) {
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
          const auto here = in_cell.find({x, y});
          if (here == in_cell.end()) continue;
          std::ranges::copy_if(here->second, std::back_inserter(found), [&](VertexIndex column) {
            return glm::dot(normals.at(column), facing(facet)) > k_smooth && is_in_line(ends, bend, column);
          });
        }
      }
      if (found.empty()) continue;
      in_line_[facet] = std::move(found);
      if (in_wall_[facet] != Membership::waiting) next.push_back(facet);
      in_wall_[facet] = Membership::waiting;
    }
  }
  /// Whether a column that is none of its own is on the curve of a facet, whose ends face ways that differ by
  /// `bend`, radians.
  [[nodiscard]] bool is_in_line(const std::array<VertexIndex, 3>& ends, double bend,
                                VertexIndex column) const {
    const auto is_column = [&](VertexIndex corner) { return column_of_[corner] == column; };
    if (std::ranges::any_of(ends, is_column)) return false;
    const double its = share(ends[0], ends[1], column);
    if (its <= 0.0 || its >= 1.0 || !is_beside(ends[0], ends[1], column, 1.0)) return false;
    const double curve = 0.5 * glm::distance(seen(ends[0]), seen(ends[1])) * bend * its * (1.0 - its);
    const double beside = off(ends[0], ends[1], column);
    return beside <= reach_ && std::abs(beside - curve) <= k_same_curve * curve;
  }

  /// Divides a facet's sides at all columns that one of them is divided at, and at the corner between; adds
  /// the wall's facets across to `next`. False where a column is not beside a side.
  bool divide(FacetIndex facet, std::vector<FacetIndex>& next) {
    const auto [a, b, c] = along(facet);
    const double between = share(a, b, c);
    std::vector<VertexIndex> wanted = {column_of_[c]};
    if (const auto known = in_line_.find(facet); known != in_line_.end())
      wanted.insert(wanted.end(), known->second.begin(), known->second.end());
    for (const Ends& side : {edge(a, b), edge(a, c), edge(c, b)}) {
      if (const auto known = columns_.find(side); known != columns_.end())
        wanted.insert(wanted.end(), known->second.begin(), known->second.end());
    }
    std::ranges::sort(wanted);
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    const auto add = [&](VertexIndex from, VertexIndex to, VertexIndex column) {
      const auto known = columns_.find(edge(from, to));
      if (known != columns_.end() && std::ranges::binary_search(known->second, column)) return true;
      if (off(from, to, column) > 2.0 * reach_ || !is_beside(from, to, column, 2.0)) return false;
      std::vector<VertexIndex>& all = columns_[edge(from, to)];
      all.insert(std::ranges::lower_bound(all, column), column);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& corners = mesh_.facets[facet];
        const FacetIndex beside = adjacency_.across[facet][k];
        if (edge(corners[k], corners[(k + 1) % 3]) != edge(from, to) || beside == k_no_facet ||
            in_wall_[beside] != Membership::member)
          continue;
        in_wall_[beside] = Membership::waiting;
        next.push_back(beside);
      }
      return true;
    };
    for (const VertexIndex column : wanted) {
      if (column == column_of_[a] || column == column_of_[b]) continue;
      if (!add(a, b, column)) return false;
      if (column == column_of_[c]) continue;
      const bool first = share(a, b, column) < between;
      if (!add(first ? a : c, first ? c : b, column)) return false;
    }
    return true;
  }

  /// The corners of a facet with the points that divide its sides, the way around it.
  [[nodiscard]] std::vector<VertexIndex> outline(
      FacetIndex facet, const std::map<Ends, std::vector<VertexIndex>>& points) const {
    std::vector<VertexIndex> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexIndex from = mesh_.facets[facet][k], to = mesh_.facets[facet][(k + 1) % 3];
      corners.push_back(from);
      const auto known = points.find(edge(from, to));
      if (known == points.end()) continue;
      if (from < to) {
        corners.insert(corners.end(), known->second.begin(), known->second.end());
      } else {
        corners.insert(corners.end(), known->second.rbegin(), known->second.rend());
      }
    }
    return corners;
  }

  /// The part with its facets divided. Nothing where facets beside a wall would turn over: what is beside
  /// them is no longer part of it.
  std::optional<UprightPart> divided() {
    std::vector<glm::dvec3> at = at_;
    std::map<Ends, std::vector<VertexIndex>> points;
    for (auto& [ends, columns] : columns_) {
      const VertexIndex low = ends.first, high = ends.second;
      const auto along = [this, low, high](VertexIndex column) { return share(low, high, column); };
      std::ranges::sort(columns, {}, along);
      for (const VertexIndex column : columns) {
        points[ends].push_back(static_cast<VertexIndex>(at.size()));
        at.emplace_back(seen(column), glm::mix(at_[low].z, at_[high].z, along(column)));
      }
    }
    UprightPart part;
    bool any_turned = false;
    for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
      const std::vector<VertexIndex> corners = outline(facet, points);
      const std::size_t first = part.mesh.facets.size();
      bool turned = false;
      if (corners.size() == 3) {
        part.mesh.facets.push_back(mesh_.facets[facet]);
      } else if (in_wall_[facet] != Membership::none) {
        add_strips(facet, corners, at, part.mesh.facets);
      } else {
        turned = !add_fan(facet, corners, at, part.mesh.facets);
      }
      for (const FacetIndex beside : adjacency_.across[facet]) {
        if (turned && beside != k_no_facet) in_wall_[beside] = Membership::none;
      }
      any_turned = any_turned || turned;
      part.facet_of.insert(part.facet_of.end(), part.mesh.facets.size() - first, facet);
    }
    if (any_turned) return std::nullopt;
    part.mesh.vertices = mesh_.vertices;
    for (VertexIndex v = 0; v < at.size(); ++v) {
      if (v >= mesh_.vertices.size())
        part.mesh.vertices.push_back(frame_.in_part(at[v]));
      else if (column_of_[v] != v)
        part.mesh.vertices[v] = frame_.in_part(at[v]);
    }
    return part;
  }

  /// Facets around the corner that no divided side meets, else around a point in the middle, else around any
  /// point of the outline. False where each way one of them faces the other way.
  [[nodiscard]] bool add_fan(FacetIndex facet, const std::vector<VertexIndex>& corners,
                             std::vector<glm::dvec3>& at,
                             std::vector<std::array<VertexIndex, 3>>& facets) const {
    const auto& own = mesh_.facets[facet];
    const glm::dvec3 normal = twice_area(facet);
    std::size_t tip = corners.size();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto place = static_cast<std::size_t>(std::ranges::find(corners, own[k]) - corners.begin());
      const auto next = [&](std::size_t of) { return corners[(place + of) % corners.size()]; };
      if (next(1) == own[(k + 1) % 3] && next(corners.size() - 1) == own[(k + 2) % 3]) tip = place;
    }
    const auto goes_around = [&](VertexIndex middle) {
      const std::size_t first = facets.size();
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const VertexIndex from = corners[k], to = corners[(k + 1) % corners.size()];
        if (from == middle || to == middle) continue;
        facets.push_back({from, to, middle});
        if (glm::dot(glm::cross(at[to] - at[from], at[middle] - at[from]), normal) >= 0.0) continue;
        facets.resize(first);
        return false;
      }
      return true;
    };
    if (tip < corners.size() && goes_around(corners[tip])) return true;
    at.push_back((at_[own[0]] + at_[own[1]] + at_[own[2]]) / 3.0);
    if (goes_around(static_cast<VertexIndex>(at.size() - 1))) return true;
    at.pop_back();
    return std::ranges::any_of(corners, goes_around);
  }

  /// Facets between two columns each; corners that come together along the way are of one column.
  void add_strips(FacetIndex facet, const std::vector<VertexIndex>& corners,
                  const std::vector<glm::dvec3>& at, std::vector<std::array<VertexIndex, 3>>& facets) const {
    const auto [a, b, c] = along(facet);
    std::vector<double> places;  // of corners, along the facet
    const glm::dvec2 chord = seen(b) - seen(a);
    for (const VertexIndex corner : corners)
      places.push_back(glm::dot(chord, glm::dvec2(at[corner]) - seen(a)));
    const auto count = corners.size();
    const auto low = static_cast<std::size_t>(std::ranges::min_element(places) - places.begin()),
               high = static_cast<std::size_t>(std::ranges::max_element(places) - places.begin());
    std::size_t forward = low, back = low;
    while (forward != high || back != high) {
      const std::size_t on = (forward + 1) % count, behind = (back + count - 1) % count;
      const bool goes_on = back == high || (forward != high && places[on] <= places[behind]);
      if (forward != back) {
        if (goes_on && on != back) facets.push_back({corners[forward], corners[on], corners[back]});
        if (!goes_on && behind != forward)
          facets.push_back({corners[forward], corners[behind], corners[back]});
      }
      (goes_on ? forward : back) = goes_on ? on : behind;
    }
  }

  const TriangleMesh& mesh_;
  const SheetFrame& frame_;
  double reach_;
  const Progress& progress_;
  Adjacency adjacency_;
  std::vector<glm::dvec3> own_, at_;  // in the mold's frame: as they come, and in their columns
  std::vector<Membership> in_wall_;   // of a facet in a round wall
  std::map<FacetIndex, std::vector<VertexIndex>> in_line_;  // columns of others in line with it
  std::vector<VertexIndex> column_of_;  // the first vertex at the same place as seen along the direction
  std::map<Ends, std::vector<VertexIndex>> columns_;  // at which edges are divided
};

}  // namespace

std::optional<UprightPart> with_divided_walls(const TriangleMesh& mesh, const SheetFrame& frame, double reach,
                                              const Progress& progress) {
  return WallDivider(mesh, frame, reach, progress).run();
}

}  // namespace moldlight
