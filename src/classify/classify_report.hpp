// The report on a classification: a table for people, JSON for programs.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "classify/classification.hpp"
#include "classify/part_model.hpp"
#include "mold/measure.hpp"

namespace moldlight {

/// [x, y, z].
[[nodiscard]] nlohmann::ordered_json point_json(const glm::dvec3& point);
/// {"min": [x, y, z], "max": [x, y, z]}.
[[nodiscard]] nlohmann::ordered_json bounds_json(const Bounds& bounds);

/// What every report says of the part; the warnings are the caller's, as a run may add to the part's own.
[[nodiscard]] nlohmann::ordered_json part_json(const PartModel& model,
                                               const std::vector<std::string>& warnings);

/// Schema `moldlight.classify/2`. Lengths and areas are in the part's unit, fractions in [0, 1], times in
/// milliseconds. For a STEP part `faces` lists the CAD faces, but not for a direction of a sweep.
[[nodiscard]] nlohmann::ordered_json classify_json(const PartModel& model, const Classification& result);

/// Region areas of each CAD face or polygon of the file; empty where each facet is its own, and for
/// a direction of a sweep.
[[nodiscard]] std::vector<SourceAreas> face_areas(const PartModel& model, const Classification& result);

/// The text of a JSON file: two spaces a level, numbers in the shortest form that reads back the same. Bytes
/// of file names that are no UTF-8 are replaced, and what a terminal would obey is escaped.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

}  // namespace moldlight
