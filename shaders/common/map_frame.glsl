// Where a point falls in the two shadow maps of the parting direction.
uniform vec3 u_direction;  // unit
uniform vec3 u_map_x;      // unit axes of the maps
uniform vec3 u_map_y;
uniform float u_map_size;   // texels along a side
uniform float u_map_scale;  // sides that 1 of the unit frame takes: 1, or more where the part is less across

vec2 map_position(vec3 point) {
  return (u_map_scale * vec2(dot(point, u_map_x), dot(point, u_map_y)) + 0.5) * u_map_size;
}

// Map depth of a point: the +d map (side 1.0) keeps what is furthest along +d, the -d map (side -1.0) along -d.
float map_depth(vec3 point, float side) { return 0.5 - side * dot(point, u_direction); }

vec4 map_clip(vec3 point, float side) {
  return vec4(2.0 * map_position(point) / u_map_size - 1.0, 2.0 * map_depth(point, side) - 1.0, 1.0);
}
