#version 330 core
// One fragment sums up to u_summed counts beside each other in a row.
uniform usampler2D t_counts;
uniform int u_width;   // counts in a row
uniform int u_summed;
layout(location = 0) out uvec4 o_counts;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  int first = at.x * u_summed;
  o_counts = uvec4(0u);
  for (int x = first; x < min(first + u_summed, u_width); ++x) o_counts += texelFetch(t_counts, ivec2(x, at.y), 0);
}
