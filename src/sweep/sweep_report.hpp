// The report on a sweep: a table for people, JSON and a table of every direction for programs.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "classify/part_model.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// Schema `moldlight.sweep/3`. Lengths and areas are in the part's unit, angles in degrees. A candidate's
/// figures are those of classify_json() under the same keys. Only `elapsed_s` differs from run to run, and
/// nothing with the number of threads.
[[nodiscard]] nlohmann::ordered_json sweep_json(const PartModel& model, const SweepResult& result);

/// Writes `x,y,z,kind,undercut,undercut_error,given_up`, a line for every scored direction in the order of
/// scoring, every number in the shortest form that reads back the same; whole or not at all. Throws FileError
/// where it cannot be written.
void write_direction_csv(const std::string& path, const SweepResult& result);

}  // namespace moldlight
