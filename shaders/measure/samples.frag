#version 330 core
// One fragment a surface sample: accessibility bits, and a third bit where a neighbouring texel says otherwise.
#include "common/region.glsl"
uniform usampler2D t_samples;  // position as bits of three floats, facet
layout(location = 0) out uint o_verdict;

const uint k_doubtful = 4u;

#ifdef SYMMETRIC_KERNEL
uint differing(vec3 point, uint facet, uint bits) {
  uint differs = 0u;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) differs |= bits ^ accessible_at(point, facet, vec2(dx, dy));
  }
  return differs;
}
#else
uint differing(vec3 point, uint facet, uint bits) {
  Sight sight = sight_of(point, facet);
  ivec2 texel = ivec2(floor(sight.position));
  uint differs = 0u;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      ivec2 beside = texel + ivec2(dx, dy);
      differs |= bits ^ accessible_past(sight, map_entry(t_map_plus, beside), map_entry(t_map_minus, beside));
    }
  }
  return differs;
}
#endif

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uvec4 packed_sample = texelFetch(t_samples, at, 0);
  vec3 point = uintBitsToFloat(packed_sample.xyz);
  uint facet = packed_sample.w;
  uint bits = accessible_at(point, facet, vec2(0.0));
  o_verdict = bits | (differing(point, facet, bits) != 0u ? k_doubtful : 0u);
}
