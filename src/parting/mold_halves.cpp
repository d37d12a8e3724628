#include "parting/mold_halves.hpp"

#include <algorithm>

namespace moldlight {

std::size_t MoldHalves::slide_count() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(inserts, [](const MoldBody& body) { return !body.blanks.empty(); }));
}

double MoldHalves::slide_volume() const {
  double sum = 0.0;
  for (const MoldBody& body : inserts) sum += body.blanks.empty() ? 0.0 : body.volume;
  return sum;
}

glm::dmat4 to_part_of(const MoldHalves& halves) {
  if (halves.written.part_frame) return glm::dmat4(1.0);
  const MoldFrame& frame = halves.frame;
  return {{frame.x, 0.0}, {frame.y, 0.0}, {frame.z, 0.0}, {halves.scale * halves.centre, 1.0}};
}

glm::dvec3 insert_place(const MoldHalves& halves, std::size_t insert) {
  return halves.centre + halves.frame.to_part(bounds(halves.inserts[insert].mesh).center() / halves.scale);
}

}  // namespace moldlight
