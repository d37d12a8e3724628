// Whether a straight pull sideways releases an undercut, how far it must go, and how far it may turn.
#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "actions/undercut.hpp"

namespace moldlight {

/// Of an undercut's area so much may stay blocked: specks at its rim, within the lateral tolerance of an
/// edge.
inline constexpr double k_blocked_share = 0.005;

/// Degrees about an axis to both sides of a direction, [-180, 180].
struct TurnInterval {
  double from_deg = 0.0, to_deg = 0.0;
  [[nodiscard]] double middle_deg() const { return 0.5 * (from_deg + to_deg); }
};

/// Answers for one part and one parting direction by exact rays. Lengths are shares of the part's diagonal.
/// Surface whose draft to a pull is less than tau neither needs to face it nor is in its way: within that
/// tolerance it is parallel to it. Such a point is tested from beside it, by the lateral tolerance; one that
/// meets such surface on its way goes on from beside that, so that it never goes deeper into the part than
/// the lateral tolerance and the sine of tau times its way.
class Release {
 public:
  Release(const PartModel& model, const ExactQuery& query);

  /// How far a point moves along `pull` (unit) before the part is in its way: 0 for one that faces against
  /// it, infinity for one that is never stopped.
  [[nodiscard]] double free_length(const UndercutSample& sample, const glm::dvec3& pull) const;
  /// Whether it is inside the part: surface of a body that another one covers.
  [[nodiscard]] bool covered(const UndercutSample& sample, const glm::dvec3& pull) const;
  /// Area of the samples that move at least so far.
  [[nodiscard]] double free_area(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                                 double length) const;
  /// Whether all but k_blocked_share of their area moves so far; samples without area must move, too. Ends at
  /// the first too many that is blocked.
  [[nodiscard]] bool releases(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                              double length) const;

  /// How far a released pull may turn about `axis` (unit) to either side and still release, to 1e-4 degrees.
  [[nodiscard]] TurnInterval free_turn(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                                       const glm::dvec3& axis) const;

  /// How far the part reaches along a direction (unit), unit frame.
  [[nodiscard]] double reach(const glm::dvec3& direction) const;

  /// Whether a point that has moved by `length` gets away from the part along `side` (unit), +d or -d.
  [[nodiscard]] bool clear(const UndercutSample& sample, const glm::dvec3& pull, double length,
                           const glm::dvec3& side) const;
  /// Area of the samples that move so far, and are clear there.
  [[nodiscard]] double cleared_area(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                                    const glm::dvec3& side, double length) const;
  /// The least length beyond which all samples are clear, whatever lies beyond; looked for in steps of `step`
  /// and then halved to 1e-7.
  [[nodiscard]] double clear_beyond(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                                    const glm::dvec3& side, double step) const;
  /// The least length, up to `most`, at which all samples are clear at once and which they reach; none where
  /// there is no such length.
  [[nodiscard]] std::optional<double> first_clear(std::span<const UndercutSample> samples,
                                                  const glm::dvec3& pull, const glm::dvec3& side,
                                                  double most) const;

 private:
  [[nodiscard]] glm::vec3 start(const UndercutSample& sample, const glm::dvec3& pull) const;

  const PartModel& model_;
  ExactQuery query_;
  double sine_;  // of tau
};

/// `direction` turned about `axis`, both unit.
[[nodiscard]] glm::dvec3 turned_about(const glm::dvec3& direction, const glm::dvec3& axis, double angle_deg);

}  // namespace moldlight
