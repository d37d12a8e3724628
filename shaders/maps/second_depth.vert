#version 330 core
// Facets of the second-depth map of one side; the other side's facets are culled by their winding.
#include "common/map_frame.glsl"
layout(location = 0) in vec3 a_position;
uniform float u_side;  // 1: map of the light at +d, -1: at -d
void main() { gl_Position = map_clip(a_position, u_side); }
