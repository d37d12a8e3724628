#version 330 core
// A sample from sRGB to squares, to be added up.
uniform sampler2D t_colour;
layout(location = 0) out vec4 o_light;
void main() {
  vec4 colour = texelFetch(t_colour, ivec2(gl_FragCoord.xy), 0);
  o_light = vec4(colour.rgb * colour.rgb * colour.a, colour.a);
}
