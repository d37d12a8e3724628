// What every pass may ask about a facet. Unit frame: the part's diagonal is 1.
uniform samplerBuffer t_planes;        // per facet: outward unit normal n and offset c; n.x = c on the facet
uniform usamplerBuffer t_facet_class;  // per facet, for the parting direction

const uint k_up = 0u;
const uint k_down = 1u;
const uint k_near_vertical = 2u;

vec4 facet_plane(uint facet) { return texelFetch(t_planes, int(facet)); }
uint facet_class(uint facet) { return texelFetch(t_facet_class, int(facet)).r; }
