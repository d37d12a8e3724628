// Lines of sight: origin and direction at the lower left corner of the picture, and their change a pixel.
uniform vec3 u_sight_origin[3];
uniform vec3 u_sight_direction[3];

vec3 sight_origin(vec2 pixel) { return u_sight_origin[0] + pixel.x * u_sight_origin[1] + pixel.y * u_sight_origin[2]; }
vec3 sight_direction(vec2 pixel) {
  return u_sight_direction[0] + pixel.x * u_sight_direction[1] + pixel.y * u_sight_direction[2];
}

// Where the line of sight meets a plane n.x = c. The facet's own plane gives a better point than the depth would.
vec3 on_plane(vec2 pixel, vec4 plane) {
  vec3 origin = sight_origin(pixel), direction = sight_direction(pixel);
  float towards = dot(plane.xyz, direction);
  float steepness = abs(towards) < 1e-7 ? (towards < 0.0 ? -1e-7 : 1e-7) : towards;
  return origin + (plane.w - dot(plane.xyz, origin)) / steepness * direction;
}
