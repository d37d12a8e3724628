#version 330 core
// Facet, smooth normal and region of the visible fragment. SPLIT: triangles are pieces of facets, which know their
// region. LOOK_UP: the region comes from the shadow maps all the same. BY_REGION: only fragments of the regions in
// u_regions are drawn.
#ifdef SPLIT
uniform usamplerBuffer t_sources;  // per piece, see view/surface_bits.glsl
#endif
#ifdef LOOK_UP
#include "common/region.glsl"
in vec3 v_position;
#endif
#ifdef BY_REGION
uniform uint u_regions;  // bit k: accessibility bits k are drawn
#endif
#include "view/surface_bits.glsl"
in vec3 v_normal;
layout(location = 0) out uvec2 o_surface;

void main() {
  uint facet = uint(gl_PrimitiveID), exact = 0u;
#ifdef SPLIT
  uint source = texelFetch(t_sources, gl_PrimitiveID).r;
  facet = source_facet(source);
  exact = source_accessible(source);
#endif
  uint bits = exact;
#ifdef LOOK_UP
  bits = accessible_from(v_position, facet);
#endif
#ifdef BY_REGION
  if ((u_regions >> bits & 1u) == 0u) discard;
#endif
  o_surface = surface_bits(facet, gl_FrontFacing, v_normal, bits, exact);
}
