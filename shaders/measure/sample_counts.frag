#version 330 core
// One fragment a block of surface samples: how many lie in each region, and what the error of the undercut is made of
// (mold/sweep/sample_counts.hpp). Whole numbers, so that the order of summing does not matter.
#include "common/verdict.glsl"
uniform usampler2D t_samples;  // position as bits of three floats, facet; row by row
uniform int u_samples;
uniform int u_block;                       // samples a fragment, a multiple of k_stratum
layout(location = 0) out uvec4 o_regions;  // core, cavity, both, undercut
layout(location = 1) out uvec4 o_doubts;   // undercut in doubt, spread

uint spread(uint undercut, uint counted, bool in_doubt) {
  uint more = in_doubt ? 1u : 0u;
  uint seen = max(counted + 2u * more, 1u);
  return (uint(k_stratum) * (undercut + more) * (counted - undercut + more) + seen - 1u) / seen;
}

void main() {
  int width = textureSize(t_samples, 0).x;
  int first = int(gl_FragCoord.x) * u_block;
  o_regions = uvec4(0u);
  o_doubts = uvec4(0u);
  for (int stratum = first; stratum < min(first + u_block, u_samples); stratum += k_stratum) {
    uvec4 regions = uvec4(0u);
    uint in_doubt = 0u;
    for (int i = stratum; i < min(stratum + k_stratum, u_samples); ++i) {
      uvec4 packed_sample = texelFetch(t_samples, ivec2(i % width, i / width), 0);
      if (is_left_out(packed_sample.w)) continue;
      uint verdict = verdict_of(uintBitsToFloat(packed_sample.xyz), packed_sample.w);
      regions += uvec4(equal(uvec4(verdict & 3u), uvec4(k_accessible_plus, k_accessible_minus, 3u, 0u)));
      in_doubt += (verdict & k_undercut_in_doubt) != 0u ? 1u : 0u;
    }
    uint counted = regions.x + regions.y + regions.z + regions.w;
    o_regions += regions;
    o_doubts += uvec4(in_doubt, spread(regions.w, counted, in_doubt != 0u), 0u, 0u);
  }
}
