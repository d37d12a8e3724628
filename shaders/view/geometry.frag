#version 330 core
// Facet and smooth normal of the visible fragment. BY_REGION: only fragments of the regions in u_regions are drawn.
#ifdef BY_REGION
#include "view/smoothed_region.glsl"
uniform uint u_regions;  // bit k: accessibility bits k are drawn
in vec3 v_position;
#endif
#include "view/surface_bits.glsl"
in vec3 v_normal;
layout(location = 0) out uvec2 o_surface;

void main() {
  uint facet = uint(gl_PrimitiveID);
  uint bits = 0u;
#ifdef BY_REGION
  bits = smoothed_region(v_position, facet);
  if ((u_regions >> bits & 1u) == 0u) discard;
#endif
  o_surface = surface_bits(facet, gl_FrontFacing, v_normal, bits);
}
