// The files of a mold's halves. What is written was tested as it is written, in single precision.
#pragma once

#include <string>
#include <vector>

#include "io/step_labels.hpp"
#include "parting/mold_halves.hpp"

namespace moldlight {

/// The bodies as files have them; make_halves() keeps those of its halves.
[[nodiscard]] WrittenMold written_mold(const MoldHalves& halves);

/// Moves what crosses by rounding in the written core (0) or cavity (1) apart, where that can be done. Throws
/// Cancelled.
[[nodiscard]] std::vector<FacetIndex> uncross_written(MoldHalves& halves, std::size_t half,
                                                      std::vector<FacetIndex> crossed,
                                                      const Progress& progress);

/// Where in the part's coordinates, without the shrinkage, a point of the files is.
[[nodiscard]] glm::dvec3 place_in_part(const MoldHalves& halves, const WrittenMold& mold,
                                       const glm::dvec3& at);

/// Files with all bodies, beside one for each: mold.3mf; mold.step, with the parting surface, too.
struct MoldFileSettings {
  bool as_3mf = false, as_step = false;
};

/// Writes each body to <folder>/<name>.stl, making the folder, and the files with all of them. Slides,
/// inserts and pieces of a former run that are no more go. Throws FileError.
void write_mold(const std::string& folder, const MoldFileSettings& settings, const std::string& unit,
                WrittenMold& mold);

/// The surface between the halves, around the part and in its openings, beside a part that is written as
/// STEP: what hangs together, the largest first.
[[nodiscard]] std::vector<StepSurface> parting_surfaces(const PartModel& model, const MoldHalves& halves);

}  // namespace moldlight
