#version 330 core
// Surface and lines in a page, moved as the mold opens. LIVE: the part, three corners a facet, whose regions come from
// the shadow maps.
#ifdef LIVE
#include "common/region.glsl"
out vec3 v_beside;        // where the surface is tested: beside it where it is near-vertical
out vec2 v_map_position;  // of that
flat out uint v_class;
#endif
uniform mat4 u_clip, u_motion;
uniform vec3 u_eye;
uniform vec2 u_nudge;
uniform float u_lift;
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
out vec3 v_place, v_normal;

void main() {
  vec4 place = u_motion * vec4(a_position, 1.0);
  v_place = place.xyz;
  v_normal = mat3(u_motion) * a_normal;
#ifdef LIVE
  Sight sight = sight_of(a_position, uint(gl_VertexID) / 3u);
  v_beside = sight.at;
  v_map_position = sight.position;
  v_class = sight.class_of_facet;
#endif
  // Lines stand off the surface a little, towards the eye.
  gl_Position = u_clip * vec4(place.xyz + u_lift * normalize(u_eye - place.xyz), 1.0);
  gl_Position.xy += u_nudge * gl_Position.w;
}
