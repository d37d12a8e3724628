// The pictures of a sweep: the map of the directions and a sheet with the best of them.
#pragma once

#include <memory>
#include <string>

#include "base/image.hpp"
#include "base/progress.hpp"
#include "classify/still_picture.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

inline constexpr const char* k_sphere_picture = "direction_sphere.png";
inline constexpr const char* k_contact_sheet = "contact_sheet.png";

/// Undercut area over the half-sphere, interpolated from every direction that was scored, with the listed
/// directions marked. Only size and theme of the settings count.
[[nodiscard]] Image sweep_sphere_picture(const PartModel& model, const SweepResult& result,
                                         const StillSettings& settings);

/// The part's regions for each of the best directions, 12 at most, with their figures. View, look
/// and regions of the settings count, and the scale that their size stands for; 1600 by 1000 is scale 1.
/// Every tile wants its regions computed, which takes a second for millions of facets. Throws Cancelled.
[[nodiscard]] Image sweep_contact_sheet(const gl::Context& context, std::shared_ptr<const PartModel> model,
                                        const SweepResult& result, const StillSettings& settings,
                                        const Progress& progress);

/// Draws both and writes them to the folder, which is made where there is none; each file is replaced whole
/// or not at all. Once cancelled it draws the map alone, which is soon done, and returns false. Throws
/// FileError.
[[nodiscard]] bool write_sweep_pictures(const std::string& folder, const gl::Context& context,
                                        std::shared_ptr<const PartModel> model, const SweepResult& result,
                                        const StillSettings& settings, const Progress& progress);

}  // namespace moldlight
