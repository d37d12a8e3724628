// A visible fragment in two words. First: facet + 1 (0: background); bit 28 set if it belongs to no facet: the
// cut of a section, the steel of a mold; from bit 29 on the accessibility bits of the split surface; top bit set if its back is seen. Second: the smooth normal in 15 + 15 bits, and the accessibility bits
// by which the surface was drawn, where they were known then.
#include "common/octahedral.glsl"

const uint k_back_bit = 0x80000000u;
const uint k_cut_bit = 0x10000000u;
const uint k_number_mask = 0x0FFFFFFFu;
const int k_accessibilities = 4;  // sums of the bits

// A piece of the split surface: its facet, and its accessibility bits from bit 30 on.
uint source_facet(uint source) { return source & 0x3FFFFFFFu; }
uint source_accessible(uint source) { return source >> 30; }

uint normal_bits(vec3 normal) {
  uvec2 steps = uvec2((to_octahedral(normal) * 0.5 + 0.5) * 32767.0 + 0.5);
  return steps.x | steps.y << 15;
}

uvec2 surface_bits(uint facet, bool front, vec3 normal, uint accessible, uint exact) {
  return uvec2((facet + 1u) | exact << 29 | (front ? 0u : k_back_bit), normal_bits(normal) | accessible << 30);
}

// Of what is no facet, in place of its number: 1 the cut of the part; from 2 on the steel of a mold, of each body its
// surface and its cut.
uvec2 other_bits(uint number, vec3 normal) { return uvec2(number | k_cut_bit | 3u << 29, normal_bits(normal) | 3u << 30); }

uint surface_number(uvec2 surface) { return surface.x & k_number_mask; }
uint surface_facet(uvec2 surface) { return surface_number(surface) - 1u; }
bool surface_is_other(uvec2 surface) { return (surface.x & k_cut_bit) != 0u; }
bool number_is_steel(uint number) { return number > 1u; }
bool number_is_cut(uint number) { return (number & 1u) == 1u; }
uint number_steel(uint number) { return (number - 2u) >> 1; }
bool surface_shows_back(uvec2 surface) { return (surface.x & k_back_bit) != 0u; }
uint surface_exact(uvec2 surface) { return surface.x >> 29 & 3u; }
uint surface_accessible(uvec2 surface) { return surface.y >> 30; }

vec3 surface_normal(uvec2 surface) {
  vec2 steps = vec2(uvec2(surface.y, surface.y >> 15) & 32767u);
  return from_octahedral(steps / 32767.0 * 2.0 - 1.0);
}
