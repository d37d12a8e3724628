#version 330 core
// One fragment a surface sample: its verdict. WITH_DOUBT: and whether the texels around it all say the same.
#include "common/region.glsl"
uniform usampler2D t_samples;  // position as bits of three floats, facet
layout(location = 0) out uint o_verdict;

#ifdef WITH_DOUBT
const uint k_doubtful = 4u;  // added to the verdict
#endif

void main() {
  uvec4 packed_sample = texelFetch(t_samples, ivec2(gl_FragCoord.xy), 0);
#ifdef WITH_DOUBT
  Sight sight = sight_of(uintBitsToFloat(packed_sample.xyz), packed_sample.w);
  uint verdict = accessible_of(sight);
  ivec2 first = ivec2(floor(sight.position - 0.5));  // of the four whose centres are around it
  o_verdict = verdict;
  for (int k = 0; k < 4; ++k)
    if (accessible_at(sight, first + ivec2(k & 1, k >> 1)) != verdict) o_verdict = verdict | k_doubtful;
#else
  o_verdict = accessible_from(uintBitsToFloat(packed_sample.xyz), packed_sample.w);
#endif
}
