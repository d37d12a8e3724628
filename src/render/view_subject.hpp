// What a picture shows: a part, a parting direction, and what tells the part's regions.
#pragma once

#include <glm/vec3.hpp>

#include "render/part_buffers.hpp"
#include "render/shadow_maps.hpp"
#include "render/view_mesh.hpp"

namespace moldlight {

/// A plain picture needs neither maps nor a split surface, any other at least one of them; to mark their
/// difference takes both. What is pointed at must live as long as a picture is drawn.
struct ViewSubject {
  const PartBuffers& part;              // with the direction's facet classes
  glm::dvec3 direction{0.0, 0.0, 1.0};  // unit
  const ShadowMaps* maps = nullptr;     // drawn from `part` for the direction
  const SplitSurface* split = nullptr;  // of the part for the direction
};

}  // namespace moldlight
