#version 330 core
// Regions, colour and light of the visible fragments, each classified once. OPENED: the geometry pass knows the
// regions already. PLAIN: none are wanted. DETAIL: what is not always wanted, such as draft colours, facet edges, level
// lines, the cut of a section and an opened mold.
#include "view/light.glsl"
#include "view/surface_bits.glsl"
uniform usampler2D t_surface;
uniform sampler2D t_openness;
uniform vec3 u_colours[4];  // by accessibility bits; undercut is 0
uniform vec3 u_eye_right;
uniform vec3 u_eye_up;
uniform vec3 u_eye_back;
uniform vec2 u_hatch_origin;  // a point that goes with the scene, px
uniform vec2 u_hatch;         // pitch and strength; 0: none
uniform float u_others_opacity;
layout(location = 0) out vec4 o_colour;
layout(location = 1) out uint o_accessible;  // bits
#if defined(DETAIL) || !(defined(OPENED) || defined(PLAIN))
#include "common/facets.glsl"
#include "view/sight.glsl"
#endif
#if !(defined(OPENED) || defined(PLAIN))
#include "view/smoothed_region.glsl"
#endif
#ifdef DETAIL
#include "view/detail.glsl"
#endif

// Slanting stripes, smooth over a pixel: 1 on a stripe.
float stripes(vec2 at, float pitch) {
  float across = abs(fract((at.x + at.y) * 0.70711 / pitch) - 0.5) * pitch;
  return clamp(across - 0.29 * pitch + 0.5, 0.0, 1.0);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uvec2 surface = texelFetch(t_surface, at, 0).rg;
#if defined(OPENED)
  uint bits = surface_accessible(surface);
#elif defined(PLAIN)
  uint bits = 3u;
#else
  uint facet = surface_facet(surface);
  uint bits = smoothed_region(on_plane(gl_FragCoord.xy, facet_plane(facet)), facet);
#endif
  o_accessible = bits;
  bool back = surface_shows_back(surface);
  vec3 n = surface_normal(surface);
  float openness = texelFetch(t_openness, at, 0).r;
  vec3 albedo = u_colours[bits];
  float hatch = 0.0;
#ifndef PLAIN
  if (bits == 0u) hatch = u_hatch.y * stripes(gl_FragCoord.xy - u_hatch_origin, u_hatch.x);
#endif
#ifdef DETAIL
  detail(gl_FragCoord.xy, surface_facet(surface), bits, back, n, albedo, hatch);
#endif
  n = back ? -n : n;
  vec3 seen = vec3(dot(n, u_eye_right), dot(n, u_eye_up), dot(n, u_eye_back));
  albedo *= (back ? 0.45 : 1.0) * (1.0 - hatch);
  o_colour = vec4(sqrt(lit(albedo, seen, openness)), bits == 0u ? 1.0 : u_others_opacity);
}
