// Which facets a half is to form because a hand gave them to it.
#pragma once

#include <cstdint>
#include <vector>

#include "classify/part_model.hpp"
#include "parting/mold_settings.hpp"

namespace moldlight {

enum class FacetWish : std::uint8_t { none, core, cavity };

/// One a facet, from the settings' cosmetic faces. Throws UsageError for faces that the part has not.
[[nodiscard]] std::vector<FacetWish> assigned_facets(const PartModel& model, const MoldSettings& settings);

}  // namespace moldlight
