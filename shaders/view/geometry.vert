#version 330 core
// The part as the camera sees it. SECTION: what lies beyond u_section_offset along the direction is cut away.
#include "common/octahedral.glsl"
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec2 a_normal;
uniform mat4 u_clip_from_unit;
#ifdef BY_REGION
uniform vec3 u_shift;
#endif
#ifdef LOOK_UP
out vec3 v_position;
#endif
#ifdef SECTION
uniform vec3 u_section_normal;
uniform float u_section_offset;
#endif
out vec3 v_normal;

void main() {
  v_normal = from_octahedral(a_normal);
  vec3 position = a_position;
#ifdef SECTION
  gl_ClipDistance[0] = u_section_offset - dot(position, u_section_normal);
#endif
#ifdef LOOK_UP
  v_position = position;
#endif
#ifdef BY_REGION
  position += u_shift;
#endif
  gl_Position = u_clip_from_unit * vec4(position, 1.0);
}
