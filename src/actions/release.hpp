// Whether a straight pull sideways releases an undercut, how far it must go, and how far it may turn.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/undercut_sample.hpp"
#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "mold/exact/exact_regions.hpp"

namespace moldlight {

/// Of an undercut's area so much may stay blocked: specks at its rim, within twice the lateral tolerance of
/// an edge or of what is free.
inline constexpr double k_blocked_share = 0.005;

/// The travel of what is never stopped, or never free.
inline constexpr double k_never = std::numeric_limits<double>::infinity();

/// How finely a turn is found where it is reported.
inline constexpr double k_exact_turn_deg = 1e-4;

[[nodiscard]] double area_of(std::span<const UndercutSample> samples);

/// Degrees about an axis to both sides of a direction, [-180, 180].
struct TurnInterval {
  double from_deg = 0.0, to_deg = 0.0;
  [[nodiscard]] double middle_deg() const { return 0.5 * (from_deg + to_deg); }
};

/// Sideways by `length` along `pull`, then away along `side`; unit vectors.
struct LifterWay {
  glm::dvec3 pull, side;
  double length = 0.0;  // share of the part's diagonal
};

/// Answers for one part and one parting direction by exact rays. Lengths are shares of the part's diagonal.
/// Surface whose draft to a pull is less than tau neither needs to face it nor is in its way: within that
/// tolerance it is parallel to it. Such a point is tested from beside it, by the lateral tolerance; one that
/// meets such surface on its way goes on from beside that, so that it never goes deeper into the part than
/// the lateral tolerance and the sine of tau times its way. Throws Cancelled from every question.
class FreeLengths;
class Release {
 public:
  /// `progress` may be null: nobody cancels.
  Release(const PartModel& model, const ExactQuery& query, const Progress* progress = nullptr);

  /// For work beside that asks nothing for long.
  void end_if_cancelled() const {
    if (progress_ != nullptr && progress_->cancelled()) throw Cancelled();
  }

  /// The parting direction.
  [[nodiscard]] const glm::dvec3& direction() const { return query_.direction; }
  /// The lateral tolerance, share of the diagonal.
  [[nodiscard]] double lateral() const { return query_.lateral; }
  /// Where a point starts: beside it, if its surface is parallel to the pull (unit).
  [[nodiscard]] glm::vec3 start(const UndercutSample& sample, const glm::dvec3& pull) const;
  /// How far a point moves along `pull` (unit) before the part is in its way: 0 for one that faces against
  /// it, infinity for one that is never stopped.
  [[nodiscard]] double free_length(const UndercutSample& sample, const glm::dvec3& pull) const;
  /// Whether it lies inside another body of the part, by what two rays cross; beside the surface by next to
  /// nothing, since a gap may be narrower than the lateral tolerance.
  [[nodiscard]] bool is_covered(const UndercutSample& sample) const;
  /// Whether it is inside the part on its way along `pull`: surface of a body that another one covers.
  [[nodiscard]] bool covered(const UndercutSample& sample, const glm::dvec3& pull) const;
  /// Whether the part faces it across less than `width`: no steel is so thin.
  [[nodiscard]] bool is_in_slit(const UndercutSample& sample, double width) const;
  /// Whether it gets away from the part along the parting direction or against it after a move of `depth`
  /// across it, or is in a slit narrower than that.
  [[nodiscard]] bool is_shallow(const UndercutSample& sample, double depth) const;
  /// Whether it would be clear along a pull, moved across it by so much.
  [[nodiscard]] bool is_nearly_free(const UndercutSample& sample, const glm::dvec3& pull, double depth) const;
  /// Area of the samples that move at least so far; where that is certainly no more than `most`, less of it.
  [[nodiscard]] double free_area(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                                 double length, double most = 0.0) const;
  /// Whether all of them move so far but for specks, which make up k_blocked_share of their area at most;
  /// samples without area must move, too. Ends at the first that says no.
  [[nodiscard]] bool releases(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                              double length) const;

  /// How far a released pull may turn about `axis` (unit) to either side and still release, less
  /// `resolved_deg` at most.
  [[nodiscard]] TurnInterval free_turn(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                                       const glm::dvec3& axis, double resolved_deg) const;

  /// How far a lifter may turn about `axis` and still clear the samples by a travel of at most a tenth more:
  /// by what turning alone adds to it, by half of the tenth, or by all of it. To 1e-4 degrees.
  [[nodiscard]] TurnInterval lifter_turn(std::span<const UndercutSample> samples, const LifterWay& way,
                                         const glm::dvec3& axis) const;

  /// How far the part reaches along a direction (unit), and where its middle is, unit frame.
  [[nodiscard]] double reach(const glm::dvec3& direction) const;
  [[nodiscard]] double middle(const glm::dvec3& direction) const {
    return 0.5 * (reach(direction) - reach(-direction));
  }

  /// From a point (unit frame) along a direction (unit) to where the part is; none where it is not.
  [[nodiscard]] std::optional<double> gap(const glm::dvec3& from, const glm::dvec3& along) const;
  /// Whether nothing of the part is on the way from a point (unit frame) along a direction (unit).
  [[nodiscard]] bool leaves(const glm::dvec3& from, const glm::dvec3& along) const;
  /// Whether a point that has moved by `length` gets away from the part along `side` (unit), +d or -d;
  /// what only touches its way there does not keep it.
  [[nodiscard]] bool clear(const UndercutSample& sample, const glm::dvec3& pull, double length,
                           const glm::dvec3& side) const;
  /// Whether it moves so far and is clear there, and so is what is `room` thick before it.
  [[nodiscard]] bool clears(const UndercutSample& sample, const LifterWay& way, double room = 0.0) const;
  [[nodiscard]] bool clears(const UndercutSample& sample, const LifterWay& way, double room,
                            FreeLengths& lengths) const;
  /// The least length beyond which all samples are clear, whatever lies beyond; looked for in steps of `step`
  /// and then halved to 1e-7.
  [[nodiscard]] double clear_beyond(std::span<const UndercutSample> samples, const glm::dvec3& pull,
                                    const glm::dvec3& side, double step) const;
  /// Whether all of them do; as releases().
  [[nodiscard]] bool clears(FreeLengths& lengths, const LifterWay& way, double room = 0.0) const;
  /// How far all samples move but for specks; less than `least` where that is certainly too little.
  [[nodiscard]] double free_of_all(FreeLengths& lengths, double least) const;
  /// The least length, from that of the way on, at which all samples are clear at once and which they reach;
  /// none where there is no such length.
  [[nodiscard]] std::optional<double> first_clear(FreeLengths& lengths, LifterWay way) const;

 private:
  /// How many bodies a point (unit frame) is in, by what a ray from it crosses.
  [[nodiscard]] int depth(const glm::dvec3& from, const glm::dvec3& along) const;
  /// Whether a blocked sample is within twice the lateral tolerance of a place of its plane that is free.
  template <typename Free>
  [[nodiscard]] bool is_speck(const UndercutSample& sample, const Free& free) const;
  /// Begins with the `first`, which becomes what stays behind by itself: it is likely to do so once more.
  template <typename Free>
  [[nodiscard]] bool all_but_specks(std::span<const UndercutSample> samples, const Free& free,
                                    std::size_t& first) const;

  /// What was found of reach() along the directions that were asked for.
  struct Reaches;

  const PartModel& model_;
  ExactQuery query_;
  std::shared_ptr<Reaches> reaches_;
  double sine_;  // of tau
  const Progress* progress_;
};

/// How far samples are free along one pull: what takes many rays is found once, when it is first asked for.
class FreeLengths {
 public:
  /// All must outlive it; lifters that it goes with move along this pull.
  FreeLengths(const Release& release, std::span<const UndercutSample> samples, const glm::dvec3& pull)
      : release_(release), samples_(samples), pull_(pull), known_(samples.size(), k_unknown) {}

  [[nodiscard]] std::span<const UndercutSample> samples() const { return samples_; }
  /// Negative where it is not known yet, or for another sample.
  [[nodiscard]] double known(const UndercutSample& sample) const {
    const std::size_t place = place_of(sample);
    return place < known_.size() ? known_[place] : k_unknown;
  }
  [[nodiscard]] double of(const UndercutSample& sample);
  /// The place of a sample that stayed behind for some length.
  [[nodiscard]] std::size_t& first_blocked() { return first_blocked_; }

 private:
  static constexpr double k_unknown = -1.0;
  [[nodiscard]] std::size_t place_of(const UndercutSample& sample) const {
    const std::less<> before;
    const UndercutSample* const first = samples_.data();
    if (before(&sample, first) || !before(&sample, first + samples_.size())) return samples_.size();
    return static_cast<std::size_t>(&sample - first);
  }

  const Release& release_;
  std::span<const UndercutSample> samples_;
  glm::dvec3 pull_;
  std::vector<double> known_;
  std::size_t first_blocked_ = samples_.size();
};

/// `direction` turned about `axis`, both unit.
[[nodiscard]] glm::dvec3 turned_about(const glm::dvec3& direction, const glm::dvec3& axis, double angle_deg);

}  // namespace moldlight
