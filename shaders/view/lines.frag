#version 330 core
// A line with a soft border of one pixel. OPENED: only over the surface that it has been moved with. OVER: over a
// finished picture, paler where surface hides it. TUBE: how deep in it, 0 at its rim and 1 in its middle, in the channels of
// u_colour that are for seen lines (first and third) or hidden ones.
uniform float u_half_width_px;  // with the soft border
uniform vec4 u_colour;          // sRGB and opacity
noperspective in float v_across;
layout(location = 0) out vec4 o_colour;
#ifdef OPENED
#include "common/facets.glsl"
#include "view/eye_depth.glsl"
#include "view/sight.glsl"
#include "view/surface_bits.glsl"
uniform usampler2D t_surface;
uniform uint u_regions;  // bit k: accessibility bits k
uniform vec3 u_shift;
uniform mat4 u_clip_from_unit;
uniform float u_slack;  // how far a line may lie before the surface, unit frame
#endif
#ifdef OVER
uniform sampler2D t_depth;
#ifndef TUBE
uniform float u_hidden;  // share of the opacity that is left
#endif
#endif

void main() {
  float cover = clamp(u_half_width_px - abs(v_across), 0.0, 1.0);
#ifdef OVER
  bool hidden = gl_FragCoord.z > texelFetch(t_depth, ivec2(gl_FragCoord.xy), 0).r;
#ifdef TUBE
  float deep = clamp(1.0 - abs(v_across) / u_half_width_px, 0.0, 1.0);
#else
  if (hidden) cover *= u_hidden;
#endif
#endif
#ifdef OPENED
  uvec2 surface = texelFetch(t_surface, ivec2(gl_FragCoord.xy), 0).rg;
  if (surface.x == 0u || (u_regions >> surface_accessible(surface) & 1u) == 0u) discard;
  vec4 plane = facet_plane(surface_facet(surface));
  vec3 on_surface = on_plane(gl_FragCoord.xy, plane + vec4(0.0, 0.0, 0.0, dot(plane.xyz, u_shift)));
  vec4 clip = u_clip_from_unit * vec4(on_surface, 1.0);
  if (eye_distance(0.5 + 0.5 * clip.z / clip.w) - eye_distance(gl_FragCoord.z) > u_slack) discard;
#endif
#ifdef TUBE
  o_colour = u_colour * deep * (hidden ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 1.0, 0.0));
#else
  o_colour = vec4(u_colour.rgb, u_colour.a * cover);
#endif
}
