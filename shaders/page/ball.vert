#version 330 core
// A square that holds the ball of directions; drawn as a strip of four vertices without buffers.
out vec2 v_place;
void main() {
  v_place = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  gl_Position = vec4(v_place, 0.0, 1.0);
}
