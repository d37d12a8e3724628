#version 330 core
// Thick concave contour edges (paper, section 2.3): one instance an edge, four corners of a strip; an edge that is no
// contour edge of this map collapses. One-sided: the facet that the map holds is extended in its own plane by half the
// thickness across the edge. Symmetric, as in the paper: a strip of constant depth across, half on either side.
#include "common/facets.glsl"
#include "common/map_frame.glsl"
layout(location = 0) in vec3 a_start;
layout(location = 1) in vec3 a_end;
layout(location = 2) in uvec2 a_facets;
uniform float u_side;
uniform float u_half_width;  // in the unit frame
flat out uint v_facet;

void main() {
  vec3 point = (gl_VertexID & 1) == 0 ? a_start : a_end;
  bool far_row = (gl_VertexID & 2) != 0;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  v_facet = 0u;

  // Seen from this map's light, `away` is the class of the facets that it holds.
  uint away = u_side > 0.0 ? k_down : k_up;
  uint toward = u_side > 0.0 ? k_up : k_down;
  uvec2 classes = uvec2(facet_class(a_facets.x), facet_class(a_facets.y));
  bool first_holds = classes.x == away && (classes.y == toward || classes.y == k_near_vertical);
  bool second_holds = classes.y == away && (classes.x == toward || classes.x == k_near_vertical);
#ifdef SYMMETRIC_KERNEL
  // Near-vertical facets face both ways, so they make contour edges with every neighbour.
  if (classes.x == k_near_vertical) first_holds = true;
  if (classes.y == k_near_vertical) second_holds = true;
#endif
  if (!first_holds && !second_holds) return;

  vec3 edge = a_end - a_start;
  vec3 flat_edge = edge - dot(edge, u_direction) * u_direction;
  float length_across = length(flat_edge);
  if (length_across < 1e-9) return;
  uint facet = first_holds ? a_facets.x : a_facets.y;
  v_facet = facet;
  // To the left of the edge lies facet x: outward of facet x is to the right.
  vec3 right_of_edge = cross(flat_edge, u_direction) / length_across;
#ifdef SYMMETRIC_KERNEL
  vec3 across = right_of_edge * (far_row ? u_half_width : -u_half_width);
#else
  vec3 normal = facet_plane(facet).xyz;
  // Seen along the map's axis a facet that faces away runs clockwise: its outer side is mirrored.
  float sense = (first_holds ? 1.0 : -1.0) * (u_side > 0.0 ? -1.0 : 1.0);
  vec3 out_of_facet = right_of_edge * sense;
  float rise = -dot(normal, out_of_facet) / dot(normal, u_direction);
  vec3 across = far_row ? u_half_width * (out_of_facet + rise * u_direction) : vec3(0.0);
#endif
  gl_Position = map_clip(point + across, u_side);
}
