#version 330 core
// Facets of the second-depth map of one side; the other side's facets are culled by their winding.
#include "common/map_frame.glsl"
layout(location = 0) in vec3 a_position;
uniform float u_side;  // 1: map of the light at +d, -1: at -d
#ifdef GL_ES
// No gl_PrimitiveID there: three corners a facet are drawn, none shared.
flat out uint v_facet;
#endif
void main() {
#ifdef GL_ES
  v_facet = uint(gl_VertexID) / 3u;
#endif
  gl_Position = map_clip(a_position, u_side);
}
