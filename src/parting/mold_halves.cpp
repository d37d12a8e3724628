#include "parting/mold_halves.hpp"

namespace moldlight {

glm::dvec3 insert_place(const MoldHalves& halves, std::size_t insert) {
  return halves.centre + halves.frame.to_part(bounds(halves.inserts[insert].mesh).center() / halves.scale);
}

}  // namespace moldlight
