#version 330 core
// A line as a round tube with a dark rim, from how deep in it each fragment lies: where pieces of it overlap, the
// greatest depth is theirs together. What is hidden is faint.
uniform sampler2D t_tube;     // the line: seen, hidden; the chosen loop: seen, hidden
uniform vec3 u_colour;        // sRGB
uniform vec3 u_chosen_colour;
uniform vec2 u_radius_px;     // of the line, of the chosen loop; with the soft border
uniform float u_rim_px;
uniform vec2 u_hidden;        // opacity
uniform float u_paler;        // opacity of the line
layout(location = 0) out vec4 o_colour;

// With its opacity multiplied in.
vec4 tube(float deep, float radius_px, vec3 colour, float opacity) {
  float inside = deep * radius_px;
  float cover = clamp(inside, 0.0, 1.0) * opacity;
  float body = clamp(inside - u_rim_px, 0.0, 1.0);
  float share = clamp((inside - u_rim_px) / max(radius_px - u_rim_px, 1e-3), 0.0, 1.0);
  float round_light = sqrt(share * (2.0 - share));
  vec3 shaded = colour * (0.55 + 0.45 * round_light) + 0.35 * pow(round_light, 8.0) * (1.0 - colour);
  return vec4(mix(vec3(0.05, 0.05, 0.06), shaded, body), 1.0) * cover;
}

vec4 over(vec4 below, vec4 above) { return above + below * (1.0 - above.a); }

void main() {
  vec4 deep = texelFetch(t_tube, ivec2(gl_FragCoord.xy), 0);
  if (deep == vec4(0.0)) discard;
  vec4 sum = tube(deep.g, u_radius_px.x, u_colour, u_hidden.x * u_paler);
  sum = over(sum, tube(deep.a, u_radius_px.y, u_chosen_colour, u_hidden.y));
  sum = over(sum, tube(deep.r, u_radius_px.x, u_colour, u_paler));
  sum = over(sum, tube(deep.b, u_radius_px.y, u_chosen_colour, 1.0));
  o_colour = vec4(sum.rgb / max(sum.a, 1e-4), sum.a);
}
