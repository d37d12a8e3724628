#version 330 core
flat in uint v_facet;
layout(location = 0) out uint o_facet;
void main() { o_facet = v_facet + 1u; }
