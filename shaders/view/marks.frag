#version 330 core
// Marks over a finished picture: a glow of the undercuts, gray over all that is not lit and, with FACES, the face under the cursor, the one in its
// way, and the chosen one. The cut of a section is none of them.
#include "view/surface_bits.glsl"
uniform usampler2D t_surface;
uniform usampler2D t_accessible;
uniform float u_glow;
uniform float u_gray;  // how much of it, [0, 1]
uniform uint u_lit;    // accessibility bits of what is not gray
layout(location = 0) out vec4 o_colour;
#ifdef FACES
uniform usamplerBuffer t_faces;  // number of each facet's face
uniform uint u_hovered;
uniform uint u_blocking;
uniform uint u_chosen;
uniform vec3 u_hover_colour;  // sRGB
uniform vec3 u_block_colour;
#endif

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uvec2 surface = texelFetch(t_surface, at, 0).rg;
  bool marked = surface.x != 0u && !surface_is_other(surface);
  vec4 mark = vec4(0.0);
  if (u_glow > 0.0 && texelFetch(t_accessible, at, 0).r == 0u) mark = vec4(1.0, 0.85, 0.8, 0.45 * u_glow);
  if (u_gray > 0.0 && texelFetch(t_accessible, at, 0).r != u_lit) mark = vec4(vec3(0.5), u_gray);
#ifdef FACES
  uint face = texelFetch(t_faces, int(surface_facet(surface))).r;
  if (face == u_chosen) mark = vec4(u_hover_colour, 0.28);
  if (face == u_hovered) mark = vec4(u_hover_colour, face == u_chosen ? 0.4 : 0.22);
  if (face == u_blocking) mark = vec4(u_block_colour, 0.5);
#endif
  o_colour = marked ? mark : vec4(0.0);
}
