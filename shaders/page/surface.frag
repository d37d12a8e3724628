#version 330 core
// Lit surface in a page. LIVE: in the colours of the regions. CUT: a plane cuts it, and of the regions only those in
// u_regions are drawn; without it the surface that others hide costs nothing.
#ifdef LIVE
#include "common/region.glsl"
uniform vec3 u_colours[4];  // by accessibility bits
uniform uint u_regions;     // bit k: accessibility bits k are drawn
in vec3 v_beside;
in vec2 v_map_position;
flat in uint v_class;
#else
uniform vec3 u_colour;
#endif
uniform vec3 u_up, u_key, u_shine;  // unit: upward, towards the light, and between it and the viewer
uniform vec4 u_cut;
uniform float u_alpha, u_hatch;
in vec3 v_place, v_normal;
layout(location = 0) out vec4 o_colour;

void main() {
#ifdef CUT
  if (dot(u_cut.xyz, v_place) > u_cut.w) discard;
#endif
#ifdef LIVE
  uint bits = accessible_of(Sight(v_beside, v_map_position, v_class));
#ifdef CUT
  if ((u_regions >> bits & 1u) == 0u) discard;
#endif
  vec3 base = u_colours[bits];
  float hatch = bits == 0u ? u_hatch : 0.0;
#else
  vec3 base = u_colour;
  float hatch = u_hatch;
#endif
  vec3 normal = normalize(v_normal);
  bool inside = !gl_FrontFacing;
  if (inside) normal = -normal;
  float light = 0.40 + 0.14 * dot(normal, u_up) + 0.52 * max(dot(normal, u_key), 0.0);
  // By squares, which cost software GL a tenth of pow(): to the 40th.
  float shine = max(dot(normal, u_shine), 0.0);
  shine *= shine;
  shine *= shine;
  shine *= shine;
  float gloss = 0.10 * shine * (shine * shine) * (shine * shine);
  if (hatch > 0.0 && mod(gl_FragCoord.x + gl_FragCoord.y, 9.0 * hatch) < 3.2 * hatch) base = mix(base, vec3(1.0), 0.45);
  if (inside && length(u_cut.xyz) > 0.0) {
    light = 0.82;
    gloss = 0.0;
    base = mix(base, vec3(0.69, 0.67, 0.63), 0.72);
  } else if (inside) {
    light *= 0.72;
    gloss = 0.0;
  }
  o_colour = vec4(base * sqrt(light * 1.25) + gloss, 1.0) * u_alpha;
}
