// The heart: from which sides is a surface point accessible? (Priyadarshi & Gupta 2006, sections 2.2 and 2.3.)
//
// The +d map holds, per texel, the facet that faces -d and lies furthest along +d; the -d map its mirror image. A point
// is blocked along +d exactly if that facet lies further along +d, that is, if the point is on the outer side of the
// facet's plane: the same test serves both maps, and planes are evaluated at the sample, not at the texel's centre.
//
// Here accessible_from(point, facet) gives the accessibility of a point on a facet: a sum of k_accessible_plus and
// k_accessible_minus.
#include "common/facets.glsl"
#include "common/map_frame.glsl"

const uint k_accessible_plus = 1u;
const uint k_accessible_minus = 2u;

#ifdef SYMMETRIC_KERNEL
// The paper's own test: depths compared at the texel; near-vertical points pass if any texel of the kernel passes.
uniform sampler2DArray t_depths;  // layer 0: of the +d map, 1: of the -d map
uniform int u_kernel_radius;      // texels

bool lit(int layer, ivec2 texel, float point_depth) {
  int size = int(u_map_size);
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(size)))) return true;
  return point_depth <= texelFetch(t_depths, ivec3(texel, layer), 0).r;
}

uint accessible_at(vec3 point, uint facet, vec2 shift) {
  uint class_of_facet = facet_class(facet);
  ivec2 texel = ivec2(floor(map_position(point) + shift));
  float depth_plus = map_depth(point, 1.0);
  float depth_minus = map_depth(point, -1.0);
  if (class_of_facet == k_up) return lit(0, texel, depth_plus) ? k_accessible_plus : 0u;
  if (class_of_facet == k_down) return lit(1, texel, depth_minus) ? k_accessible_minus : 0u;
  uint bits = 0u;
  for (int dy = -u_kernel_radius; dy <= u_kernel_radius; ++dy) {
    for (int dx = -u_kernel_radius; dx <= u_kernel_radius; ++dx) {
      if (lit(0, texel + ivec2(dx, dy), depth_plus)) bits |= k_accessible_plus;
      if (lit(1, texel + ivec2(dx, dy), depth_minus)) bits |= k_accessible_minus;
    }
  }
  return bits;
}

uint accessible_from(vec3 point, uint facet) { return accessible_at(point, facet, vec2(0.0)); }
#else
// Entries are facet + 1, 0 where no facet is. Layer 2 k is the +d map of direction k, 2 k + 1 its -d map.
uniform usampler2DArray t_maps;
uniform int u_map_pair;   // k
uniform float u_lateral;  // lateral tolerance in the unit frame

// Rounding of n.x - c at coordinates up to 0.5 in single precision. A facet that touches the point counts as in its
// way: between surfaces that coincide no mold comes in.
const float k_plane_rounding = 2.5e-7;

bool in_map(ivec2 texel) {
  return all(lessThan(uvec2(texel), uvec2(u_map_size)));  // without their sign, negative places are large ones
}

uint plus_entry(ivec2 texel) { return in_map(texel) ? texelFetch(t_maps, ivec3(texel, 2 * u_map_pair), 0).r : 0u; }
uint minus_entry(ivec2 texel) { return in_map(texel) ? texelFetch(t_maps, ivec3(texel, 2 * u_map_pair + 1), 0).r : 0u; }

bool outside_of(uint entry, vec3 point) {
  if (entry == 0u) return false;
  vec4 plane = facet_plane(entry - 1u);
  return dot(plane.xyz, point) - plane.w > -k_plane_rounding;
}

// The outer side of a near-vertical facet, perpendicular to the parting direction.
vec3 outward(vec3 normal) { return normalize(normal - dot(normal, u_direction) * u_direction); }

// What all look-ups of a point share.
struct Sight {
  vec3 at;        // the point itself, or the one beside a near-vertical facet
  vec2 position;  // of that in the maps
  uint class_of_facet;
};

Sight sight_of(vec3 point, uint facet) {
  Sight sight = Sight(point, vec2(0.0), facet_class(facet));
  if (sight.class_of_facet == k_near_vertical) sight.at += u_lateral * outward(facet_plane(facet).xyz);
  sight.position = map_position(sight.at);
  return sight;
}

// Accessibility from the entries of one texel of the two maps.
uint accessible_past(Sight sight, uint plus, uint minus) {
  bool blocked_plus = outside_of(plus, sight.at);
  bool blocked_minus = outside_of(minus, sight.at);
  uint bits = (blocked_plus ? 0u : k_accessible_plus) | (blocked_minus ? 0u : k_accessible_minus);
  if (sight.class_of_facet == k_near_vertical) return plus != 0u && minus != 0u && bits == 3u ? 0u : bits;
  return bits & (sight.class_of_facet == k_up ? k_accessible_plus : k_accessible_minus);
}

uint accessible_at(Sight sight, ivec2 texel) {
#ifdef GL_ES
  // A browser's software GL goes through all branches, but only as often round a loop as is needed.
  uint bits = 0u, met = 0u;
  int last = sight.class_of_facet == k_up ? 0 : 1;
  for (int layer = sight.class_of_facet == k_down ? 1 : 0; layer <= last; ++layer) {
    uint entry = in_map(texel) ? texelFetch(t_maps, ivec3(texel, 2 * u_map_pair + layer), 0).r : 0u;
    if (entry != 0u) ++met;
    if (!outside_of(entry, sight.at)) bits |= 1u << layer;
  }
  return met == 2u && bits == 3u ? 0u : bits;
#else
  // Software GL reads both maps whatever the class; one texel for all, where the answer is not used, stays cached.
  ivec2 plus_texel = sight.class_of_facet == k_down ? ivec2(0) : texel;
  ivec2 minus_texel = sight.class_of_facet == k_up ? ivec2(0) : texel;
  return accessible_past(sight, plus_entry(plus_texel), minus_entry(minus_texel));
#endif
}

uint accessible_of(Sight sight) { return accessible_at(sight, ivec2(floor(sight.position))); }

uint accessible_from(vec3 point, uint facet) { return accessible_of(sight_of(point, facet)); }
#endif
