// The pulls that release one undercut: straight ones, lifters, and several that share it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <glm/trigonometric.hpp>

#include "actions/pull_candidates.hpp"
#include "actions/release.hpp"
#include "actions/side_action.hpp"
#include "actions/stem.hpp"

namespace moldlight {

/// Sine of the draft below which a wall opens towards neither of two opposite slides.
inline constexpr double k_upright = 1e-3;

/// Of turns that are compared; what is chosen is found anew.
inline constexpr double k_compared_turn_deg = 0.01;
/// Pulls whose elevations differ by less rise as much.
inline constexpr double k_same_elevation_deg = 0.01;
/// Cosine of the angle within which two pulls are one.
inline constexpr double k_same_pull = 1.0 - 1e-9;

/// A direction that releases an undercut, or what one of its samples stands for.
struct Pull {
  ActionKind kind = ActionKind::slide;
  glm::dvec3 direction{1, 0, 0};  // unit
  PullSource source = PullSource::even;
  TurnInterval interval = {};
  double travel = 0.0;  // share of the diagonal, without clearance
  double way = 0.0;     // of a slide: from its undercut out to where the part ends, in the mean, likewise
  bool across = false;  // of a slide: it goes across the part, where a short lifter would do
  bool core_side = true;
  std::optional<Revolution> about = {};
  bool for_sharing = false;  // not the best for this undercut alone
  bool kept = false;         // not to be moved to the middle of what is free
  bool beside_axis = false;  // an axis of the part is near, along which it is released, too
  /// Of a lifter that cannot be built.
  struct Lack {
    RejectReason reason = RejectReason::no_room;
    UndercutSample at = {};  // that lacks most
    double room = 0.0;       // beyond the travel, share of the diagonal
  };
  std::optional<Lack> lack = {};
};

/// The price of its kind, of a ring with its strain, of a slide across the part with what a lifter may cost
/// more; of equal ones that with the shorter way out is cheaper,
/// then the shorter travel, then the one that leaves more room to turn. Differences of rounding are none.
[[nodiscard]] double pull_cost(const Pull& pull, const ActionPrices& prices);

/// What a pull frees of an undercut that none frees whole; the last part is what no pull frees, if there is
/// more of it than may stay blocked, and has none.
struct FreedPart {
  std::vector<UndercutSample> samples;
  std::vector<Pull> pulls;
};

class PullFinder {
 public:
  PullFinder(const PartModel& model, const ExactQuery& query, const PartAxes& axes,
             const ActionSettings& settings, const Progress& progress)
      : axes_(axes),
        direction_(query.direction),
        settings_(settings),
        tau_deg_(query.tau_deg),
        lifter_room_(settings.lifter_room_mm * unit_per_mm(model.part) / model.frame.diagonal),
        stem_{.width = settings.lifter_section_mm * unit_per_mm(model.part) / model.frame.diagonal,
              .angle_deg = settings.lifter_angle_deg},
        longest_lifter_(
            std::tan(glm::radians(settings.lifter_angle_deg)) *
            std::max(k_longest_stroke, k_longest_stroke_mm * unit_per_mm(model.part) / model.frame.diagonal)),
        least_travel_(least_depth(model, query, settings.least_travel_mm)),
        release_(model, query, &progress) {
    for (const glm::dvec3& axis : {axes.x, axes.y, axes.z})
      for (const glm::dvec3& side : {axis, -axis}) sides_.push_back({side, release_.reach(side)});
  }

  [[nodiscard]] const Release& release() const { return release_; }
  /// The parting direction.
  [[nodiscard]] const glm::dvec3& direction() const { return direction_; }
  /// What a lifter needs beyond its travel, share of the diagonal.
  [[nodiscard]] double lifter_room() const { return lifter_room_; }
  /// Of a lifter that clears these samples; none where it has no place, or none is asked for.
  [[nodiscard]] std::optional<Stem> stem_of(std::span<const UndercutSample> samples,
                                            const LifterWay& way) const {
    FreeLengths lengths(release_, samples, way.pull);
    return stem_.width > 0.0 ? find_stem(release_, lengths, way, stem_) : std::nullopt;
  }
  /// Whether lifters stand on stems.
  [[nodiscard]] bool asks_for_stems() const { return stem_.width > 0.0; }
  /// Whether it is clear by a shorter way than any lifter's.
  [[nodiscard]] bool is_shallow(const UndercutSample& sample) const {
    return release_.is_shallow(sample, least_travel_);
  }

  /// Slides; where there is none, such as lean; where there is none either, inclined ones; at last lifters,
  /// also such as cannot be built. Or those of a kind alone.
  [[nodiscard]] std::vector<Pull> find(std::span<const UndercutSample> samples,
                                       std::span<const PullCandidate> tried,
                                       std::optional<ActionKind> only = {}) const;
  /// The way of a slide that frees nearly all of the samples; the others would be clear by a move across it
  /// of no more than the least travel. None where there is none.
  [[nodiscard]] std::optional<glm::dvec3> nearly_freeing(std::span<const UndercutSample> samples,
                                                         std::span<const PullCandidate> tried) const;
  /// The slides among the pulls turned toward either end of what is free, if that is wide, and those that
  /// were for sharing alone.
  [[nodiscard]] std::vector<Pull> turned(std::span<const UndercutSample> samples,
                                         std::span<const Pull> pulls) const;
  /// Two opposite slides; or one pull after another, each of which frees most of the rest; all of them of a
  /// kind where one is given.
  [[nodiscard]] std::vector<FreedPart> split(std::span<const UndercutSample> samples,
                                             std::span<const PullCandidate> tried,
                                             std::optional<ActionKind> only = {}) const;

  /// Loose inserts, one after another, each of which frees most of the rest: to infinity along any of the
  /// directions, since the part has left the mold with it; none for less than a twentieth of `whole_area`,
  /// the undercut's. The last is what none frees, as of split().
  [[nodiscard]] std::vector<FreedPart> find_inserts(std::span<const UndercutSample> samples,
                                                    std::span<const PullCandidate> tried,
                                                    double whole_area) const;

  /// A direction that releases the samples, moved to the best meant one of those that are free, itself and
  /// `others` among them: the axis of a round wall, then where the part's walls face, its axes first, where
  /// much is free also what planes of the undercut say; of equal ones that which is farthest from the ends.
  /// Where all of them lie near an end the middle is taken. A wish is kept as it is. The ends are found to
  /// `resolved_deg`.
  [[nodiscard]] Pull in_the_middle(std::span<const UndercutSample> samples, const PullCandidate& candidate,
                                   ActionKind kind, double resolved_deg,
                                   std::span<const PullCandidate> others = {}) const;
  /// The pull along an axis of the part instead, if one across the parting direction is within 2 degrees and
  /// releases the samples, too: nobody builds a slide that leans by less but where it has to.
  [[nodiscard]] std::optional<Pull> on_part_axis(std::span<const UndercutSample> samples,
                                                 const Pull& pull) const;
  /// Likewise along an axis of the file, within 0.1 degrees; the pull itself where none is.
  [[nodiscard]] Pull on_file_axis(std::span<const UndercutSample> samples, const Pull& pull) const;
  /// The travel beyond which the part passes, on the side on which it is shorter, to a step of so much; and
  /// the way out.
  void set_travel(std::span<const UndercutSample> samples, double step, Pull& pull) const;
  /// The same from few samples and by coarse steps.
  void estimate_travel(std::span<const UndercutSample> samples, Pull& pull) const;

  /// Whether it is an axis of the part across the parting direction, which most of its walls face or stand
  /// along.
  [[nodiscard]] bool is_axis(const glm::dvec3& pull) const;
  /// Whether a pull that was found reaches it by turning about the parting direction.
  [[nodiscard]] bool is_known(const std::vector<Pull>& pulls, const glm::dvec3& pull) const;
  /// The lifter that clears these samples, too, some more than its own: with a travel of at most a fifth
  /// more; none where there is none, or none that can be built.
  [[nodiscard]] std::optional<Pull> shared_lifter(std::span<const UndercutSample> samples, Pull pull) const;

 private:
  [[nodiscard]] std::vector<Pull> find_lifters(std::span<const UndercutSample> samples,
                                               std::span<const PullCandidate> tried) const;
  [[nodiscard]] std::optional<PullCandidate> meant_within(const Pull& pull,
                                                          std::span<const PullCandidate> others) const;
  [[nodiscard]] std::optional<Pull> laid_on(std::span<const UndercutSample> samples, const Pull& pull,
                                            const glm::dvec3& axis, double near_deg) const;
  void set_lack(FreeLengths& lengths, Pull& lifter, bool with_stem = true) const;
  /// The lifter that clears most of the samples with its room, more than `least` of their area; none where
  /// there is none. Its travel is one at which it does.
  [[nodiscard]] std::optional<Pull> most_clearing(std::span<const UndercutSample> samples,
                                                  std::span<const PullCandidate> tried, double least) const;
  /// Two slides on one line, if they free all of it: of the first such line among the part's axes and those
  /// that are tried.
  [[nodiscard]] std::vector<FreedPart> opposite_slides(std::span<const UndercutSample> samples,
                                                       std::span<const PullCandidate> tried) const;
  /// The slide that frees most, more than `most`, which becomes the area that it frees; none where there is
  /// none.
  [[nodiscard]] std::optional<Pull> most_freeing(std::span<const UndercutSample> samples,
                                                 std::span<const PullCandidate> tried,
                                                 std::optional<ActionKind> only, double& most) const;
  /// From a point (unit frame) to where it leaves the block round the part.
  [[nodiscard]] double way_out(const glm::dvec3& from, const glm::dvec3& pull) const;
  /// Whether a slide leaves by the far side of the part, and has the part on both sides of it and above or
  /// below when it is halfway out.
  [[nodiscard]] bool goes_across(std::span<const UndercutSample> samples, const glm::dvec3& pull) const;
  /// Where all slides go across, beside short lifters, these are the better choice.
  void add_lifters_inside(std::span<const UndercutSample> samples, std::span<const PullCandidate> tried,
                          std::vector<Pull>& slides) const;

  const PartAxes& axes_;
  glm::dvec3 direction_;
  const ActionSettings& settings_;
  /// Of the ejectors that drive a lifter: share of the diagonal, and what machines have for any part.
  static constexpr double k_longest_stroke = 1.5, k_longest_stroke_mm = 150.0;

  double tau_deg_, lifter_room_;
  StemSettings stem_;
  double longest_lifter_, least_travel_;
  Release release_;
  struct Side {
    glm::dvec3 normal;
    double reach;
  };
  std::vector<Side> sides_;  // of the block round the part, unit frame
};

}  // namespace moldlight
