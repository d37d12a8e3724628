// Lays the surface of one part on that of another: which of it lies on which, and what is left over.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/progress.hpp"
#include "classify/classification.hpp"
#include "classify/part_model.hpp"
#include "mesh/convex_polygon.hpp"
#include "mesh/faces.hpp"
#include "mold/exact_rays.hpp"

namespace moldlight {

using PieceIndex = std::uint32_t;

/// How far a mesh may lie off the surface that it stands for, by which two tessellations of one surface
/// differ: an estimate a facet, in the part's unit; 0 for a facet of a plane. Of a surface that bends by an
/// angle b from facet to facet, each w wide, the chords are off by w b / 8. What bends is known from the
/// part's faces: those of CAD, else round walls of 10 steps a turn or more.
struct ChordDeviation {
  std::vector<double> normal;   // off the facet's plane
  std::vector<double> lateral;  // of its rim: the greatest of the facets around its corners
  std::vector<double> step;     // the widest around its corners, across the bend: shadows move by that
  std::vector<double> spread;   // tangent of half the angle to the next step
  double greatest = 0.0;
};
[[nodiscard]] ChordDeviation chord_deviation(const PartModel& model, const Faces& faces);

/// A part, split at the borders of its regions, with what is asked about its surface. It does not move.
class OverlaySide {
 public:
  /// `result` is a classification of the model that has its split mesh.
  OverlaySide(std::shared_ptr<const PartModel> model, const Classification& result);
  OverlaySide(const OverlaySide&) = delete;

  [[nodiscard]] const PartModel& model() const { return *model_; }
  [[nodiscard]] const SplitMesh& split() const { return *split_; }
  [[nodiscard]] const ChordDeviation& chords() const { return chords_; }
  [[nodiscard]] const Faces& faces() const { return faces_; }
  [[nodiscard]] const ExactRays& rays() const { return rays_; }
  [[nodiscard]] const glm::dvec3& direction() const { return direction_; }
  [[nodiscard]] double tau_deg() const { return tau_deg_; }

  [[nodiscard]] std::size_t count() const { return split_->pieces.size(); }
  [[nodiscard]] FacetIndex facet(PieceIndex piece) const { return split_->pieces[piece].facet; }
  [[nodiscard]] Region region(PieceIndex piece) const { return split_->pieces[piece].region; }
  [[nodiscard]] const glm::dvec3& normal(PieceIndex piece) const { return measures_[piece].normal; }
  [[nodiscard]] double area(PieceIndex piece) const { return measures_[piece].area; }
  /// What is near it.
  [[nodiscard]] TriangleHull hull(PieceIndex piece, const Nearness& nearness) const {
    return hull_around(corners(piece), normal(piece), nearness);
  }
  /// A sphere around it.
  [[nodiscard]] const glm::dvec3& centre(PieceIndex piece) const { return measures_[piece].centre; }
  [[nodiscard]] double radius(PieceIndex piece) const { return measures_[piece].radius; }
  [[nodiscard]] double mean_radius() const { return mean_radius_; }
  [[nodiscard]] std::array<glm::dvec3, 3> corners(PieceIndex piece) const {
    const auto& [a, b, c] = split_->pieces[piece].corners;
    return {split_->vertices[a], split_->vertices[b], split_->vertices[c]};
  }

 private:
  /// Of a piece, beside each other: they are asked for by the million.
  struct Measures {
    glm::dvec3 centre, normal;
    double radius = 0.0, area = 0.0;
  };

  std::shared_ptr<const PartModel> model_;
  std::shared_ptr<const SplitMesh> split_;
  glm::dvec3 direction_;
  double tau_deg_;
  Faces faces_;
  ChordDeviation chords_;
  std::vector<Measures> measures_;
  double mean_radius_ = 0.0;
  ExactRays rays_;
};

/// Tolerances, in the part's unit.
struct OverlayTolerance {
  double apart = 0.0;  // surface farther from the other part than this, and than what the tessellations may
                       // be off where it bends, is certainly not on it
  double rounding = 0.0;  // of coordinates, below `apart`
};

/// A 10,000th of the diagonal, and a hundredth of that for rounding.
[[nodiscard]] inline OverlayTolerance usual_tolerance(double diagonal) {
  return {.apart = 1e-4 * diagonal, .rounding = 1e-6 * diagonal};
}

/// Area of a piece that lies on one of the other part.
struct PieceShare {
  PieceIndex piece = 0, other = 0;
  double area = 0.0;
};

/// Surface of a piece that is off the other part by more than rounding.
struct LeftOver {
  PieceIndex piece = 0;
  ConvexPolygon polygon;
  double area = 0.0;
  double explained = 0.0;  // 0: it is certainly not on the other part; else how far beyond the rim of a facet
                           // of it the tolerance reached that explains it
};

/// Surface that lies on that of the other part, which has another region there.
struct OtherRegion {
  PieceIndex piece = 0, other = 0;
  ConvexPolygon polygon;
  double area = 0.0;
};

/// In the order of the pieces: the areas of shares and of what is certainly left over sum up to the part's.
struct Overlay {
  std::vector<PieceShare> shares;
  std::vector<LeftOver> left;
  std::vector<OtherRegion> regions;
};

/// Computed, without samples: each piece is cut by the hulls of the pieces of `onto` that are near it and
/// face the same way within 60 degrees. Uses all cores of the calling thread's TBB arena; the same to the bit
/// for any number of threads. Throws Cancelled.
[[nodiscard]] Overlay lay_on(const OverlaySide& side, const OverlaySide& onto,
                             const OverlayTolerance& tolerance, const Progress& progress);

/// Calls `visit` for the pieces that come as near as `reach` to a point, some that are farther among them.
template <typename Visit>
void visit_pieces(const OverlaySide& side, const glm::dvec3& point, double reach, const Visit& visit) {
  constexpr float k_search_margin = 1e-6F;  // single precision of the search tree, in its unit frame
  const UnitFrame& frame = side.model().frame;
  const float radius = static_cast<float>(reach / frame.diagonal) + k_search_margin;
  side.rays().visit_near(frame.to_unit(point), radius, [&](FacetIndex piece) {
    visit(piece);
    return radius;
  });
}

}  // namespace moldlight
