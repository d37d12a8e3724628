#version 330 core
// Regions, colour and light of the visible fragments. KNOWN: the geometry pass knows the regions already. PLAIN: none
// are wanted. LOOK_UP: the shadow maps are looked up, once a fragment. COMPARED: marks where exact regions and those of
// the maps differ; one of the two is known, the other one looked up or part of the split surface. DETAIL: what is not
// always wanted, such as draft colours, facet edges, level lines, the cut of a section, an opened mold and its steel.
#include "view/light.glsl"
#include "view/surface_bits.glsl"
uniform usampler2D t_surface;
uniform sampler2D t_openness;
uniform vec3 u_colours[k_accessibilities];  // by accessibility bits; undercut is 0
uniform vec3 u_eye_right;
uniform vec3 u_eye_up;
uniform vec3 u_eye_back;
uniform vec2 u_hatch_origin;  // a point that goes with the scene, px
uniform vec2 u_hatch;         // pitch and strength; 0: none
uniform float u_dimmed;       // how gray colours are, [0, 1]
uniform vec3 u_opacity;       // of the part, of its undercuts, of a mold's steel
layout(location = 0) out vec4 o_colour;
layout(location = 1) out uint o_accessible;  // bits
#if defined(DETAIL) || defined(LOOK_UP)
#include "common/facets.glsl"
#include "view/sight.glsl"
#endif
#ifdef LOOK_UP
#include "common/region.glsl"

// `shift`: by which the surface has been moved.
uint looked_up(vec2 pixel, uint facet, vec3 shift) {
  vec4 plane = facet_plane(facet);
  return accessible_from(on_plane(pixel, plane + vec4(0.0, 0.0, 0.0, dot(plane.xyz, shift))) - shift, facet);
}
#endif
#ifdef COMPARED
uniform vec4 u_difference;  // its colour, and whether it is marked
uniform vec2 u_swapped;     // from where to where in the picture, px, the compared regions take the others' place
#endif
#ifdef DETAIL
#include "view/detail.glsl"
#endif

// Slanting stripes that leave `gap` of the pitch free, smooth over a pixel: 1 on a stripe.
float stripes(vec2 at, float pitch, float gap) {
  float across = abs(fract((at.x + at.y) * 0.70711 / pitch) - 0.5) * pitch;
  return clamp(across - 0.5 * gap * pitch + 0.5, 0.0, 1.0);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uvec2 surface = texelFetch(t_surface, at, 0).rg;
  bool other = surface_is_other(surface);
  uint number = other ? surface_number(surface) : 0u;
  uint facet = other ? 0u : surface_facet(surface);  // 0 stands for what no shader is to ask
#if defined(PLAIN)
  uint bits = 3u;
#elif defined(KNOWN)
  uint bits = surface_accessible(surface);
#else
  uint bits = looked_up(gl_FragCoord.xy, facet, vec3(0.0));
#endif
#ifdef COMPARED
#if defined(KNOWN) && defined(LOOK_UP) && defined(DETAIL)
  uint compared = looked_up(gl_FragCoord.xy, facet, shift_of(bits));
#elif defined(KNOWN) && defined(LOOK_UP)
  uint compared = looked_up(gl_FragCoord.xy, facet, vec3(0.0));
#else
  uint compared = surface_exact(surface);
#endif
  if (gl_FragCoord.x > u_swapped.x && gl_FragCoord.x < u_swapped.y) {
    uint shown = compared;
    compared = bits;
    bits = shown;
  }
#endif
  if (other) bits = 3u;
  o_accessible = bits;
  bool back = surface_shows_back(surface);
  vec3 n = surface_normal(surface);
  float openness = texelFetch(t_openness, at, 0).r;
  vec3 albedo = u_colours[bits];
  float hatch = 0.0;
#ifndef PLAIN
  vec2 from_origin = gl_FragCoord.xy - u_hatch_origin;
  if (bits == 0u) hatch = u_hatch.y * stripes(from_origin, u_hatch.x, 0.58);
#endif
#ifdef DETAIL
  detail(surface, facet, bits, albedo, hatch);
#endif
#ifdef COMPARED
  if (compared != bits && !other && u_difference.a > 0.0) {
    // Between the stripes too, so that slivers narrower than the stripes show.
    albedo = mix(albedo, u_difference.rgb, mix(0.45, 1.0, stripes(from_origin * vec2(1.0, -1.0), u_hatch.x, 0.5)));
    hatch = 0.0;
  }
#endif
  albedo = mix(albedo, vec3(dot(albedo, vec3(0.3, 0.59, 0.11))), u_dimmed);
  n = back ? -n : n;
  vec3 seen = vec3(dot(n, u_eye_right), dot(n, u_eye_up), dot(n, u_eye_back));
  albedo *= (back ? 0.45 : 1.0) * (1.0 - hatch);
  // A cut is solid: it hides more.
  float steel = number_is_cut(number) ? mix(u_opacity.z, 1.0, 0.5) : u_opacity.z;
  float opacity = number_is_steel(number) ? steel : bits == 0u ? u_opacity.y : u_opacity.x;
  o_colour = vec4(sqrt(lit(albedo, seen, openness)), opacity);
}
