// Which half forms what: every piece of a part's surface goes to core, cavity or side action, so that the
// line between the halves is short and level, by a minimum cut.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "classify/classification.hpp"
#include "classify/part_model.hpp"
#include "parting/mold_settings.hpp"
#include "parting/piece_edges.hpp"
#include "parting/seen_through.hpp"

namespace moldlight {

enum class MoldSide : std::uint8_t { core = 0, cavity = 1, action = 2 };
inline constexpr std::size_t k_side_count = 3;
inline constexpr std::array<MoldSide, k_side_count> k_mold_sides = {MoldSide::core, MoldSide::cavity,
                                                                    MoldSide::action};
/// "core", "cavity", "action".
[[nodiscard]] std::string_view side_name(MoldSide side);
/// Whose colour it is shown in: side actions form undercuts.
[[nodiscard]] constexpr Region region_of(MoldSide side) {
  return side == MoldSide::core ? Region::core : side == MoldSide::cavity ? Region::cavity : Region::undercut;
}

/// Lengths and areas are in the part's unit, heights along the direction in its coordinates. Energies are
/// lengths: that of the line, climbs counting four times and creases half, and what reverse draft and
/// distance from the height cost.
struct Assignment {
  SplitMesh mesh;  // of the regions at the soft draft, cut at the height that the user gave
  PieceEdges edges;
  std::vector<MoldSide> sides;          // one a piece
  std::vector<SeenPatch> seen_through;  // of halves, but an action's
  std::vector<std::uint8_t> free;       // 1 for a piece that may go to either half
  std::vector<std::uint8_t> crease;     // 1 for an edge that bends by more than 30 degrees
  glm::dvec3 direction{0, 0, 1};        // unit
  double height = 0.0;                  // at which the halves were assigned to meet
  double lateral = 0.0;                 // the lateral tolerance
  double energy = 0.0, energy_to_core = 0.0, energy_to_cavity = 0.0;  // of it, and of all that is free to one
  std::array<double, k_side_count> areas{};
  double free_area = 0.0;
  double reverse_draft_area = 0.0;  // of what a half forms although it leans the other way
  double total_area = 0.0;
  bool lineless = false;  // as of ExactSplit::has_lines(): nothing else is known then
  std::vector<std::string> warnings;

  [[nodiscard]] double area(MoldSide side) const { return areas[static_cast<std::size_t>(side)]; }
};

/// Throws UsageError for faces that the part has not and for a parting height outside of it, Cancelled.
[[nodiscard]] Assignment assign_sides(const PartModel& model, const Query& query,
                                      const MoldSettings& settings, const Progress& progress);

/// Whether what of a piece lies on the wrong side of a height for the one half that could form it is a hair,
/// no wider as seen along the direction than twice the lateral tolerance: a facet of a round wall whose
/// corners are not at that height.
[[nodiscard]] bool is_hair_beyond(const PartModel& model, const Assignment& assignment, PieceIndex piece,
                                  double height);

/// The same where the free walls of some facets are divided at a height, from an assignment without one. Its
/// energy is comparable with that one's. Throws Cancelled.
struct DividedWalls {
  double height = 0.0;
  bool hairs = false;                     // and what is a hair beyond it
  std::vector<std::uint8_t> facets = {};  // 1 for each whose walls are divided
};
[[nodiscard]] Assignment with_divided(const PartModel& model, const MoldSettings& settings,
                                      const Assignment& whole, const DividedWalls& walls,
                                      const Progress& progress);

/// Lengths of line by the height at which they run, to a ten-thousandth of the part's diagonal.
class LevelLengths {
 public:
  LevelLengths(const glm::dvec3& direction, double diagonal);

  /// Of a piece of line that is level.
  void add(const glm::dvec3& from, const glm::dvec3& to);
  /// The means of each, those of the greatest length first.
  [[nodiscard]] std::vector<double> heights() const;

 private:
  struct Level {
    double length = 0.0, moment = 0.0;
  };
  glm::dvec3 direction_;
  double step_;
  std::map<std::int64_t, Level> levels_;
};

/// Heights of the longest level creases at free pieces, the longest first; the part's middle where there are
/// none.
[[nodiscard]] std::vector<double> level_heights(const PartModel& model, const Assignment& assignment);

}  // namespace moldlight
