// Undercuts about an axis along the parting direction: threads, which are unscrewed, and rings, which are
// stripped.
#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "actions/undercut.hpp"

namespace moldlight {

/// A motion about an axis along the parting direction that keeps a surface on itself.
struct HelixFit {
  glm::dvec3 point{0.0};  // of the axis, unit frame
  double advance = 0.0;  // along +d for a turn about it by one radian, unit frame; 0: a surface of revolution
};

/// The rotation about an axis along `direction` (unit), with an advance along it, under which the samples'
/// surface moves least along its normals: n (w d x (p - c) + k d) = 0 is linear in (w, w c, k), so that the
/// smallest eigenvalue of a 4 x 4 matrix shows it. Nothing where it is no rotation, or no better than other
/// motions.
[[nodiscard]] std::optional<HelixFit> fit_helix(std::span<const UndercutSample> samples,
                                                const glm::dvec3& direction);

/// What may be a thread or a ring: samples of it, and the facets it lies on.
struct RevolvedSurface {
  std::span<const UndercutSample> samples;
  std::span<const FacetIndex> facets;
};

/// What it takes to unscrew.
struct Thread {
  HelixFit helix;
  double pitch = 0.0;  // along the axis for a whole turn, share of the diagonal, > 0
  bool right_handed = true;
  bool core_side = true;  // it leaves along +d
};

/// A thread in these samples, if one can be unscrewed: moved along the helix, turn by turn until they have
/// gone as far as they reach along `direction`, nearly none of them meets the part.
[[nodiscard]] std::optional<Thread> find_thread(const PartModel& model, const RevolvedSurface& surface,
                                                const ExactQuery& query);

/// Whether another undercut is unscrewed with a thread: about as far from the axis as the thread, facing it
/// as the thread does, and not in the part's way on the thread's motion.
struct ThreadAndOther {
  std::span<const UndercutSample> thread, other;
};
[[nodiscard]] bool goes_with(const PartModel& model, const Thread& thread, const ThreadAndOther& samples,
                             const ExactQuery& query);

/// A ring that goes all the way round.
struct Ring {
  HelixFit axis;
  double strain =
      0.0;  // of what is stretched, greatest diameter less the least, as a share of that which stretches
  double depth = 0.0;  // by which it reaches beyond what it must pass, share of the diagonal
  bool core_side = true;
};

/// A ring groove or bead in these samples, and the strain at which the part is stripped off: inside, (groove
/// - neck) / neck; outside, (bead - cavity) / bead, by diameters, towards the side on which it is less.
[[nodiscard]] std::optional<Ring> find_ring(const PartModel& model, const RevolvedSurface& surface,
                                            const ExactQuery& query);

}  // namespace moldlight
