#version 330 core
#ifdef GL_ES
flat in uint v_facet;
#else
#define v_facet uint(gl_PrimitiveID)
#endif
layout(location = 0) out uint o_facet;
void main() { o_facet = v_facet + 1u; }
