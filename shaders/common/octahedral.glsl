// Unit vectors on an octahedron folded into the square [-1, 1]^2 (Cigolle et al. 2014).
vec2 fold(vec2 v) { return (1.0 - abs(v.yx)) * vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0); }

vec3 from_octahedral(vec2 v) {
  float z = 1.0 - abs(v.x) - abs(v.y);
  return normalize(vec3(z >= 0.0 ? v : fold(v), z));
}

// The vector need not be of unit length.
vec2 to_octahedral(vec3 n) {
  vec2 v = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
  return n.z >= 0.0 ? v : fold(v);
}
