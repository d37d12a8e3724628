#include "parting/plain_mold.hpp"

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "classify/figure_table.hpp"

namespace moldlight {

PlainMold::PlainMold(const PiecesWish& asked)
    : wish(asked),
      frame{asked.plain.frame, asked.plain.centre, asked.model.frame.diagonal},
      part(in_mold(asked.plain, asked.model.part.mesh, asked.model.frame.diagonal)),
      of_inserts(actions_of_inserts(asked.plain, asked.split, asked.plan)) {
  for (const MoldBody& insert : asked.plain.inserts) inserts.push_back(as_in_part(insert.mesh));
}

TriangleMesh PlainMold::as_in_part(const TriangleMesh& body) const {
  return unscaled(wish.plain, body, wish.model.frame.diagonal);
}

glm::dvec3 PlainMold::way_of(std::size_t action) const {
  glm::dvec3 way = wish.plain.frame.to_mold(wish.plan.actions[action].direction);
  way.z = 0.0;
  for (const int axis : {0, 1}) {
    if (std::abs(way[axis]) < k_inclined) way[axis] = 0.0;
  }
  return glm::normalize(way);
}

std::vector<glm::dvec3> PlainMold::released_by(std::size_t action) const {
  std::vector<glm::dvec3> corners;
  for (std::size_t piece = 0; piece < wish.split.pieces.size(); ++piece) {
    if (wish.plan.action_of_piece[piece] != static_cast<std::int32_t>(action)) continue;
    for (std::size_t k = 0; k < 3; ++k) corners.push_back(frame.in_mold(wish.split.corner(piece, k)));
  }
  return corners;
}

std::string PlainMold::stands_text(std::string_view what, const glm::dvec3& place) const {
  return fmt::format("{} stands in its way, near {}", what,
                     FigureStyle(wish.model).point(frame.in_part(place)));
}

}  // namespace moldlight
