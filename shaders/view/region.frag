#version 330 core
// Classifies each visible fragment once: its accessibility bits. OPENED: the geometry pass knows them already.
#include "view/surface_bits.glsl"
#ifndef OPENED
#include "view/sight.glsl"
#include "view/smoothed_region.glsl"
#endif
uniform usampler2D t_surface;
layout(location = 0) out uint o_accessible;

void main() {
  uvec2 surface = texelFetch(t_surface, ivec2(gl_FragCoord.xy), 0).rg;
#ifdef OPENED
  o_accessible = surface_accessible(surface);
#else
  uint facet = surface_facet(surface);
  o_accessible = smoothed_region(on_plane(gl_FragCoord.xy, facet_plane(facet)), facet);
#endif
}
