// The fewest directions that release a part's surface: a cover of samples whose exact left-over surface gives
// further samples, until both agree.
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "mold/exact/exact_regions.hpp"
#include "pieces/left_surface.hpp"
#include "pieces/pieces_settings.hpp"
#include "pieces/pull_lines.hpp"

namespace moldlight {

/// A sample of the surface, and whether any candidate releases it.
struct JudgedSample {
  SurfaceSample sample;
  bool reachable = false;
};

struct ChosenDirections {
  std::vector<PullLine> directions;   // fixed ones first, then an opposite pair, if there is one
  std::vector<LeftPolygon> left;      // exact
  std::vector<JudgedSample> samples;  // even over the surface
  double left_area = 0.0;             // model units squared
  double unreachable_area = 0.0;      // of it, what no candidate releases; by samples
  bool releases_all = false;          // all but eps of the surface
  bool enough = false;                // all but eps of what any candidate releases is released
  bool optimal = false;               // no fewer candidates do; false also where the search was given up
};

/// Of covers with as few directions as possible the first that there is of: lines that are named alone, then
/// with features, then all; of each with an opposite pair before others. Of pairs the one that leaves least,
/// then the one along which the part is least deep. Where more than `settings.most` would be needed, the
/// directions that release most one after the other. Throws Cancelled.
[[nodiscard]] ChosenDirections choose_directions(const PartModel& model, const ExactQuery& query,
                                                 const PiecesSettings& settings, const Progress& progress);

}  // namespace moldlight
