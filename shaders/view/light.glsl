// Light that goes with the camera: a soft key light from the upper left, the sky above, and a faint rim. Colours are
// squares of sRGB values: close to linear, and one square root away from the screen.
vec3 lit(vec3 albedo, vec3 seen_normal, float openness) {
  const vec3 k_key = vec3(-0.446, 0.602, 0.662);
  const vec3 k_half = vec3(-0.245, 0.330, 0.912);
  float key = clamp((dot(seen_normal, k_key) + 0.25) * 0.8, 0.0, 1.0);
  float sky = 0.5 + 0.5 * seen_normal.y;
  float fill = max(0.0, dot(seen_normal, vec3(0.74, -0.25, 0.62)));
  float grazing = 1.0 - max(0.0, seen_normal.z);
  float shine = max(0.0, dot(seen_normal, k_half));
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  float ambient = (0.23 + 0.23 * sky + 0.10 * fill) * openness;
  float direct = 0.62 * key * (0.35 + 0.65 * openness);
  float white = (0.05 * shine + 0.07 * grazing * grazing * grazing) * openness;
  return albedo * (ambient + direct) + vec3(white);
}

// Ordered dither in steps of the screen (Bayer, 4 by 4), so that dark gradients show no bands; over sixteen samples it
// cancels out.
float dither(ivec2 at, int sample_number) {
  ivec2 p = (at + ivec2(sample_number, sample_number >> 2)) & 3;
  int q = p.x ^ p.y;
  int rank = (q & 1) << 3 | (p.y & 1) << 2 | (q & 2) | (p.y & 2) >> 1;
  return (float(rank) + 0.5) / 16.0 - 0.5;
}
