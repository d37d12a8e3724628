#version 330 core
// A shadow map's depth as gray: the mean over the texels that a pixel covers, four by four of them at most.
uniform sampler2DArray t_depths;
uniform int u_layer;
uniform vec2 u_size;
layout(location = 0) out vec4 o_colour;

void main() {
  vec2 texels = vec2(textureSize(t_depths, 0).xy);
  float covered = 0.0, sum = 0.0;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      vec2 place = (floor(gl_FragCoord.xy) + (vec2(x, y) + 0.5) / 4.0) / u_size;
      float depth = texelFetch(t_depths, ivec3(place * texels, u_layer), 0).r;
      if (depth < 1.0) {
        covered += 1.0;
        sum += depth;
      }
    }
  }
  float gray = covered > 0.0 ? mix(0.95, 0.12, sum / covered) : 0.0;
  o_colour = vec4(vec3(gray), covered / 16.0);
}
