#version 330 core
// Number of covered texels in each block of a map: the shadow's area, to be summed up by the caller.
uniform usampler2D t_map;
uniform int u_block;
layout(location = 0) out uint o_count;
void main() {
  ivec2 corner = ivec2(gl_FragCoord.xy) * u_block;
  ivec2 limit = min(corner + u_block, textureSize(t_map, 0));
  uint count = 0u;
  for (int y = corner.y; y < limit.y; ++y) {
    for (int x = corner.x; x < limit.x; ++x) count += texelFetch(t_map, ivec2(x, y), 0).r != 0u ? 1u : 0u;
  }
  o_count = count;
}
