// The pulls that release one undercut: straight ones, lifters, and several that share it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "actions/pull_candidates.hpp"
#include "actions/release.hpp"
#include "actions/side_action.hpp"

namespace moldlight {

/// A direction that releases an undercut, or what one of its samples stands for.
struct Pull {
  ActionKind kind = ActionKind::slide;
  glm::dvec3 direction{1, 0, 0};  // unit
  PullSource source = PullSource::even;
  TurnInterval interval = {};
  double travel = 0.0;  // share of the diagonal, without clearance
  bool core_side = true;
  std::optional<Revolution> about = {};
  bool for_sharing = false;  // not the best for this undercut alone
  bool kept = false;         // not to be moved to the middle of what is free
  bool has_room = true;      // of a lifter: as much beyond its travel as the settings ask for
};

/// The weight of its kind; of equal ones the shorter is cheaper, then the one that leaves more room to turn.
/// A lifter that lacks room is dearer than whatever else may be pulled.
[[nodiscard]] double pull_cost(const Pull& pull);

/// What a pull frees of an undercut that none frees whole; the last part is what no pull frees, if there is
/// more of it than may stay blocked, and has none.
struct FreedPart {
  std::vector<UndercutSample> samples;
  std::vector<Pull> pulls;
};

class PullFinder {
 public:
  PullFinder(const PartModel& model, const ExactQuery& query, const ActionSettings& settings,
             const Progress& progress)
      : direction_(query.direction),
        settings_(settings),
        lifter_room_(settings.lifter_room_mm * unit_per_mm(model.part) / model.frame.diagonal),
        release_(model, query, &progress) {}

  [[nodiscard]] const Release& release() const { return release_; }
  /// The parting direction.
  [[nodiscard]] const glm::dvec3& direction() const { return direction_; }
  /// What a lifter needs beyond its travel, share of the diagonal.
  [[nodiscard]] double lifter_room() const { return lifter_room_; }

  /// Slides; where there is none, such as lean; where there is none either, inclined ones; at last lifters,
  /// those with room before the others. Or those of a kind alone.
  [[nodiscard]] std::vector<Pull> find(std::span<const UndercutSample> samples,
                                       std::span<const PullCandidate> tried,
                                       std::optional<ActionKind> only = {}) const;
  /// The slides among the pulls turned toward either end of what is free, if that is wide, and those that
  /// were for sharing alone.
  [[nodiscard]] std::vector<Pull> turned(std::span<const UndercutSample> samples,
                                         std::span<const Pull> pulls) const;
  /// One pull after another, each of which frees most of the rest; all of them of a kind where one is given.
  /// Lifters have room, unless such as have none free more, or as much for less altogether.
  [[nodiscard]] std::vector<FreedPart> split(std::span<const UndercutSample> samples,
                                             std::span<const PullCandidate> tried,
                                             std::optional<ActionKind> only = {}) const;

  /// Loose inserts, one after another, each of which frees most of the rest: to infinity along any of the
  /// directions, since the part has left the mold with it; none for less than a twentieth of `whole_area`,
  /// the undercut's. The last is what none frees, as of split().
  [[nodiscard]] std::vector<FreedPart> find_inserts(std::span<const UndercutSample> samples,
                                                    std::span<const PullCandidate> tried,
                                                    double whole_area) const;

  /// A direction that releases the samples, moved to the middle of what is free, unless the part says better:
  /// an axis is kept unless it lies near an end, and where much is free, that direction of the part's own
  /// shape among it and `others` is taken that is farthest from the ends, if it is far enough; a wish is kept
  /// as it is. The ends are found to `resolved_deg`.
  [[nodiscard]] Pull in_the_middle(std::span<const UndercutSample> samples, const PullCandidate& candidate,
                                   ActionKind kind, double resolved_deg,
                                   std::span<const PullCandidate> others = {}) const;
  /// The travel beyond which the part passes, on the side on which it is shorter; to a step of so much.
  void set_travel(std::span<const UndercutSample> samples, double step, Pull& pull) const;
  /// The same from few samples and by coarse steps.
  void estimate_travel(std::span<const UndercutSample> samples, Pull& pull) const;

 private:
  [[nodiscard]] std::vector<Pull> find_lifters(std::span<const UndercutSample> samples,
                                               std::span<const PullCandidate> tried) const;
  void set_room(std::span<const UndercutSample> samples, Pull& lifter) const;
  /// The lifter that clears most of the samples with so much room, more than `least` of their area; none
  /// where there is none. Its travel is one at which it does.
  [[nodiscard]] std::optional<Pull> most_clearing(std::span<const UndercutSample> samples,
                                                  std::span<const PullCandidate> tried, double least,
                                                  double room) const;
  /// Lifters have so much room.
  [[nodiscard]] std::vector<FreedPart> split_with(std::span<const UndercutSample> samples,
                                                  std::span<const PullCandidate> tried,
                                                  std::optional<ActionKind> only, double room) const;
  /// The slide that frees most, more than `most`, which becomes the area that it frees; none where there is
  /// none.
  [[nodiscard]] std::optional<Pull> most_freeing(std::span<const UndercutSample> samples,
                                                 std::span<const PullCandidate> tried,
                                                 std::optional<ActionKind> only, double& most) const;
  [[nodiscard]] bool is_known(const std::vector<Pull>& pulls, const glm::dvec3& pull) const;

  glm::dvec3 direction_;
  const ActionSettings& settings_;
  double lifter_room_;
  Release release_;
};

}  // namespace moldlight
