#version 330 core
// One fragment a surface sample: its verdict.
#include "common/region.glsl"
uniform usampler2D t_samples;  // position as bits of three floats, facet
layout(location = 0) out uint o_verdict;

void main() {
  uvec4 packed_sample = texelFetch(t_samples, ivec2(gl_FragCoord.xy), 0);
  o_verdict = accessible_from(uintBitsToFloat(packed_sample.xyz), packed_sample.w);
}
