// What every pass may ask about a facet. Unit frame: the part's diagonal is 1.
uniform samplerBuffer t_planes;        // per facet: outward unit normal n and offset c; n.x = c on the facet
uniform usamplerBuffer t_facet_class;  // per facet, for the parting direction; maybe with k_left_out

const uint k_up = 0u;
const uint k_down = 1u;
const uint k_near_vertical = 2u;
const uint k_left_out = 4u;  // added to the class of a facet whose samples are not counted

vec4 facet_plane(uint facet) { return texelFetch(t_planes, int(facet)); }
uint facet_class(uint facet) { return texelFetch(t_facet_class, int(facet)).r & 3u; }
bool is_left_out(uint facet) { return (texelFetch(t_facet_class, int(facet)).r & k_left_out) != 0u; }
