#version 330 core
// A body of the mold around the part, as a surface that is no facet.
#include "view/surface_bits.glsl"
uniform uint u_number;
in vec3 v_normal;
layout(location = 0) out uvec2 o_surface;

void main() { o_surface = other_bits(u_number, v_normal); }
