// What the maps say of a surface sample: the verdict bits of mold/measure.hpp.
#include "common/region.glsl"

const uint k_doubtful = 4u;
const uint k_undercut_in_doubt = 8u;

uint verdict_of(vec3 point, uint facet) {
#ifndef SYMMETRIC_KERNEL
  Sight sight = sight_of(point, facet);
  ivec2 texel = ivec2(floor(sight.position));
#endif
  uint bits = 0u;
  uint answers = 0u;  // of the sample's own texel and the eight beside it: a sum of 1 << accessibility
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
#ifdef SYMMETRIC_KERNEL
      uint answer = accessible_at(point, facet, vec2(dx, dy));
#else
      ivec2 beside = texel + ivec2(dx, dy);
      uint answer = accessible_past(sight, plus_entry(beside), minus_entry(beside));
#endif
      answers |= 1u << answer;
      if (dx == 0 && dy == 0) bits = answer;
    }
  }
  // Bit 0 stands for accessible from neither side.
  bool undercut_in_doubt = (answers & 1u) != 0u && (answers & ~1u) != 0u;
  return bits | (answers != 1u << bits ? k_doubtful : 0u) | (undercut_in_doubt ? k_undercut_in_doubt : 0u);
}
