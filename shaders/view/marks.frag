#version 330 core
// Marks over a finished picture: the facet under the cursor, the one in its way, chosen facets, and a glow of the
// undercuts.
#include "view/surface_bits.glsl"
uniform usampler2D t_surface;
uniform usampler2D t_accessible;
uniform usamplerBuffer t_chosen;  // per facet
uniform bool u_any_chosen;
uniform uint u_hovered;   // facet + 1; 0: none
uniform uint u_blocking;
uniform float u_glow;
uniform vec3 u_hover_colour;  // sRGB
uniform vec3 u_block_colour;
layout(location = 0) out vec4 o_colour;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uint number = surface_number(texelFetch(t_surface, at, 0).rg);
  vec4 mark = vec4(0.0);
  if (u_glow > 0.0 && texelFetch(t_accessible, at, 0).r == 0u) mark = vec4(1.0, 0.85, 0.8, 0.45 * u_glow);
  if (u_any_chosen && texelFetch(t_chosen, int(number) - 1).r != 0u) mark = vec4(u_hover_colour, 0.28);
  if (number == u_blocking) mark = vec4(u_block_colour, 0.75);
  if (number == u_hovered) mark = vec4(u_hover_colour, 0.55);
  o_colour = number == 0u ? vec4(0.0) : mark;
}
