#include "mesh/flat_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/convex_polygon.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

constexpr std::uint32_t k_unset = std::numeric_limits<std::uint32_t>::max();

class FaceFinder {
 public:
  FaceFinder(const TriangleMesh& mesh, double tolerance)
      : mesh_(mesh), tolerance_(tolerance), twins_(3 * mesh.facets.size(), k_unset) {
    EdgeTable(mesh).for_each_edge([&](VertexIndex, std::span<const EdgeUse> uses) {
      if (uses.size() != 2 ||
          start_vertex(mesh_, uses[0].half_edge) == start_vertex(mesh_, uses[1].half_edge))
        return;
      twins_[uses[0].half_edge] = uses[1].half_edge;
      twins_[uses[1].half_edge] = uses[0].half_edge;
    });
  }

  FlatFaces find() {
    measure();
    grow_faces();
    join_needles();
    number_faces();
    find_chains();
    // A face has three edges at least, even where two of its sides are one line within the tolerance.
    do {
      lay_edges();
    } while (!walk_loops());
    find_shells();
    return std::move(found_);
  }

 private:
  /// Edges of the mesh between two faces, from a corner of the faces to the next, or around.
  struct Chain {
    std::vector<HalfEdgeIndex> walk;
    bool whole = false;  // each of its vertices is a corner
  };
  /// Of an edge of the mesh: the face's edge that it is a piece of.
  struct Piece {
    std::uint32_t edge = k_unset, chain = k_unset;
    bool first = false;      // along the chain
    bool backwards = false;  // the half-edge runs against it
  };

  static HalfEdgeIndex next_in_facet(HalfEdgeIndex half_edge) {
    return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
  }
  std::uint32_t face_at(HalfEdgeIndex half_edge) const { return face_of_[facet_of(half_edge)]; }
  bool on_border(HalfEdgeIndex half_edge) const {
    return twins_[half_edge] == k_unset || face_at(twins_[half_edge]) != face_at(half_edge);
  }
  /// The next one of the same face's border.
  HalfEdgeIndex next_on_border(HalfEdgeIndex half_edge) const {
    half_edge = next_in_facet(half_edge);
    while (!on_border(half_edge)) half_edge = next_in_facet(twins_[half_edge]);
    return half_edge;
  }
  const glm::dvec3& start(HalfEdgeIndex half_edge) const {
    return mesh_.vertices[start_vertex(mesh_, half_edge)];
  }
  const glm::dvec3& end(HalfEdgeIndex half_edge) const {
    return mesh_.vertices[end_vertex(mesh_, half_edge)];
  }

  void measure() {
    for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
      const glm::dvec3 twice = twice_area_vector(mesh_, facet);
      HalfEdgeIndex longest = 3 * facet;
      for (HalfEdgeIndex h = 3 * facet; h < 3 * facet + 3; ++h) {
        if (glm::distance(start(h), end(h)) > glm::distance(start(longest), end(longest))) longest = h;
      }
      const double length = glm::distance(start(longest), end(longest));
      thin_.push_back(glm::length(twice) <= tolerance_ * length ? 1 : 0);
      longest_.push_back(longest);
      area_.push_back(twice);
    }
  }

  bool lies_in(FacetIndex facet, const glm::dvec3& normal, const glm::dvec3& point) const {
    if (!thin_[facet] && glm::dot(area_[facet], normal) <= 0.0) return false;
    for (int corner = 0; corner < 3; ++corner) {
      if (std::abs(glm::dot(mesh_.corner(facet, corner) - point, normal)) > tolerance_) return false;
    }
    return true;
  }

  /// From the largest facets on.
  void grow_faces() {
    face_of_.assign(mesh_.facets.size(), k_unset);
    std::vector<FacetIndex> order(mesh_.facets.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, [&](FacetIndex a, FacetIndex b) {
      return glm::dot(area_[a], area_[a]) > glm::dot(area_[b], area_[b]);
    });
    std::vector<FacetIndex> open;
    for (const FacetIndex seed : order) {
      if (face_of_[seed] != k_unset || thin_[seed]) continue;
      const glm::dvec3 normal = glm::normalize(area_[seed]);
      face_of_[seed] = seed;
      open.push_back(seed);
      while (!open.empty()) {
        const FacetIndex facet = open.back();
        open.pop_back();
        for (HalfEdgeIndex h = 3 * facet; h < 3 * facet + 3; ++h) {
          if (twins_[h] == k_unset) continue;
          const FacetIndex across = facet_of(twins_[h]);
          if (face_of_[across] != k_unset || !lies_in(across, normal, mesh_.corner(seed, 0))) continue;
          face_of_[across] = seed;
          open.push_back(across);
        }
      }
    }
  }

  /// What is thin has no plane of its own.
  void join_needles() {
    for (bool joined = true; joined;) {
      joined = false;
      for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
        if (face_of_[facet] != k_unset || twins_[longest_[facet]] == k_unset) continue;
        const std::uint32_t face = face_at(twins_[longest_[facet]]);
        if (face == k_unset) continue;
        face_of_[facet] = face;
        joined = true;
      }
    }
    for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
      if (face_of_[facet] == k_unset) face_of_[facet] = facet;
    }
  }

  /// Numbers from 0 in the order of their first facets.
  void number_faces() {
    std::vector<std::uint32_t> numbers(mesh_.facets.size(), k_unset);
    std::vector<double> weights;
    for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
      std::uint32_t& number = numbers[face_of_[facet]];
      if (number == k_unset) {
        number = static_cast<std::uint32_t>(found_.faces.size());
        found_.faces.emplace_back();
        weights.push_back(0.0);
      }
      face_of_[facet] = number;
      const double area = glm::length(area_[facet]);
      found_.faces[number].normal += area_[facet];
      found_.faces[number].point += area * mesh_.middle(facet);
      weights[number] += area;
    }
    for (std::size_t k = 0; k < found_.faces.size(); ++k) {
      FlatFaces::Face& face = found_.faces[k];
      if (weights[k] > 0.0) face.point /= weights[k];
      const double length = glm::length(face.normal);
      face.normal = length > 0.0 ? face.normal / length : glm::dvec3(0, 0, 1);
    }
  }

  void find_chains() {
    std::vector<std::uint32_t> degree(mesh_.vertices.size(), 0);
    std::vector<HalfEdgeIndex> border;  // each edge once
    for (HalfEdgeIndex h = 0; h < twins_.size(); ++h) {
      if (is_collapsed(mesh_.facets[facet_of(h)]) || !on_border(h)) continue;
      if (twins_[h] != k_unset && twins_[h] < h) continue;
      border.push_back(h);
      ++degree[start_vertex(mesh_, h)];
      ++degree[end_vertex(mesh_, h)];
    }
    std::vector<char> taken(twins_.size(), 0);
    const auto walk_from = [&](HalfEdgeIndex h) {
      Chain chain;
      while (!taken[h]) {
        taken[h] = 1;
        if (twins_[h] != k_unset) taken[twins_[h]] = 1;
        chain.walk.push_back(h);
        if (degree[end_vertex(mesh_, h)] != 2) break;
        h = next_on_border(h);
      }
      chains_.push_back(std::move(chain));
    };
    // From corners first, either way; what is left goes around.
    for (const HalfEdgeIndex h : border) {
      if (taken[h]) continue;
      if (degree[start_vertex(mesh_, h)] != 2) {
        walk_from(h);
      } else if (twins_[h] != k_unset && degree[end_vertex(mesh_, h)] != 2) {
        walk_from(twins_[h]);
      }
    }
    for (const HalfEdgeIndex h : border) {
      if (!taken[h]) walk_from(h);
    }
  }

  /// Marks the corners between first and last, both of which are.
  void mark_corners(const Chain& chain, std::size_t first, std::size_t last,
                    std::vector<char>& is_corner) const {
    std::vector<std::pair<std::size_t, std::size_t>> open = {{first, last}};
    while (!open.empty()) {
      const auto [from, to] = open.back();
      open.pop_back();
      const glm::dvec3 &a = start(chain.walk[from]), &b = end(chain.walk[to - 1]);
      double most = tolerance_;
      std::size_t farthest = from;
      for (std::size_t k = from + 1; k < to; ++k) {
        const double distance = distance_to_segment(start(chain.walk[k]), a, b);
        if (distance <= most) continue;
        most = distance;
        farthest = k;
      }
      if (farthest == from) continue;
      is_corner[farthest] = 1;
      open.emplace_back(from, farthest);
      open.emplace_back(farthest, to);
    }
  }

  void lay_edges() {
    found_.edges.clear();
    pieces_.assign(twins_.size(), {});
    for (std::uint32_t c = 0; c < chains_.size(); ++c) {
      const Chain& chain = chains_[c];
      const std::size_t count = chain.walk.size();
      const bool around = start_vertex(mesh_, chain.walk.front()) == end_vertex(mesh_, chain.walk.back());
      std::vector<char> is_corner(count, chain.whole || around ? 1 : 0);
      is_corner[0] = 1;
      if (!chain.whole && !around) mark_corners(chain, 0, count, is_corner);
      for (std::size_t k = 0; k < count; ++k) {
        if (is_corner[k])
          found_.edges.push_back({start_vertex(mesh_, chain.walk[k]), end_vertex(mesh_, chain.walk[k])});
        found_.edges.back().to = end_vertex(mesh_, chain.walk[k]);
        const auto edge = static_cast<std::uint32_t>(found_.edges.size() - 1);
        pieces_[chain.walk[k]] = {edge, c, is_corner[k] != 0, false};
        const HalfEdgeIndex twin = twins_[chain.walk[k]];
        if (twin != k_unset) pieces_[twin] = {edge, c, is_corner[k] != 0, true};
      }
    }
  }

  /// False where a loop has fewer than three edges, or a face nearly vanishes; its chains are whole then.
  bool walk_loops() {
    for (FlatFaces::Face& face : found_.faces) face.loops.clear();
    std::vector<char> taken(twins_.size(), 0), short_of_edges(found_.faces.size(), 0);
    std::vector<std::vector<double>> areas(found_.faces.size());
    std::vector<double> of_mesh(found_.faces.size(), 0.0), of_edges(found_.faces.size(), 0.0);
    for (HalfEdgeIndex begin = 0; begin < twins_.size(); ++begin) {
      if (taken[begin] || pieces_[begin].edge == k_unset) continue;
      const std::uint32_t number = face_at(begin);
      FlatFaces::Face& face = found_.faces[number];
      FlatFaces::Loop loop;
      double around = 0.0;
      const auto seen = [&](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::dot(glm::cross(a - start(begin), b - start(begin)), face.normal);
      };
      for (HalfEdgeIndex h = begin; !taken[h]; h = next_on_border(h)) {
        taken[h] = 1;
        around += seen(start(h), end(h));
        const Piece& piece = pieces_[h];
        if (!piece.first) continue;
        loop.push_back({piece.edge, piece.backwards});
        const auto& [from, to] = found_.edges[piece.edge];
        of_edges[number] += (piece.backwards ? -1.0 : 1.0) * seen(mesh_.vertices[from], mesh_.vertices[to]);
      }
      of_mesh[number] += around;
      if (loop.size() < 3) short_of_edges[number] = 1;
      std::vector<double>& of_face = areas[number];
      const bool outer = !of_face.empty() && around > of_face.front();
      face.loops.insert(outer ? face.loops.begin() : face.loops.end(), std::move(loop));
      of_face.insert(outer ? of_face.begin() : of_face.end(), around);
    }
    bool all = true;
    for (HalfEdgeIndex h = 0; h < twins_.size(); ++h) {
      if (pieces_[h].edge == k_unset || chains_[pieces_[h].chain].whole) continue;
      const std::uint32_t number = face_at(h);
      if (!short_of_edges[number] && of_edges[number] > 0.5 * of_mesh[number]) continue;
      chains_[pieces_[h].chain].whole = true;
      all = false;
    }
    return all;
  }

  void find_shells() {
    UnionFind joined(mesh_.facets.size());
    for (HalfEdgeIndex h = 0; h < twins_.size(); ++h) {
      if (twins_[h] != k_unset) joined.join(facet_of(h), facet_of(twins_[h]));
    }
    std::vector<std::uint32_t> numbers(mesh_.facets.size(), k_unset);
    for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
      std::uint32_t& number = numbers[joined.find(facet)];
      if (number == k_unset) {
        number = static_cast<std::uint32_t>(found_.shells.size());
        found_.shells.emplace_back();
      }
      FlatFaces::Shell& shell = found_.shells[number];
      found_.faces[face_of_[facet]].shell = number;
      shell.volume += glm::dot(area_[facet], mesh_.corner(facet, 0) - mesh_.vertices.front()) / 6.0;
      for (int corner = 0; corner < 3; ++corner) shell.bounds.add(mesh_.corner(facet, corner));
    }
  }

  const TriangleMesh& mesh_;
  double tolerance_;
  std::vector<HalfEdgeIndex> twins_;
  std::vector<glm::dvec3> area_;        // of each facet: its normal, twice as long as its area
  std::vector<HalfEdgeIndex> longest_;  // edge of each facet
  std::vector<char> thin_;
  std::vector<std::uint32_t> face_of_;
  std::vector<Chain> chains_;
  std::vector<Piece> pieces_;
  FlatFaces found_;
};

}  // namespace

FlatFaces flat_faces(const TriangleMesh& mesh, double tolerance) {
  return FaceFinder(mesh, tolerance).find();
}

}  // namespace moldlight
