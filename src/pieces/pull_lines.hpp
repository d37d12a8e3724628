// The lines along which pieces of a mold may be pulled, each in both senses.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "pieces/pieces_settings.hpp"

namespace moldlight {

/// How much a toolmaker likes a line: one that is given or that the shape of the part names; one that
/// features speak for; one at a round angle between those; any other.
enum class LineLiking : std::uint8_t { named, feature, round, other };
inline constexpr int k_line_likings = 4;

struct PullLine {
  glm::dvec3 direction{0, 0, 1};  // unit
  std::string name;  // why it is tried: "z", "axis of 4 cylinders or cones, 3.1 % of the surface"
  LineLiking liking = LineLiking::other;
};

/// Fixed directions first, in their order and sense, then those proposed, then canonical ones, those of the
/// sweep's sources (sweep/candidates), edges, which are the crosses of neighbouring normals, lines at every
/// 15 degrees between canonical lines, and an even set. Throws UsageError for a direction of no
/// length, Cancelled.
[[nodiscard]] std::vector<PullLine> pull_lines(const PartModel& model, const PiecesSettings& settings,
                                               const Progress& progress);

}  // namespace moldlight
