#version 330 core
// Segments as strips of a width in pixels: four vertices each, moved toward the viewer by a little, so that the surface
// which they lie on does not hide them.
uniform samplerBuffer t_segments;  // two texels each: start, end
uniform mat4 u_eye_from_unit;
uniform mat4 u_clip_from_eye;
uniform vec2 u_size_px;
uniform float u_half_width_px;  // with the soft border
uniform float u_lift;           // orthographic: length; perspective: share of the distance
uniform float u_perspective;
uniform float u_near;
uniform vec3 u_shift;
#ifdef SECTION
uniform vec3 u_section_normal;
uniform float u_section_offset;
#endif
noperspective out float v_across;

vec3 lifted(vec3 eye) { return u_perspective > 0.5 ? eye * (1.0 - u_lift) : eye + vec3(0.0, 0.0, u_lift); }

void main() {
  int segment = 2 * (gl_VertexID >> 2);
  vec3 ends[2];
#ifdef SECTION
  gl_ClipDistance[0] =
      u_section_offset - dot(texelFetch(t_segments, segment + (gl_VertexID & 1)).xyz, u_section_normal);
#endif
  ends[0] = (u_eye_from_unit * vec4(texelFetch(t_segments, segment).xyz + u_shift, 1.0)).xyz;
  ends[1] = (u_eye_from_unit * vec4(texelFetch(t_segments, segment + 1).xyz + u_shift, 1.0)).xyz;
  int own = gl_VertexID & 1;
  float side = (gl_VertexID & 2) == 0 ? -1.0 : 1.0;
  // What lies behind the eye is cut off, else the projection would turn it over.
  if (u_perspective > 0.5) {
    vec3 across = ends[0] - ends[1];
    for (int i = 0; i < 2; ++i) {
      if (ends[i].z > -u_near && ends[1 - i].z < -u_near) ends[i] += across * ((-u_near - ends[i].z) / across.z);
    }
  }
  vec4 a = u_clip_from_eye * vec4(lifted(ends[own]), 1.0);
  vec4 b = u_clip_from_eye * vec4(lifted(ends[1 - own]), 1.0);
  vec2 along = (b.xy / b.w - a.xy / a.w) * u_size_px;
  along = length(along) < 1e-5 ? vec2(1.0, 0.0) : normalize(along) * (own == 0 ? 1.0 : -1.0);
  v_across = side * u_half_width_px;
  vec2 out_px = vec2(-along.y, along.x) * v_across;
  // A little beyond the ends, so that neighbours join.
  out_px -= (own == 0 ? 1.0 : -1.0) * along * 0.35 * u_half_width_px;
  gl_Position = a + vec4(2.0 * out_px / u_size_px * a.w, 0.0, 0.0);
}
