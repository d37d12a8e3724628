#version 330 core
// An arrow of a cylinder and a cone about an axis, without buffers: u_sides sectors of four triangles each.
uniform mat4 u_clip_from_unit;
uniform vec3 u_tail;
uniform vec3 u_axis;   // unit
uniform vec3 u_aside;  // unit, perpendicular to the axis
uniform vec4 u_shape;  // length, head's length, shaft's radius, head's radius
uniform int u_sides;
out vec3 v_normal;

void main() {
  int sector = gl_VertexID / 12, corner = gl_VertexID % 12;
  // Two triangles of the shaft, one of the head's base, one of the head: rows from tail to tip.
  int rows[12] = int[12](0, 0, 1, 1, 0, 1, 2, 3, 3, 3, 3, 4);
  int turns[12] = int[12](0, 1, 0, 0, 1, 1, 0, 1, 0, 0, 1, 0);
  float radii[5] = float[5](u_shape.z, u_shape.z, 0.0, u_shape.w, 0.0);
  int row = rows[corner];
  float angle = 6.2831853 * (float(sector + turns[corner]) + (row == 4 ? 0.5 : 0.0)) / float(u_sides);
  vec3 out_of_axis = cos(angle) * u_aside + sin(angle) * cross(u_axis, u_aside);
  float height = row == 0 ? 0.0 : row == 4 ? u_shape.x : u_shape.x - u_shape.y;
  v_normal = corner < 6 ? out_of_axis
             : corner < 9 ? -u_axis : normalize(u_shape.y * out_of_axis + u_shape.w * u_axis);
  gl_Position = u_clip_from_unit * vec4(u_tail + height * u_axis + radii[row] * out_of_axis, 1.0);
}
