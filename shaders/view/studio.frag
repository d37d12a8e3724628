#version 330 core
// A studio: a light backdrop, and on its floor the soft shadow of what stands over it; sRGB.
#include "view/light.glsl"
#include "view/sight.glsl"
uniform sampler2D t_footprint;
uniform float u_ground;  // z of the floor
uniform float u_reach;   // half the side of the footprint's square
uniform vec3 u_above;
uniform vec3 u_below;
uniform vec2 u_size;
uniform int u_sample;
layout(location = 0) out vec4 o_colour;

// How much of a disc around a place is covered.
float covered(vec2 at, float radius) {
  const int k_taps = 24;
  float sum = 0.0;
  for (int k = 0; k < k_taps; ++k) {
    float out_to = radius * sqrt((float(k) + 0.5) / float(k_taps));
    float angle = 2.3999632 * float(k + k_taps * u_sample);  // the golden angle
    sum += texture(t_footprint, 0.5 + 0.5 / u_reach * (at + out_to * vec2(cos(angle), sin(angle)))).r;
  }
  return sum / float(k_taps);
}

void main() {
  vec2 place = gl_FragCoord.xy / u_size;
  vec2 off = (place - vec2(0.5, 0.54)) * vec2(1.15, 1.5);
  float glow = max(0.0, 1.0 - dot(off, off));
  vec3 colour = mix(u_below, u_above, place.y * 0.45 + 0.55 * glow * glow);
  if (sight_direction(gl_FragCoord.xy).z < 0.0) {  // the floor is seen from above
    vec2 at = on_plane(gl_FragCoord.xy, vec4(0.0, 0.0, 1.0, u_ground)).xy;
    colour *= 1.0 - 0.30 * covered(at, 0.16) - 0.25 * covered(at, 0.045);
  }
  o_colour = vec4(colour + dither(ivec2(gl_FragCoord.xy), u_sample) / 255.0, 1.0);
}
