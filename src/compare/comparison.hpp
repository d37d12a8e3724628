// Two revisions of a part, compared for the mold: what of the surface is new or gone, and what that does to
// the regions.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "classify/classification.hpp"
#include "classify/json.hpp"
#include "classify/option.hpp"
#include "compare/alignment.hpp"
#include "compare/mold_change.hpp"
#include "compare/surface_change.hpp"
#include "compare/undercut_change.hpp"
#include "study/verdict.hpp"

namespace moldlight {

struct CompareSettings {
  bool align = false;        // B is turned and moved onto A; else the parts are compared as they lie
  bool with_actions = true;  // undercuts one by one, and their side actions
  bool with_mold = false;    // what becomes of the mold of A, where both parts have one direction
  ActionSettings actions;
  double same_within =
      0.0;  // surface that is no farther apart is the same, in A's unit; 0: 1e-4 of A's diagonal

  bool operator==(const CompareSettings&) const = default;
};
[[nodiscard]] std::span<const Option<CompareSettings>> compare_options();

/// Which parting direction each part has: the same, or of each its best.
struct ComparedQuery {
  Direction a, b;
  MethodSettings method;
};

struct ComparedPart {
  std::shared_ptr<const PartModel> model;
  Classification result;           // with its split mesh
  std::optional<ActionPlan> plan;  // where it was asked for
  std::optional<Verdict> verdict;  // with the plan
};

/// What becomes of the mold of A. Volumes and lengths are in A's unit.
struct MoldChange {
  std::vector<PlaceSteel> places;  // of the surface's
  MeasuredVolume to_cut, to_add;
  LineChange line;
};

/// Lengths and areas are in A's unit.
struct Comparison {
  ComparedPart a, b;
  CompareSettings settings;
  std::optional<Alignment> alignment;  // of B, where it was asked for
  std::optional<UniformScale> scale;   // of B, where surface changed
  SurfaceChange surface;
  std::vector<MatchedChange> undercuts, actions;  // none without plans
  std::optional<MoldChange> mold;                 // where it was asked for and both parts are closed
  std::vector<std::string> remarks;               // a sentence each
};

/// Reads nothing more of the parts: B in A's unit and, where the settings ask for it, where it lies on A.
/// Directions are asked of what is compared, since B may be turned. Throws UsageError for a tolerance greater
/// than the part, Cancelled.
[[nodiscard]] Comparison prepare_comparison(const std::shared_ptr<const PartModel>& a,
                                            const std::shared_ptr<const PartModel>& b,
                                            const CompareSettings& settings, const Progress& progress);

/// Fills in what changed. The same to the bit for any number of threads. Throws Cancelled.
void compare_parts(Comparison& comparison, const ComparedQuery& query, const Progress& progress);

/// Along which direction each part is looked at: one that is given, the best of A, or of each its own best.
enum class CompareDirection : std::uint8_t { given, best, each };
struct CompareQuestion {
  CompareDirection choice = CompareDirection::best;
  Direction direction = {};  // where it is given; the mold of A is looked at then, too
  MethodSettings method = {};
  CompareSettings settings = {};
};
/// Both of these for a question.
[[nodiscard]] Comparison compare_revisions(const std::shared_ptr<const PartModel>& a,
                                           const std::shared_ptr<const PartModel>& b,
                                           const CompareQuestion& question, const Progress& progress);

/// "core", "slide 1": who has steel that is cut, in A's mold, or that is added.
[[nodiscard]] std::string steel_owner_text(const Comparison& comparison, const SteelOwner& owner);
/// Of all that have some, "core and slide 1".
[[nodiscard]] std::string steel_of_text(const Comparison& comparison, const SteelChange& steel);
/// Whether the mold of A survives: "Steel is cut at 3 places. Steel is added at 1 place: 12.4 mm³ at (1, 2,
/// 3) mm, cavity."
[[nodiscard]] std::string mold_change_text(const Comparison& comparison, const MoldChange& mold);
/// What changed, in a sentence or two.
[[nodiscard]] std::string comparison_verdict(const Comparison& comparison);

/// Schema `moldlight.compare/1`. Lengths and areas are in A's unit.
[[nodiscard]] Json compare_json(const Comparison& comparison);

}  // namespace moldlight
