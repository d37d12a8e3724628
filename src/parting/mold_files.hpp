// The files of a mold's halves. What is written was tested as it is written, in single precision.
#pragma once

#include <string>
#include <vector>

#include "io/step_labels.hpp"
#include "parting/mold_halves.hpp"

namespace moldlight {

/// The bodies as files have them; make_halves() keeps those of its halves.
[[nodiscard]] WrittenMold written_mold(const MoldHalves& halves);

/// Whether a half as it is written hides some of its own surface from its pull: more than a millionth of it,
/// by more than rounding. Throws Cancelled.
[[nodiscard]] bool hides_itself(const MoldHalves& halves, const Progress& progress);

/// Facets with a smaller height, as a share of the part's diagonal, are needles.
inline constexpr double k_needle = 1e-7;

/// Moves what crosses by rounding in a written body (0 core, 1 cavity, then the inserts) apart, where that
/// makes no facets thinner than `thinnest`; says of the body what still crosses. Returns how many facets no
/// longer do. Throws Cancelled.
std::size_t mend_crossed(MoldHalves& halves, std::size_t body, double thinnest, const Progress& progress);

/// Puts a body in the place of another (numbered likewise), or behind the last insert, as it will be written.
/// What a half was found to have of undercut stays said of it. False, and nothing changed, where it would not
/// be closed or would cross itself. Throws Cancelled.
[[nodiscard]] bool put_body(MoldHalves& halves, std::size_t number, MoldBody body, double thinnest,
                            const Progress& progress);

/// Slides, lifters, inserts, each as they were; inserts are numbered anew.
void set_in_order(MoldHalves& halves);

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
