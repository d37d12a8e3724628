// Looks surface points up in the maps of the scan converter: the twin of the one-sided look-up in
// shaders/common/region.glsl, to compare the two by.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/part_model.hpp"
#include "classify/settings.hpp"
#include "mold/draft.hpp"
#include "mold/map_frame.hpp"
#include "render/shadow_maps.hpp"

namespace moldlight::test {

/// The second-depth maps of a direction, scan converted with the query's settings.
struct ScannedMaps {
  ScannedMaps(std::shared_ptr<const PartModel> of_model, const Query& query);

  /// Facet + 1, 0 where there is none or outside the maps.
  [[nodiscard]] std::uint32_t entry(bool plus, int x, int y) const;

  std::shared_ptr<const PartModel> model;
  MapFrame frame;
  int resolution;
  float lateral;  // unit frame
  std::vector<FacetClass> classes;
  std::array<std::vector<std::uint32_t>, 2> facets;  // -d first
};

/// Verdict bits (mold/measure.hpp) of a surface point in the unit frame.
[[nodiscard]] std::uint8_t accessible_from(const ScannedMaps& maps, const glm::vec3& point, FacetIndex facet);

}  // namespace moldlight::test
