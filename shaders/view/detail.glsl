// What a picture shows on demand. Needs common/facets.glsl and view/sight.glsl.
uniform bool u_draft_colours;
uniform float u_draft_sines[6];  // ascending: limits between the seven colours
uniform vec3 u_draft[7];
uniform vec3 u_parting;
uniform float u_opened;      // how far core and cavity surface are moved apart
uniform float u_facet_edge;  // half width in pixels; 0: none
uniform vec3 u_facet_edge_colour;
uniform float u_level_step;  // between level lines on near-vertical facets; 0: none
uniform vec3 u_level_colour;
uniform vec3 u_cut_colour;
uniform float u_cut_pitch;  // of its stripes, pixels
uniform samplerBuffer t_positions;  // three floats a vertex, one a texel
uniform usamplerBuffer t_corners;   // three vertices a facet, one a texel
uniform mat4 u_pixel_from_unit;     // pixels before the division by w
uniform float u_pixel_length;       // at the target, unit frame

vec3 shift_of(uint bits) { return (bits == 1u ? u_opened : bits == 2u ? -u_opened : 0.0) * u_parting; }

vec2 corner_pixel(uint facet, int corner, vec3 shift) {
  int vertex = 3 * int(texelFetch(t_corners, 3 * int(facet) + corner).r);
  vec3 position = vec3(texelFetch(t_positions, vertex).r, texelFetch(t_positions, vertex + 1).r,
                       texelFetch(t_positions, vertex + 2).r);
  vec4 pixel = u_pixel_from_unit * vec4(position + shift, 1.0);
  return pixel.xy / pixel.w;
}

float distance_to_line(vec2 at, vec2 a, vec2 b) {
  vec2 along = b - a;
  return abs(along.x * (at.y - a.y) - along.y * (at.x - a.x)) / max(length(along), 1e-6);
}

void detail(vec2 at, uint facet, uint bits, bool cut, inout vec3 albedo, inout float hatch) {
  vec4 plane = facet_plane(facet);
  vec3 shift = shift_of(bits);
  if (u_draft_colours && !cut) {
    float sine = dot(plane.xyz, u_parting);
    int band = 0;
    for (int i = 0; i < 6; ++i) band += sine >= u_draft_sines[i] ? 1 : 0;
    albedo = u_draft[band];
    hatch = 0.0;
  }
  if (u_level_step > 0.0 && facet_class(facet) == k_near_vertical && !cut) {
    vec3 position = on_plane(at, plane + vec4(0.0, 0.0, 0.0, dot(plane.xyz, shift)));
    float level = dot(position - shift, u_parting);
    float a_pixel = u_pixel_length / u_level_step;
    float from_line = abs(fract(level / u_level_step) - 0.5) - 0.5 + 0.9 * a_pixel;
    albedo = mix(albedo, u_level_colour, 0.7 * clamp(from_line / a_pixel + 0.5, 0.0, 1.0));
  }
  if (u_facet_edge > 0.0 && !cut) {
    vec2 a = corner_pixel(facet, 0, shift), b = corner_pixel(facet, 1, shift), c = corner_pixel(facet, 2, shift);
    float nearest = min(min(distance_to_line(at, a, b), distance_to_line(at, b, c)), distance_to_line(at, c, a));
    albedo = mix(albedo, u_facet_edge_colour, 0.55 * clamp(u_facet_edge + 0.5 - nearest, 0.0, 1.0));
  }
  if (cut) {
    float across = abs(fract((at.x - at.y) * 0.70711 / u_cut_pitch) - 0.5) * u_cut_pitch;
    albedo = u_cut_colour * (1.0 - 0.25 * clamp(across - 0.36 * u_cut_pitch, 0.0, 1.0));
    ivec2 pixel = ivec2(at);
    for (int i = 0; i < 4; ++i) {
      ivec2 beside = pixel + ivec2((i & 1) * 2 - 1, 0) * (1 - (i >> 1)) + ivec2(0, (i & 1) * 2 - 1) * (i >> 1);
      if (!surface_is_cut(texelFetch(t_surface, beside, 0).rg)) albedo = vec3(0.0);
    }
    hatch = 0.0;
  }
}
