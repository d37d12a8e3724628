// The pictures of a sweep: the map of the directions and a sheet with the best of them.
#pragma once

#include <string>

#include "base/image.hpp"
#include "gl/context.hpp"
#include "session/classifier.hpp"
#include "session/still_picture.hpp"
#include "session/sweep/sweep_result.hpp"

namespace moldlight {

inline constexpr const char* k_sphere_picture = "direction_sphere.png";
inline constexpr const char* k_contact_sheet = "contact_sheet.png";

/// Undercut area over the half-sphere, interpolated from every direction that was scored, with the listed
/// directions marked. Only size and theme of the settings count.
[[nodiscard]] Image sweep_sphere_picture(const PartModel& model, const SweepResult& result,
                                         const StillSettings& settings);

/// The part's regions for each of the best directions, 12 at most, with their figures. View, theme and
/// palette of the settings count, and the scale that their size stands for; 1600 by 1000 is scale 1.
/// `context` is the classifier's and current. Asks for nothing to be cancelled: what is done is to be seen.
[[nodiscard]] Image sweep_contact_sheet(const gl::Context& context, Classifier& classifier,
                                        const SweepResult& result, const StillSettings& settings);

/// Draws both and writes them to the folder, which is made where there is none; each file is replaced whole
/// or not at all. Throws FileError.
void write_sweep_pictures(const std::string& folder, const gl::Context& context, Classifier& classifier,
                          const SweepResult& result, const StillSettings& settings);

}  // namespace moldlight
