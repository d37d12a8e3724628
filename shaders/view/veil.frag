#version 330 core
// Surface that other surface hides, as a veil over a finished picture.
uniform sampler2D t_depth;
uniform vec4 u_colour;  // sRGB and opacity
layout(location = 0) out vec4 o_colour;

void main() {
  if (gl_FragCoord.z <= texelFetch(t_depth, ivec2(gl_FragCoord.xy), 0).r + 1e-4) discard;
  o_colour = u_colour;
}
