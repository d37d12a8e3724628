// Distance from the eye, along the view, of a value of the depth buffer.
uniform vec4 u_eye_depth;  // (x + y d) / (z + w d)

float eye_distance(float depth) {
  return (u_eye_depth.x + u_eye_depth.y * depth) / (u_eye_depth.z + u_eye_depth.w * depth);
}
