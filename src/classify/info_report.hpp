// The health report of a part, for people and for programs: what is wrong, where, how large.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "classify/json.hpp"
#include "classify/part_model.hpp"
#include "mesh/health.hpp"

namespace moldlight {

/// The places of a part's defects; what the health report counts.
struct DefectPlaces {
  std::vector<EdgeChain> open, nonmanifold, inconsistent;  // the longest first
  std::vector<std::int64_t> degenerate_facets;  // numbers in the file, rising; -1: added by a repair
};
[[nodiscard]] DefectPlaces defect_places(const PartModel& model);

/// Schema `moldlight.info/1`. Lists of places stop after 1000 entries; the counts beside them do not.
[[nodiscard]] Json info_json(const PartModel& model, const DefectPlaces& places);

/// Lists the ten longest chains of a kind.
[[nodiscard]] std::string info_text(const PartModel& model, const DefectPlaces& places);

}  // namespace moldlight
