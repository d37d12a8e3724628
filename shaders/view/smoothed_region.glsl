// Regions for pictures: the look-up is shifted by a part of a texel that differs from sample to sample, so that the
// steps of the maps' texels become smooth. Near-vertical surface is shifted along its wall alone: across it, the
// look-up would fall into the solid.
#include "common/region.glsl"
uniform vec2 u_map_shift;  // texels, [-0.5, 0.5]

uint smoothed_region(vec3 point, uint facet) {
  vec2 shift = u_map_shift;
  if (facet_class(facet) == k_near_vertical) {
    vec3 normal = facet_plane(facet).xyz;
    vec2 across = normalize(vec2(dot(normal, u_map_x), dot(normal, u_map_y)));
    shift -= dot(shift, across) * across;
  }
  return accessible_at(point, facet, shift);
}
