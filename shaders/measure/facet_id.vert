#version 330 core
// The paper's readback (section 2.4): facet numbers seen from one side. Corners of near-vertical facets move outward
// by z tan(u_draft), z being the distance below the topmost plane, so that they can be seen from that side.
#include "common/facets.glsl"
#include "common/map_frame.glsl"
uniform samplerBuffer t_positions;  // three floats a vertex, one a texel
uniform usamplerBuffer t_corners;   // three vertices a facet, one a texel
uniform float u_side;
uniform float u_top;      // height of the topmost vertex along the side's direction
uniform float u_tangent;  // tan of the draft perturbation
flat out uint v_facet;

void main() {
  v_facet = uint(gl_VertexID) / 3u;
  int vertex = 3 * int(texelFetch(t_corners, gl_VertexID).r);
  vec3 point = vec3(texelFetch(t_positions, vertex).r, texelFetch(t_positions, vertex + 1).r,
                    texelFetch(t_positions, vertex + 2).r);
  if (facet_class(v_facet) == k_near_vertical) {
    vec3 normal = facet_plane(v_facet).xyz;
    vec3 level = normal - dot(normal, u_direction) * u_direction;
    float below = u_top - u_side * dot(point, u_direction);
    if (dot(level, level) > 0.0) point += below * u_tangent * normalize(level);
  }
  gl_Position = map_clip(point, u_side);
}
