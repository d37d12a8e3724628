#include "pieces/formed_surface.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "base/error.hpp"
#include "mesh/union_find.hpp"
#include "mold/direction.hpp"
#include "parting/min_cut.hpp"
#include "parting/piece_edges.hpp"
#include "pieces/piece_words.hpp"

namespace moldlight {

namespace {

/// What an area costs at a later direction, as a share of it in diagonals: it decides between equals.
constexpr double k_later = 1e-3;
/// Likewise, at a direction beside an opposite pair: a strip a twentieth of the diagonal wide costs its
/// length, so that the halves form what they can.
constexpr double k_beside_pair = 20.0;
constexpr double k_across_cosmetic = 20.0;  // what a seam costs there
/// Of what a direction is to form: so much it may not release, by the tolerance along edges.
constexpr double k_unreleased_share = 0.01;
constexpr int k_most_expansions = 4;
/// Of the surface: what is left over in smaller patches goes to any direction.
constexpr double k_speck_share = 1e-5;

/// The part, split along one line after the other, and the directions that release each piece, as bits.
struct ReleasedMesh {
  SplitMesh mesh;
  std::vector<std::uint32_t> released_by;
};

ReleasedMesh released_mesh(const PartModel& model, const ExactQuery& query,
                           std::span<const glm::dvec3> directions, const Progress& progress) {
  ReleasedMesh found;
  std::vector<glm::dvec3> lines;
  for (const glm::dvec3& direction : directions) {
    const glm::dvec3 line = half_sphere(direction);
    if (std::ranges::find(lines, line) == lines.end()) lines.push_back(line);
  }
  for (const glm::dvec3& line : lines) {
    ExactQuery along = query;
    along.direction = line;
    std::uint32_t plus = 0, minus = 0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      if (half_sphere(directions[k]) != line) continue;
      (glm::dot(directions[k], line) > 0.0 ? plus : minus) |= 1U << k;
    }
    ReleasedMesh next;
    if (found.mesh.pieces.empty()) {
      next.mesh = exact_split(model.exact(progress), along, progress).mesh;
    } else {
      const TriangleMesh mesh = piece_mesh(found.mesh);
      FacetGeometry geometry = facet_geometry(mesh);
      // Needles have no normal of their own that is worth anything.
      for (std::size_t k = 0; k < found.mesh.pieces.size(); ++k)
        geometry.normals[k] = model.geometry.normals[found.mesh.pieces[k].facet];
      const ExactPart part(mesh, geometry, model.frame, progress, model.part.effort);
      next.mesh = exact_split(part, along, progress).mesh;
    }
    for (SplitPiece& piece : next.mesh.pieces) {
      std::uint32_t by = found.mesh.pieces.empty() ? 0 : found.released_by[piece.facet];
      const unsigned accessible = facts(piece.region).accessible;
      if ((accessible & 1U) != 0) by |= plus;
      if ((accessible & 2U) != 0) by |= minus;
      next.released_by.push_back(by);
      if (!found.mesh.pieces.empty()) piece.facet = found.mesh.pieces[piece.facet].facet;
    }
    found = std::move(next);
  }
  return found;
}

/// Labels of the pieces by expansion moves.
class Labelling {
 public:
  Labelling(const PartModel& model, const ExactQuery& query, std::span<const glm::dvec3> directions,
            ReleasedMesh released, const SurfaceWishes& wishes)
      : model_(model),
        wishes_(wishes),
        directions_(directions),
        pair_(opposite_pair(directions)),
        count_(static_cast<std::uint32_t>(directions.size())),
        mesh_(std::move(released.mesh)),
        may_(std::move(released.released_by)),
        edges_(piece_edges(mesh_)),
        crease_(crease_edges(mesh_, edges_, model.geometry)),
        lateral_(query.lateral * model.frame.diagonal) {
    for (const PieceEdge& edge : edges_.edges)
      lengths_.push_back(glm::distance(mesh_.vertices[edge.from], mesh_.vertices[edge.to]));
    for (PieceIndex piece = 0; piece < mesh_.pieces.size(); ++piece)
      areas_.push_back(0.5 * glm::length(twice_piece_area(mesh_, piece)));
    leave_over();
    grant();
    for (const std::uint32_t may : may_)
      labels_.push_back(may == 0 ? count_ : static_cast<std::uint32_t>(std::countr_zero(may)));
  }

  void expand(const Progress& progress);
  void join_narrow();
  [[nodiscard]] FormedSurface surface() &&;

 private:
  [[nodiscard]] const glm::dvec3& normal(PieceIndex piece) const {
    return model_.geometry.normals[mesh_.pieces[piece].facet];
  }
  void leave_over();
  void grant();
  [[nodiscard]] bool expand_to(std::uint32_t label, const Progress& progress);
  [[nodiscard]] double cost_at(PieceIndex piece, std::uint32_t label) const;
  [[nodiscard]] double seam_cost(std::size_t edge, std::uint32_t a, std::uint32_t b) const;
  /// Pieces that hang together and have one label, by the lowest of them.
  [[nodiscard]] UnionFind patches() const;
  [[nodiscard]] std::vector<PieceSeam> seams() const;

  const PartModel& model_;
  const SurfaceWishes& wishes_;
  std::span<const glm::dvec3> directions_;
  std::optional<std::pair<std::size_t, std::size_t>> pair_;  // of them
  std::uint32_t count_;                                      // of the directions; as a label: left over
  SplitMesh mesh_;
  std::vector<std::uint32_t> may_;  // directions that may form each piece, as bits
  PieceEdges edges_;
  std::vector<std::uint8_t> crease_;  // of each edge
  double lateral_;
  std::vector<double> lengths_, areas_;  // of each edge, of each piece
  std::vector<std::uint32_t> labels_;
};

/// What nothing releases stays so where it is more than a speck and no piece stretches over it.
void Labelling::leave_over() {
  UnionFind joined(may_.size());
  for (const PieceEdge& edge : edges_.edges) {
    if (edge.right != k_no_piece && may_[edge.left] == 0 && may_[edge.right] == 0)
      joined.join(edge.left, edge.right);
  }
  std::vector<double> sums(may_.size(), 0.0);
  for (PieceIndex piece = 0; piece < may_.size(); ++piece) {
    if (may_[piece] == 0) sums[joined.find(piece)] += areas_[piece];
  }
  const double floor =
      std::max(k_speck_share * model_.geometry.total_area, std::numbers::pi * lateral_ * lateral_);
  for (PieceIndex piece = 0; piece < may_.size(); ++piece) {
    if (may_[piece] != 0) continue;
    const std::uint32_t by = SurfaceWishes::of(wishes_.stretched_by, mesh_.pieces[piece].facet);
    may_[piece] = sums[joined.find(piece)] <= floor ? (1U << count_) - 1U : by < count_ ? 1U << by : 0U;
  }
}

/// What is given to a direction goes to it alone, as far as it releases it.
void Labelling::grant() {
  std::map<std::uint32_t, std::pair<double, double>> sums;  // by direction: not released, and all
  for (PieceIndex piece = 0; piece < may_.size(); ++piece) {
    const std::uint32_t by = SurfaceWishes::of(wishes_.formed_by, mesh_.pieces[piece].facet);
    if (by >= count_) continue;
    const bool releases = (may_[piece] >> by & 1U) != 0;
    auto& [missed, all] = sums[by];
    all += areas_[piece];
    missed += releases ? 0.0 : areas_[piece];
    if (releases) may_[piece] = 1U << by;
  }
  for (const auto& [by, area] : sums)
    if (area.first > k_unreleased_share * area.second)
      throw UsageError(
          fmt::format("--cosmetic: piece {} moves along {}, which does not release {:.1f} % of its faces",
                      by + 1, pull_words(directions_[by]), 100.0 * area.first / area.second));
}

/// At most twice that of another seam there, so that by way of a third label nothing gets cheaper.
double Labelling::seam_cost(std::size_t edge, std::uint32_t a, std::uint32_t b) const {
  if (a == b) return 0.0;
  const PieceEdge& at = edges_.edges[edge];
  const glm::dvec3 apart = glm::normalize(directions_[a] - directions_[b]);
  const double climb = std::abs(glm::dot(mesh_.vertices[at.to] - mesh_.vertices[at.from], apart));
  const std::uint32_t face = SurfaceWishes::of(wishes_.cosmetic, mesh_.pieces[at.left].facet);
  const bool across = face != SurfaceWishes::k_none &&
                      face == SurfaceWishes::of(wishes_.cosmetic, mesh_.pieces[at.right].facet);
  return (lengths_[edge] + climb) * (across ? k_across_cosmetic : crease_[edge] != 0 ? k_crease_weight : 1.0);
}

double Labelling::cost_at(PieceIndex piece, std::uint32_t label) const {
  const double sine = glm::dot(normal(piece), directions_[label]);
  const double against = sine < -k_least_reverse_sine ? k_draft_weight * -sine : 0.0;
  const bool beside = pair_ && label != pair_->first && label != pair_->second;
  return areas_[piece] / model_.frame.diagonal *
         (against + k_later * static_cast<double>(label) + (beside ? k_beside_pair : 0.0));
}

/// Pieces that may keep their label (side 1) or take this one (side 0).
bool Labelling::expand_to(std::uint32_t label, const Progress& progress) {
  constexpr std::uint32_t k_still = ~0U;
  std::vector<std::uint32_t> node(labels_.size(), k_still);
  std::uint32_t nodes = 0;
  for (PieceIndex piece = 0; piece < labels_.size(); ++piece) {
    if (labels_[piece] != label && labels_[piece] != count_ && (may_[piece] >> label & 1U) != 0)
      node[piece] = nodes++;
  }
  if (nodes == 0) return false;
  MinCut cut(nodes);
  for (PieceIndex piece = 0; piece < labels_.size(); ++piece) {
    if (node[piece] == k_still) continue;
    cut.add_cost(node[piece], 0, cost_at(piece, label));
    cut.add_cost(node[piece], 1, cost_at(piece, labels_[piece]));
  }
  for (std::size_t k = 0; k < edges_.edges.size(); ++k) {
    const auto& [from, to, left, right, left_side, right_side] = edges_.edges[k];
    if (right == k_no_piece || labels_[left] == count_ || labels_[right] == count_) continue;
    const std::uint32_t of_left = labels_[left], of_right = labels_[right];
    const double left_goes = seam_cost(k, label, of_right), right_goes = seam_cost(k, of_left, label);
    const double both_stay = seam_cost(k, of_left, of_right);
    if (node[left] != k_still && node[right] != k_still) {
      const double link = 0.5 * (left_goes + right_goes - both_stay);
      cut.add_link(node[left], node[right], std::max(0.0, link));
      cut.add_cost(node[left], 1, std::max(0.0, right_goes - link));
      cut.add_cost(node[right], 1, std::max(0.0, left_goes - link));
    } else if (node[left] != k_still) {
      cut.add_cost(node[left], 0, left_goes);
      cut.add_cost(node[left], 1, both_stay);
    } else if (node[right] != k_still) {
      cut.add_cost(node[right], 0, right_goes);
      cut.add_cost(node[right], 1, both_stay);
    }
  }
  const std::vector<std::uint8_t> sides = cut.solve(progress);
  bool changed = false;
  for (PieceIndex piece = 0; piece < labels_.size(); ++piece) {
    if (node[piece] == k_still || sides[node[piece]] != 0) continue;
    labels_[piece] = label;
    changed = true;
  }
  return changed;
}

void Labelling::expand(const Progress& progress) {
  for (int round = 0; round < k_most_expansions; ++round) {
    bool changed = false;
    for (std::uint32_t label = 0; label < count_; ++label) {
      progress.report("assigning",
                      (static_cast<double>(round) + static_cast<double>(label) / count_) / k_most_expansions);
      changed = expand_to(label, progress) || changed;
    }
    if (!changed) return;
  }
}

UnionFind Labelling::patches() const {
  UnionFind joined(labels_.size());
  for (const PieceEdge& edge : edges_.edges) {
    if (edge.right != k_no_piece && labels_[edge.left] == labels_[edge.right])
      joined.join(edge.left, edge.right);
  }
  return joined;
}

/// Patches narrower than the lateral tolerance, which is what that leaves along edges, go to the neighbour
/// with which they have the longest border.
void Labelling::join_narrow() {
  UnionFind joined = patches();
  std::vector<double> sums(labels_.size(), 0.0), around(labels_.size(), 0.0);
  for (PieceIndex piece = 0; piece < labels_.size(); ++piece) sums[joined.find(piece)] += areas_[piece];
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> borders;  // by patch and label across
  for (std::size_t k = 0; k < edges_.edges.size(); ++k) {
    const PieceEdge& edge = edges_.edges[k];
    if (edge.right == k_no_piece || labels_[edge.left] == labels_[edge.right]) continue;
    for (const auto& [inner, outer] : {std::pair(edge.left, edge.right), std::pair(edge.right, edge.left)}) {
      around[joined.find(inner)] += lengths_[k];
      borders[{joined.find(inner), labels_[outer]}] += lengths_[k];
    }
  }
  std::map<std::uint32_t, std::pair<double, std::uint32_t>> longest;  // of narrow patches
  for (const auto& [key, length] : borders) {
    const auto& [patch, label] = key;
    if (2.0 * sums[patch] >= lateral_ * around[patch]) continue;
    auto& best = longest[patch];
    if (length > best.first) best = {length, label};
  }
  std::vector<std::uint32_t> labels = labels_;
  for (PieceIndex piece = 0; piece < labels_.size(); ++piece) {
    const auto found = longest.find(joined.find(piece));
    if (found != longest.end()) labels[piece] = found->second.second;
  }
  labels_ = std::move(labels);
}

std::vector<PieceSeam> Labelling::seams() const {
  std::map<std::pair<VertexIndex, VertexIndex>, bool> creases;
  for (std::size_t k = 0; k < edges_.edges.size(); ++k) {
    const PieceEdge& edge = edges_.edges[k];
    if (edge.right != k_no_piece && labels_[edge.left] != labels_[edge.right])
      creases[std::minmax(edge.from, edge.to)] = crease_[k] != 0;
  }
  std::vector<PieceSeam> seams;
  SplitMesh marked = mesh_;
  for (std::uint32_t a = 0; a < count_; ++a) {
    for (std::uint32_t b = a + 1; b < count_; ++b) {
      for (PieceIndex piece = 0; piece < labels_.size(); ++piece)
        marked.pieces[piece].region = labels_[piece] == a   ? Region::core
                                      : labels_[piece] == b ? Region::cavity
                                                            : Region::undercut;
      const std::size_t first = seams.size();
      for (const RegionBorder& border : region_borders(marked)) {
        if (border.right != Region::cavity) continue;
        PieceSeam seam{.a = a, .b = b, .points = {}, .closed = border.closed()};
        double on_creases = 0.0;
        for (std::size_t k = 0; k < border.vertices.size(); ++k) {
          seam.points.push_back(mesh_.vertices[border.vertices[k]]);
          if (k == 0) continue;
          const double length = glm::distance(seam.points[k - 1], seam.points[k]);
          seam.length += length;
          if (creases[std::minmax(border.vertices[k - 1], border.vertices[k])]) on_creases += length;
        }
        seam.crease_share = seam.length > 0.0 ? on_creases / seam.length : 0.0;
        seams.push_back(std::move(seam));
      }
      std::stable_sort(
          seams.begin() + static_cast<std::ptrdiff_t>(first), seams.end(),
          [](const PieceSeam& one, const PieceSeam& other) { return one.length > other.length; });
    }
  }
  return seams;
}

FormedSurface Labelling::surface() && {
  FormedSurface surface;
  UnionFind joined = patches();
  std::map<std::uint32_t, FormedPatch> found;
  for (PieceIndex piece = 0; piece < labels_.size(); ++piece) {
    mesh_.pieces[piece].region = Region::both;
    if (labels_[piece] == count_) continue;
    FormedPatch& patch = found[joined.find(piece)];
    patch.direction = labels_[piece];
    patch.area += areas_[piece];
    patch.centre += areas_[piece] * mesh_.middle(piece);
  }
  for (auto& [first, patch] : found) {
    if (patch.area <= 0.0) continue;
    patch.centre /= patch.area;
    surface.patches.push_back(patch);
  }
  std::ranges::stable_sort(surface.patches, [](const FormedPatch& one, const FormedPatch& other) {
    return one.direction != other.direction ? one.direction < other.direction : one.area > other.area;
  });
  surface.seams = seams();
  surface.mesh = std::move(mesh_);
  surface.formed_by = std::move(labels_);
  return surface;
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> opposite_pair(std::span<const glm::dvec3> directions) {
  for (std::size_t a = 0; a < directions.size(); ++a) {
    for (std::size_t b = a + 1; b < directions.size(); ++b) {
      if (glm::dot(directions[a], directions[b]) < -1.0 + 1e-12) return std::pair(a, b);
    }
  }
  return std::nullopt;
}

FormedSurface form_surface(const PartModel& model, const ExactQuery& query,
                           std::span<const glm::dvec3> directions, const Progress& progress,
                           const SurfaceWishes& wishes) {
  CHECK(!directions.empty() && directions.size() < 32);
  Labelling labelling(model, query, directions, released_mesh(model, query, directions, progress), wishes);
  labelling.expand(progress);
  labelling.join_narrow();
  return std::move(labelling).surface();
}

}  // namespace moldlight
