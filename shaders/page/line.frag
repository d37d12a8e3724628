#version 330 core
// Lines and marks of one colour in a page, cut by a plane.
uniform vec4 u_cut, u_ink;
in vec3 v_place;
layout(location = 0) out vec4 o_colour;

void main() {
  if (dot(u_cut.xyz, v_place) > u_cut.w) discard;
  o_colour = vec4(u_ink.rgb, 1.0) * u_ink.a;
}
