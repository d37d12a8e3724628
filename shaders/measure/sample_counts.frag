#version 330 core
// One fragment a block of surface samples: how many have each accessibility. Whole numbers, so that the order of summing does
// not matter.
#include "common/region.glsl"
uniform usampler2D t_samples;  // position as bits of three floats, facet; row by row
uniform int u_samples;
uniform int u_block;                       // samples a fragment
layout(location = 0) out uvec4 o_counts;  // by accessibility bits

void main() {
  int width = textureSize(t_samples, 0).x;
  int first = int(gl_FragCoord.x) * u_block;
  o_counts = uvec4(0u);
  for (int i = first; i < min(first + u_block, u_samples); ++i) {
    uvec4 packed_sample = texelFetch(t_samples, ivec2(i % width, i / width), 0);
    if (is_left_out(packed_sample.w)) continue;
    uint verdict = accessible_from(uintBitsToFloat(packed_sample.xyz), packed_sample.w);
    o_counts += uvec4(equal(uvec4(verdict), uvec4(0u, 1u, 2u, 3u)));
  }
}
