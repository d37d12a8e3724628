// What every pass may ask about a facet. Unit frame: the part's diagonal is 1.
#ifdef GL_ES
// There are no buffer textures there: facets lie in rows.
uniform sampler2D t_planes;
uniform usampler2D t_facet_class;
ivec2 facet_texel(uint facet) { return ivec2(facet & 2047u, facet >> 11u); }
#define FACET(texels, facet) texelFetch(texels, facet_texel(facet), 0)
#else
uniform samplerBuffer t_planes;        // per facet: outward unit normal n and offset c; n.x = c on the facet
uniform usamplerBuffer t_facet_class;  // per facet, for the parting direction; maybe with k_left_out
#define FACET(texels, facet) texelFetch(texels, int(facet))
#endif

const uint k_up = 0u;
const uint k_down = 1u;
const uint k_near_vertical = 2u;
const uint k_left_out = 4u;  // added to the class of a facet whose samples are not counted

vec4 facet_plane(uint facet) { return FACET(t_planes, facet); }
uint facet_class(uint facet) { return FACET(t_facet_class, facet).r & 3u; }
bool is_left_out(uint facet) { return (FACET(t_facet_class, facet).r & k_left_out) != 0u; }
