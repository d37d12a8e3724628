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
uniform vec3 u_steel[16];    // core, cavity, insert; then what is moved
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

// What is no facet: the cut of the part, the mold's steel and its cuts, striped in turn. Cuts have an outline.
void detail_other(vec2 at, uvec2 surface, inout vec3 albedo) {
  uint number = surface_number(surface);
  bool steel = number_is_steel(number);
  albedo = steel ? u_steel[number_steel(number)] : u_cut_colour;
  if (!number_is_cut(number)) return;
  float slant = steel && number_steel(number) != 1u ? at.x + at.y : at.x - at.y;
  float pitch = u_cut_pitch * (steel && number_steel(number) == 1u ? 1.4 : 1.0);
  float across = abs(fract(slant * 0.70711 / pitch) - 0.5) * pitch;
  albedo *= 1.0 - 0.25 * clamp(across - 0.36 * pitch, 0.0, 1.0);
  ivec2 pixel = ivec2(at);
  for (int i = 0; i < 4; ++i) {
    ivec2 beside = pixel + ivec2((i & 1) * 2 - 1, 0) * (1 - (i >> 1)) + ivec2(0, (i & 1) * 2 - 1) * (i >> 1);
    if (texelFetch(t_surface, beside, 0).r != surface.x) albedo = vec3(0.0);
  }
}

void detail(uvec2 surface, uint facet, uint bits, inout vec3 albedo, inout float hatch) {
  vec2 at = gl_FragCoord.xy;
  if (surface_is_other(surface)) {
    detail_other(at, surface, albedo);
    hatch = 0.0;
    return;
  }
  vec4 plane = facet_plane(facet);
  vec3 shift = shift_of(bits);
  if (u_draft_colours) {
    float sine = dot(plane.xyz, u_parting);
    int band = 0;
    for (int i = 0; i < 6; ++i) band += sine >= u_draft_sines[i] ? 1 : 0;
    albedo = u_draft[band];
    hatch = 0.0;
  }
  if (u_level_step > 0.0 && facet_class(facet) == k_near_vertical) {
    vec3 position = on_plane(at, plane + vec4(0.0, 0.0, 0.0, dot(plane.xyz, shift)));
    float level = dot(position - shift, u_parting);
    float a_pixel = u_pixel_length / u_level_step;
    float from_line = abs(fract(level / u_level_step) - 0.5) - 0.5 + 0.9 * a_pixel;
    albedo = mix(albedo, u_level_colour, 0.7 * clamp(from_line / a_pixel + 0.5, 0.0, 1.0));
  }
  if (u_facet_edge > 0.0) {
    vec2 a = corner_pixel(facet, 0, shift), b = corner_pixel(facet, 1, shift), c = corner_pixel(facet, 2, shift);
    float nearest = min(min(distance_to_line(at, a, b), distance_to_line(at, b, c)), distance_to_line(at, c, a));
    albedo = mix(albedo, u_facet_edge_colour, 0.55 * clamp(u_facet_edge + 0.5 - nearest, 0.0, 1.0));
  }
}
