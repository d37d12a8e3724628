#version 330 core
// Where the back of a surface is seen through a section, solid was cut: its depth is that of the section plane.
#include "view/sight.glsl"
#include "view/surface_bits.glsl"
uniform usampler2D t_surface;
uniform vec4 u_section;  // plane n.x = c
uniform mat4 u_clip_from_unit;

void main() {
  if (!surface_shows_back(texelFetch(t_surface, ivec2(gl_FragCoord.xy), 0).rg)) discard;
  vec4 clip = u_clip_from_unit * vec4(on_plane(gl_FragCoord.xy, u_section), 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
}
