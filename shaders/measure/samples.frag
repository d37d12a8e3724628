#version 330 core
// One fragment a surface sample: accessibility bits, and a third bit where a neighbouring texel says otherwise.
#include "common/region.glsl"
uniform usampler2D t_samples;  // position as bits of three floats, facet
layout(location = 0) out uint o_verdict;

const uint k_doubtful = 4u;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uvec4 packed_sample = texelFetch(t_samples, at, 0);
  vec3 point = uintBitsToFloat(packed_sample.xyz);
  uint facet = packed_sample.w;
  uint bits = accessible_at(point, facet, vec2(0.0));
  uint differs = 0u;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) differs |= bits ^ accessible_at(point, facet, vec2(dx, dy));
  }
  o_verdict = bits | (differs != 0u ? k_doubtful : 0u);
}
