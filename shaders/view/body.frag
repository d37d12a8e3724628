#version 330 core
// A solid beside the part, over a finished picture: fainter where the part hides it.
uniform sampler2D t_depth;
uniform vec3 u_colour;         // sRGB
uniform vec2 u_opacity;        // seen, hidden
uniform vec3 u_toward_viewer;  // unit, where the solid stands as it was made
in vec3 v_normal;
layout(location = 0) out vec4 o_colour;

void main() {
  bool hidden = gl_FragCoord.z > texelFetch(t_depth, ivec2(gl_FragCoord.xy), 0).r + 1e-5;
  float light = 0.6 + 0.4 * abs(dot(normalize(v_normal), u_toward_viewer));
  o_colour = vec4(light * u_colour, hidden ? u_opacity.y : u_opacity.x);
}
