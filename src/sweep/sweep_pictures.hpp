// The pictures of a sweep: the map of the directions and a sheet with the best of them.
#pragma once

#include <memory>
#include <string>

#include "base/progress.hpp"
#include "classify/still_picture.hpp"
#include "picture/sphere_map.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

inline constexpr const char* k_sphere_picture = "direction_sphere.png";
inline constexpr const char* k_contact_sheet = "contact_sheet.png";

/// What the pictures are of, and the context that draws them.
struct PicturedSweep {
  const gl::Context& context;
  std::shared_ptr<const PartModel> model;
  const SweepResult& result;
};

/// Undercut area over the half-sphere, interpolated from every direction that was scored.
[[nodiscard]] UndercutField undercut_field(const SweepResult& result);

/// The same with the listed
/// directions marked. Only size and theme of the settings count.
[[nodiscard]] Image sweep_sphere_picture(const PartModel& model, const SweepResult& result,
                                         const StillSettings& settings);

/// Draws both and writes them to the folder, which is made where there is none; each file is replaced whole
/// or not at all. Once cancelled it draws the map alone, which is soon done, and returns false. Throws
/// FileError.
[[nodiscard]] bool write_sweep_pictures(const PicturedSweep& sweep, const StillSettings& settings,
                                        const std::string& folder, const Progress& progress);

}  // namespace moldlight
