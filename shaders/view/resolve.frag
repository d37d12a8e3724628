#version 330 core
// From the sum of the samples to the picture in sRGB, alpha straight.
#include "view/light.glsl"
uniform sampler2D t_sum;
uniform float u_weight;  // 1 / number of samples
layout(location = 0) out vec4 o_colour;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 mean = u_weight * texelFetch(t_sum, at, 0);
  vec3 colour = mean.a > 0.0 ? sqrt(mean.rgb / mean.a) : vec3(0.0);
  o_colour = vec4(colour + dither(at, 0) / 255.0, mean.a);
}
