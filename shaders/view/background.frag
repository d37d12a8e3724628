#version 330 core
// The backdrop: a gradient from above to below with a faint glow behind the part; sRGB.
#include "view/light.glsl"
uniform vec3 u_above;
uniform vec3 u_below;
uniform vec2 u_size;
uniform int u_sample;
layout(location = 0) out vec4 o_colour;

void main() {
  vec2 place = gl_FragCoord.xy / u_size;
  vec2 off = (place - vec2(0.5, 0.54)) * vec2(1.15, 1.5);
  float glow = max(0.0, 1.0 - dot(off, off));
  vec3 colour = mix(u_below, u_above, place.y * 0.45 + 0.55 * glow * glow);
  o_colour = vec4(colour + dither(ivec2(gl_FragCoord.xy), u_sample) / 255.0, 1.0);
}
