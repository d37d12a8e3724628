#version 330 core
// The section plane, where it is inside of a solid: surface of its own.
#include "view/sight.glsl"
#include "view/surface_bits.glsl"
uniform sampler2D t_winding;
uniform vec4 u_section;  // plane n.x = c
uniform mat4 u_clip_from_unit;
uniform uint u_number;  // see view/surface_bits.glsl
layout(location = 0) out uvec2 o_surface;

void main() {
  if (texelFetch(t_winding, ivec2(gl_FragCoord.xy), 0).r < 0.5) discard;
  vec4 clip = u_clip_from_unit * vec4(on_plane(gl_FragCoord.xy, u_section), 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
  o_surface = other_bits(u_number, u_section.xyz);
}
