#version 330 core
layout(location = 0) out uint o_facet;
void main() { o_facet = uint(gl_PrimitiveID) + 1u; }
