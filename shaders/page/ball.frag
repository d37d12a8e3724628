#version 330 core
// The ball of parting directions, as the camera sees it, with the map of undercut over the half-sphere where there is
// one: Lambert's equal-area map about +z. A direction and its opposite have one place there.
uniform sampler2D t_sphere;  // alpha: how far it is known
uniform vec3 u_right, u_above, u_toward, u_direction;
uniform vec3 u_plain, u_ink;
uniform float u_pixel;  // of the screen, in radii
in vec2 v_place;
layout(location = 0) out vec4 o_colour;

void main() {
  float reach = length(v_place);
  float cover = clamp((1.0 - reach) / u_pixel, 0.0, 1.0);
  float high = sqrt(max(1.0 - reach * reach, 0.0));
  vec3 place = v_place.x * u_right + v_place.y * u_above + high * u_toward;
  vec3 half_place = place.z < 0.0 ? -place : place;
  vec4 known = texture(t_sphere, 0.5 + 0.46 * half_place.xy / sqrt(1.0 + half_place.z));
  vec3 colour = mix(u_plain, known.rgb, known.a) * (0.72 + 0.28 * high);
  // Circles of the axes, and the direction: filled towards the viewer, a ring on the far side.
  vec3 from_axis = abs(place);
  float circle = min(from_axis.x, min(from_axis.y, from_axis.z));
  colour = mix(colour, u_ink, 0.22 * clamp(1.5 - circle / u_pixel, 0.0, 1.0));
  float away = distance(place, dot(u_direction, u_toward) < 0.0 ? -u_direction : u_direction);
  float ring = abs(away - 0.13) - 0.022, dot_edge = away - 0.075;
  colour = mix(colour, vec3(1.0), clamp(0.5 - (abs(away - 0.09) - 0.085) / u_pixel, 0.0, 1.0) * 0.85);
  colour = mix(colour, vec3(0.06), clamp(0.5 - ring / u_pixel, 0.0, 1.0));
  if (dot(u_direction, u_toward) >= 0.0) colour = mix(colour, vec3(0.06), clamp(0.5 - dot_edge / u_pixel, 0.0, 1.0));
  o_colour = vec4(colour, 1.0) * cover;
}
