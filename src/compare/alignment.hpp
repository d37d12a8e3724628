// Lays a part on another that is turned and moved: principal axes, then the iterated nearest points, by the
// planes of the facets there (Chen & Medioni 1992), without those that have none (Chetverikov et al. 2002).
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "mesh/length_unit.hpp"

namespace moldlight {

/// Of B to A: a point of B goes to rotation * point + shift. Lengths are in A's unit; nothing is scaled.
struct Alignment {
  glm::dmat3 rotation{1.0};
  glm::dvec3 shift{0.0};
  // Distances from A of even samples of B's surface, where it lies then:
  double rms = 0.0, largest = 0.0, median = 0.0;
  bool mirrored = false;  // a mirror image of B would lie far better on A

  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& point) const { return rotation * point + shift; }
};

/// Turns about an axis of symmetry are all alike: of those the least is taken, as good as it is found. The
/// same to the bit for any number of threads. Throws Cancelled.
[[nodiscard]] Alignment align(const PartModel& a, const PartModel& b, const Progress& progress);

/// B as A in another size, such as by a shrink that was left out.
struct UniformScale {
  double factor = 1.0;  // lengths of B in those of A, in [0.9, 1.1] or that of two units
  double other = 0.0;   // share of both surfaces that is off nevertheless, in [0, 0.2]
  glm::dmat3 rotation{1.0};
  glm::dvec3 shift{0.0};  // a point of B, rotation * point + shift, lies on factor * A
};
/// Units that A and B would have if they were one part and B's numbers `factor` times A's: two of mm, cm,
/// inch and m, to a thousandth. None for other factors.
[[nodiscard]] std::optional<std::pair<LengthUnit, LengthUnit>> mistaken_units(double factor);
/// None where B is as large as A, or is no better explained by a scale. With `alignment`, how B lies best as
/// it is, B may lie anywhere; else it is scaled about the origin or about a point of its box or its surface.
/// What is off is farther than `apart`, in A's unit, and than the chords there may be. Throws Cancelled.
[[nodiscard]] std::optional<UniformScale> find_scale(const PartModel& a, const PartModel& b,
                                                     const std::optional<Alignment>& alignment, double apart,
                                                     const Progress& progress);
/// Turned as the scale has it, about the middle of A's surface: nearest points turn a part of another size.
[[nodiscard]] Alignment align_scaled(const PartModel& a, const PartModel& b, const UniformScale& scale);

/// The part where the alignment puts it.
[[nodiscard]] std::shared_ptr<const PartModel> moved_part(const PartModel& part, const Alignment& alignment,
                                                          const Progress& progress);

}  // namespace moldlight
