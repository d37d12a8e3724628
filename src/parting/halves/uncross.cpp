#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/facet_geometry.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/exact/facet_encounters.hpp"
#include "parting/halves/tidy_solid.hpp"

namespace moldlight {

namespace {

constexpr int k_most_uncross_rounds = 3;
/// More are no matter of rounding, and to look at each takes long.
constexpr std::size_t k_most_crossed = 4096;
constexpr std::size_t k_most_near = 512;         // facets about a vertex
constexpr FacetIndex k_group = 64;               // of facets with a box around all
constexpr std::size_t k_most_looks = 5'000'000;  // at pairs of facets, in all

/// Of these facets of a mesh those that cross another of them.
std::vector<FacetIndex> crossed_among(const TriangleMesh& mesh, std::span<const FacetIndex> among,
                                      const Progress& progress) {
  const UnitFrame frame = unit_frame(bounds(mesh));
  std::vector<glm::dvec3> positions;
  positions.reserve(mesh.vertices.size());
  for (const glm::dvec3& vertex : mesh.vertices)
    positions.push_back((vertex - frame.center) / frame.diagonal);
  TriangleMesh some{.vertices = mesh.vertices, .facets = {}};
  some.facets.reserve(among.size());
  for (const FacetIndex facet : among) some.facets.push_back(mesh.facets[facet]);
  const FacetEncounters met =
      facet_encounters(some, positions, facet_geometry(some).normals, {}, k_any_crossings, progress);
  std::vector<FacetIndex> crossed;
  for (FacetIndex k = 0; k < among.size(); ++k) {
    if (!met.crossings.of(k).empty()) crossed.push_back(among[k]);
  }
  return crossed;
}

class Uncrosser {
 public:
  Uncrosser(TriangleMesh& mesh, const TidyQuery& query)
      : mesh_(mesh),
        query_(query),
        box_(bounds(mesh)),
        frame_(unit_frame(box_)),
        around_(mesh.vertices.size()),
        boxes_(mesh.facets.size()),
        groups_(mesh.facets.size() / k_group + 1) {
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      for (const VertexIndex corner : mesh.facets[facet]) around_[corner].push_back(facet);
      set_box(facet);
    }
    for (const glm::dvec3& vertex : mesh.vertices) positions_.push_back(in_frame(vertex));
  }

  /// Tries each corner of these facets.
  void mend(std::span<const FacetIndex> crossed, const Progress& progress) {
    for (const FacetIndex facet : crossed) {
      progress.report("making the halves", 0.9);
      for (const VertexIndex corner : mesh_.facets[facet]) {
        if (!on_block(corner)) mend_at(corner);
      }
    }
  }

  /// Those that cross others once some are mended, of which these did before.
  [[nodiscard]] std::vector<FacetIndex> still_crossed(std::vector<FacetIndex> crossed,
                                                      const Progress& progress) {
    crossed.insert(crossed.end(), changed_.begin(), changed_.end());
    changed_.clear();
    std::vector<FacetIndex> among;
    for (const FacetIndex facet : crossed) {
      const std::vector<FacetIndex> near = near_facets(boxes_[facet]);
      among.insert(among.end(), near.begin(), near.end());
    }
    std::ranges::sort(among);
    among.erase(std::unique(among.begin(), among.end()), among.end());
    return crossed_among(mesh_, among, progress);
  }

 private:
  [[nodiscard]] glm::dvec3 in_frame(const glm::dvec3& vertex) const {
    return (vertex - frame_.center) / frame_.diagonal;
  }
  [[nodiscard]] bool on_block(VertexIndex vertex) const {
    if (query_.pull == glm::dvec3(0.0)) return false;  // no half
    const glm::dvec3& at = mesh_.vertices[vertex];
    return glm::any(glm::equal(at, box_.min)) || glm::any(glm::equal(at, box_.max));
  }
  void move(VertexIndex vertex, const glm::dvec3& to) {
    mesh_.vertices[vertex] = to;
    positions_[vertex] = in_frame(to);
  }

  /// What the facets around a vertex have against the pull, each as long as twice its area.
  struct Against {
    double seen = 0.0, leaning = 0.0;
    bool degenerate = false;
  };
  [[nodiscard]] Against against(VertexIndex vertex) const {
    Against sum;
    for (const FacetIndex facet : around_[vertex]) {
      const glm::dvec3 normal = twice_area_vector(mesh_, facet);
      const double size = glm::length(normal), along = glm::dot(normal, query_.pull);
      sum.seen += std::max(0.0, along);
      if (along > k_leaning_sine * size) sum.leaning += size;
      sum.degenerate = sum.degenerate || size == 0.0;
    }
    return sum;
  }

  /// Crossings among facets.
  [[nodiscard]] std::size_t crossings(const std::vector<FacetIndex>& among) const {
    TriangleMesh some;
    std::vector<glm::dvec3> normals;
    for (const FacetIndex facet : among) {
      some.facets.push_back(mesh_.facets[facet]);
      const glm::dvec3 normal = twice_area_vector(mesh_, facet);
      const double size = glm::length(normal);
      normals.push_back(size > 0.0 ? normal / size : glm::dvec3(0.0));
    }
    return facet_encounters(some, positions_, normals, {}, k_any_crossings, Progress())
        .crossings.items.size();
  }

  [[nodiscard]] Bounds box_of_facet(FacetIndex facet) const {
    Bounds box;
    for (int k = 0; k < 3; ++k) box.add(mesh_.corner(facet, k));
    return box;
  }

  [[nodiscard]] static bool overlap(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::greaterThanEqual(a.max, b.min));
  }

  [[nodiscard]] std::vector<FacetIndex> near_facets(const Bounds& reach) const {
    std::vector<FacetIndex> near;
    for (FacetIndex first = 0; first < boxes_.size(); first += k_group) {
      if (!overlap(groups_[first / k_group].widened(query_.tolerance), reach)) continue;
      for (FacetIndex facet = first; facet < std::min<std::size_t>(first + k_group, boxes_.size()); ++facet)
        if (overlap(boxes_[facet].widened(query_.tolerance), reach)) near.push_back(facet);
    }
    return near;
  }

  void set_box(FacetIndex facet) {
    boxes_[facet] = box_of_facet(facet);
    groups_[facet / k_group].add(boxes_[facet].min);
    groups_[facet / k_group].add(boxes_[facet].max);
  }

  void mend_at(VertexIndex vertex) {
    Bounds reach;
    for (const FacetIndex facet : around_[vertex]) {
      for (int k = 0; k < 3; ++k) reach.add(mesh_.corner(facet, k));
    }
    const std::vector<FacetIndex> near = near_facets(reach);
    if (near.size() > k_most_near || looks_ > k_most_looks) return;
    const std::size_t pairs = near.size() * near.size(), before = crossings(near);
    looks_ += pairs;
    if (before == 0) return;
    // What its move does not change: crossings among those that stay apart from the facets around it.
    std::vector<FacetIndex> touched;
    std::ranges::copy_if(near, std::back_inserter(touched), [&](FacetIndex facet) {
      return std::ranges::any_of(around_[vertex], [&](FacetIndex own) {
        return overlap(boxes_[facet].widened(2.0 * query_.tolerance), boxes_[own]);
      });
    });
    const std::size_t elsewhere = before - crossings(touched);
    const Against had = against(vertex);
    const glm::dvec3 from = mesh_.vertices[vertex];
    glm::dvec3 best = from;
    std::size_t least = before;
    for (const glm::dvec3& step : steps()) {
      const glm::dvec3 to(glm::vec3(from + step));
      if (to == from) continue;
      move(vertex, to);
      const Against has = against(vertex);
      if (has.seen > had.seen || has.leaning > had.leaning || (has.degenerate && !had.degenerate)) continue;
      looks_ += pairs;
      if (const std::size_t count = elsewhere + crossings(touched); count < least) {
        least = count;
        best = to;
        if (count == 0) break;
      }
    }
    move(vertex, best);
    if (best == from) return;
    for (const FacetIndex facet : around_[vertex]) {
      set_box(facet);
      changed_.push_back(facet);
    }
  }

  /// Those along the pull first.
  [[nodiscard]] std::vector<glm::dvec3> steps() const {
    std::vector<glm::dvec3> list;
    for (const double length : {0.5 * query_.tolerance, query_.tolerance}) {
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = -1; z <= 1; ++z)
            if (x != 0 || y != 0 || z != 0) list.push_back(length * glm::dvec3(x, y, z));
    }
    std::ranges::stable_sort(list, {}, [&](const glm::dvec3& step) {
      const double along = glm::dot(step, query_.pull);
      return glm::dot(step, step) - along * along;  // beside the pull
    });
    return list;
  }

  TriangleMesh& mesh_;
  const TidyQuery& query_;
  Bounds box_;
  UnitFrame frame_;
  std::vector<glm::dvec3> positions_;
  std::size_t looks_ = 0;
  std::vector<std::vector<FacetIndex>> around_;  // each vertex
  std::vector<Bounds> boxes_;                    // of the facets
  std::vector<Bounds> groups_;                   // around so many of them at least
  std::vector<FacetIndex> changed_;              // since they were last looked at
};

}  // namespace

std::vector<FacetIndex> uncross(TriangleMesh& mesh, const TidyQuery& query, std::vector<FacetIndex> crossed,
                                const Progress& progress) {
  if (crossed.empty() || crossed.size() > k_most_crossed) return crossed;
  Uncrosser uncrosser(mesh, query);
  for (int round = 0; round < k_most_uncross_rounds && !crossed.empty(); ++round) {
    uncrosser.mend(crossed, progress);
    std::vector<FacetIndex> left = uncrosser.still_crossed(crossed, progress);
    const bool better = left.size() < crossed.size();
    crossed = std::move(left);
    if (!better) break;
  }
  return crossed;
}

GraphTest graph_test(const std::vector<glm::dvec3>& vertices,
                     const std::vector<std::array<SheetVertex, 3>>& facets, double sign) {
  GraphTest test;
  for (const auto& [i, j, k] : facets) {
    const glm::dvec3 &a = vertices[i], &b = vertices[j], &c = vertices[k];
    const double seen = 0.5 * sign * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    (seen < 0.0 ? test.folded : test.covered) += std::abs(seen);
    if (-seen <= test.most) continue;
    test.most = -seen;
    test.place = (a + b + c) / 3.0;
  }
  return test;
}

Needles find_needles(const TriangleMesh& mesh, double thinnest) {
  Needles needles;
  double most = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, glm::distance(mesh.corner(facet, k), mesh.corner(facet, (k + 1) % 3)));
    const double twice_area = glm::length(twice_area_vector(mesh, facet));
    if (twice_area >= thinnest * longest) continue;
    ++needles.count;
    if (longest <= most) continue;
    most = longest;
    needles.place = mesh.corner(facet, 0);
  }
  return needles;
}

std::vector<FacetIndex> crossed_facets(const TriangleMesh& mesh, const Progress& progress) {
  std::vector<FacetIndex> all(mesh.facets.size());
  std::iota(all.begin(), all.end(), FacetIndex{0});
  return crossed_among(mesh, all, progress);
}

}  // namespace moldlight
