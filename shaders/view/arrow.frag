#version 330 core
#include "view/light.glsl"
uniform vec3 u_colour;
uniform float u_opacity;
uniform vec3 u_eye_right;
uniform vec3 u_eye_up;
uniform vec3 u_eye_back;
in vec3 v_normal;
layout(location = 0) out vec4 o_colour;

void main() {
  vec3 n = normalize(v_normal);
  vec3 seen = vec3(dot(n, u_eye_right), dot(n, u_eye_up), abs(dot(n, u_eye_back)));
  o_colour = vec4(sqrt(lit(u_colour, seen, 1.0)), u_opacity);
}
