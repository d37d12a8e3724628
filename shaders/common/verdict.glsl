// What the maps say of a surface sample: the verdict bits of mold/measure.hpp.
#include "common/region.glsl"

const uint k_doubtful = 4u;
const uint k_undercut_in_doubt = 8u;

// Answers of the sample's own texel and the eight beside it: a sum of 1 << accessibility.
#ifdef SYMMETRIC_KERNEL
uint answers_around(vec3 point, uint facet) {
  uint answers = 0u;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) answers |= 1u << accessible_at(point, facet, vec2(dx, dy));
  }
  return answers;
}
#else
uint answers_around(vec3 point, uint facet) {
  Sight sight = sight_of(point, facet);
  ivec2 texel = ivec2(floor(sight.position));
  uint answers = 0u;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      ivec2 beside = texel + ivec2(dx, dy);
      answers |= 1u << accessible_past(sight, plus_entry(beside), minus_entry(beside));
    }
  }
  return answers;
}
#endif

uint verdict_of(vec3 point, uint facet) {
  uint bits = accessible_from(point, facet);
  uint answers = answers_around(point, facet);
  // Bit 0 stands for accessible from neither side.
  bool undercut_in_doubt = (answers & 1u) != 0u && (answers & ~1u) != 0u;
  return bits | (answers != 1u << bits ? k_doubtful : 0u) | (undercut_in_doubt ? k_undercut_in_doubt : 0u);
}
