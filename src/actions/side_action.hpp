// The side actions that release a part's undercuts.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/action_kind.hpp"
#include "actions/action_settings.hpp"
#include "actions/core_pin.hpp"
#include "actions/release.hpp"
#include "actions/stem.hpp"
#include "actions/undercut.hpp"
#include "classify/classification.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Of a thread or a ring. Lengths are in the part's unit.
struct Revolution {
  glm::dvec3 point{0.0}, direction{0, 0, 1};  // of the axis; unit
  double pitch = 0.0, turns = 0.0;  // of a thread: for a whole turn, left-handed ones negative; 0 for a ring
  double strain = 0.0;              // of a ring: share by which the part is stretched
};

/// Why an action that would release an undercut cannot be built. No room: the part is in the way of the
/// lifter's own thickness beyond its travel. No way out: that thickness cannot leave along its half after its
/// travel. No stem: there is no place for what it stands on. Too far: ejectors do not drive it so far. Thin
/// pin: what would form a hole breaks. Its body hits the part, or another action's. The rest of its undercut
/// keeps the part in the mold. Too strained: to be stripped off, the part would stretch by more than is
/// permitted.
enum class RejectReason : std::uint8_t {
  no_room,
  no_way_out,
  no_stem,
  too_far,
  thin_pin,
  hits_part,
  hits_body,
  leaves_rest,
  too_strained,
  too_steep
};
/// "no room for its thickness", …
[[nodiscard]] std::string_view reject_text(RejectReason reason);

/// Where an action's body hits: where the mold is closed, as it moves, or as the part then leaves its half.
enum class HitStage : std::uint8_t { rest, way, way_out };
/// "at rest", …
[[nodiscard]] std::string_view stage_text(HitStage stage);

/// The deepest point of a body in something solid.
struct BodyHit {
  std::optional<std::size_t> action;  // whose body it is in; the part where there is none
  double depth = 0.0;
  glm::dvec3 place{0.0};  // of the point where the mold is closed
  HitStage stage = HitStage::rest;
};

/// Of the closed solid that an action moves, in the part's unit.
struct BodyFigures {
  std::shared_ptr<const TriangleMesh> solid;  // not null
  double volume = 0.0;
  double least_section = 0.0;       // across its way, where greatest, of its thinnest piece
  std::optional<BodyHit> hit = {};  // none where it is nowhere deeper than twice the lateral tolerance
};

/// Lengths and areas are in the part's unit.
struct SideAction {
  ActionKind kind = ActionKind::slide;
  glm::dvec3 direction{1, 0, 0};  // unit
  TurnInterval interval;  // to which the direction may turn about the parting direction; of a lifter if it
                          // may travel a tenth more
  double travel = 0.0;    // with the clearance, for what moves straight
  std::optional<double> stroke;        // of the ejector, for a lifter
  std::optional<Revolution> about;     // of what is unscrewed or stripped
  std::vector<std::size_t> undercuts;  // numbers among the undercuts, rising
  double area = 0.0;                   // undercut area that it releases
  bool core_side = true;               // the half that it belongs to: the core's, along +d
  double clear_to =
      std::numeric_limits<double>::infinity();  // how far its surface could move until it hits the part
  double room_needed = 0.0;                     // of a lifter, beyond its travel
  std::vector<Stem> stems = {};                 // of a lifter, where it stands on any
  std::vector<std::size_t> meets = {};          // slides, or lifters, whose ways cross its own, rising
  std::string feature = {};                     // what it forms: "8 vents"
  std::optional<CorePin> core_pin = {};         // of its holes, the most slender
  std::optional<BodyFigures> body = {};         // of what has one, but in rough plans
};

/// Whether a lifter has the room that it needs beyond its travel; true of others. All of a plan have it.
[[nodiscard]] bool has_room(const SideAction& action);

/// Lengths are in the part's unit.
struct RejectedAction {
  std::size_t undercut = 0;  // number among the undercuts
  ActionKind kind = ActionKind::lifter;
  glm::dvec3 direction{1, 0, 0};  // unit
  double travel = 0.0;
  bool core_side = true;
  RejectReason reason = RejectReason::no_room;
  glm::dvec3 place{0.0};  // on the undercut, from where it fails; of a body that hits, its deepest point
  double room = 0.0;      // of a lifter: beyond the travel from there; what is needed is the lifter's
  double depth = 0.0;     // of a body that hits; by which a ring reaches beyond what it must pass
  HitStage when = HitStage::rest;  // of a body that hits
  double width = 0.0;              // of a thin pin
  double strain = 0.0;             // of a ring
  double lean_deg = 0.0;           // of a slide that leans too much, off the plane across the direction
  double left = 0.0;               // area of its undercut that nothing would release beside it
};

/// An undercut and what was found out about it.
struct UndercutReport {
  Undercut undercut;
  double formed_area = 0.0;     // with the surface beside it, up to creases, that the same action can form
  std::optional<double> depth;  // distance across d at which the part is clear; none if nothing releases it
  bool core_side = true;        // from which it is nearer
  std::vector<FacetIndex> formed;      // facets that the action forms with it, wholly, rising
  std::vector<FacetIndex> blocked_by;  // facets that hide it, the most frequent first
  glm::dvec3 point{0.0};               // on it, by which a pin finds it again
  bool closed_void = false;            // without an opening: no mold forms it
  std::optional<ActionPin> pin;
};

/// Of a piece that is no undercut, or was dropped; of an undercut one that nothing releases.
inline constexpr std::int32_t k_no_action_of_piece = -1, k_unreleased_piece = -2;

struct ActionPlan {
  std::vector<UndercutReport> undercuts;  // the largest first
  std::vector<Speck> specks;              // what counts as no undercut, the largest first
  std::vector<SideAction> actions;        // the largest area first
  /// Of each undercut that nothing else releases well the shortest lifter that fails, and what of each kind
  /// was not taken since its body hits or since it leaves the rest.
  std::vector<RejectedAction> rejected;
  std::vector<std::size_t> unreleased;        // undercuts that nothing releases, or not all of, rising
  std::vector<double> unreleased_areas;       // what of each of these is left
  double unreleased_area = 0.0;               // of all
  std::vector<std::int32_t> action_of_piece;  // of the split mesh; or one of the above
  bool optimal = true;  // no cheaper set of the actions that were found releases as much
};

/// What is found of a plan: for a rank among directions no more than what it comes to, without whether the
/// bodies are clear, how far lifters may turn, what the undercuts are blocked by and what forms them.
/// Roughly: from few samples, as if actions that meet did not.
enum class PlanDetail : std::uint8_t { whole, rank, rough };
/// `result` is a classification of the model that has its split mesh. The search ends, and the plan is what
/// it is then, once more undercut than `most_left` is left, an area. Throws Cancelled.
[[nodiscard]] ActionPlan find_actions(const PartModel& model, const Classification& result,
                                      const ActionSettings& settings, const Progress& progress,
                                      PlanDetail detail = PlanDetail::whole,
                                      double most_left = std::numeric_limits<double>::infinity());

/// The same in two steps, for who asks for more of a direction later: what is possible is found once, the set
/// that is chosen from it each time. All that it is made of must outlive it.
class ActionSearch {
 public:
  /// `roughly`: for plans of PlanDetail::rough alone.
  ActionSearch(const PartModel& model, const Classification& result, const ActionSettings& settings,
               const Progress& progress, bool roughly = false);
  ~ActionSearch();

  [[nodiscard]] const Undercuts& undercuts() const;
  [[nodiscard]] ActionPlan plan(PlanDetail detail,
                                double most_left = std::numeric_limits<double>::infinity());

 private:
  class Finder;
  std::unique_ptr<Finder> finder_;
};

/// What a plan comes to, without the list of its actions. Areas are in the part's unit squared.
struct ActionTotals {
  ActionCounts counts{};
  double unreleased_area = 0.0;
  std::size_t stuck = 0;    // undercuts of which more is left than is_stuck() allows
  double stuck_area = 0.0;  // what is left of these
};
/// `lateral` is the lateral tolerance in the part's unit.
[[nodiscard]] ActionTotals totals_of(const ActionPlan& plan, double lateral);
[[nodiscard]] UndercutTotals undercut_totals(const ActionPlan& plan);

/// Whether what is left of an undercut keeps the part in its mold: more than 0.5 % of its area, and more than
/// the lateral tolerance squared.
[[nodiscard]] bool is_stuck(double left, double area, double lateral);
/// Of specks that are no part of an undercut that counts.
[[nodiscard]] std::size_t speck_count(const ActionPlan& plan);
[[nodiscard]] double speck_area(const ActionPlan& plan);

/// "2 slides, 1 lifter"; "none" where nothing is needed.
[[nodiscard]] std::string actions_text(const ActionCounts& counts);
[[nodiscard]] std::string actions_text(const ActionPlan& plan);

/// The action that releases an undercut, or the largest part of it; null for none.
[[nodiscard]] const SideAction* action_of(const ActionPlan& plan, std::size_t undercut);
/// "slide 1", numbered by the plan from 1.
[[nodiscard]] std::string action_title(const ActionPlan& plan, std::size_t action);
/// What releases an undercut: "slide 1", "slide 1 and lifter 3, in part"; else unreleased_text().
[[nodiscard]] std::string released_by_text(const ActionPlan& plan, std::size_t undercut);
/// Why an undercut among the unreleased is left, or the rest of it: "no slide releases it", "left as it is",
/// …
[[nodiscard]] std::string unreleased_text(const ActionPlan& plan, std::size_t undercut);

}  // namespace moldlight
