#version 330 core
// One triangle that covers the viewport at the far plane: a depth test with GL_NOTEQUAL leaves what the part covers,
// with GL_EQUAL the rest.
void main() {
  vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(2.0 * corner - 1.0, 1.0, 1.0);
}
