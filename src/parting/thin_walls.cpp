#include "parting/thin_walls.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "mesh/facet_geometry.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

namespace {

/// What a thin wall costs whose two faces one half forms, where another height gives them to both: of its
/// length, for each time that it is higher than it is thick. The steel has a slot as deep and narrow.
constexpr double k_slot_weight = 0.005;
constexpr std::uint64_t k_slot_places = 4;  // of a piece
constexpr double k_thin_wall = 0.1;         // of the diagonal, at most

}  // namespace

std::vector<ThinWall> thin_walls(const PartModel& model, const SplitMesh& mesh,
                                 const std::vector<std::uint8_t>& free) {
  constexpr double k_inward = 1e-6, k_opposite = -0.7;  // unit frame; cosine at most
  std::vector<std::vector<PieceIndex>> pieces_of(model.part.mesh.facets.size());
  for (PieceIndex piece = 0; piece < mesh.pieces.size(); ++piece)
    pieces_of[mesh.pieces[piece].facet].push_back(piece);
  std::vector<ThinWall> found;
  for (PieceIndex piece = 0; piece < mesh.pieces.size(); ++piece) {
    if (free[piece] == 0) continue;
    const glm::dvec3& normal = model.geometry.normals[mesh.pieces[piece].facet];
    const double area = 0.5 * glm::length(twice_piece_area(mesh, piece)) / k_slot_places;
    for (std::uint64_t k = 0; k < k_slot_places; ++k) {
      const glm::dvec3 at =
          triangle_place(k).in(mesh.corner(piece, 0), mesh.corner(piece, 1), mesh.corner(piece, 2));
      const glm::dvec3 from = (at - model.frame.center) / model.frame.diagonal - k_inward * normal;
      const auto hit = model.rays().first_hit(glm::vec3(from), glm::vec3(-normal), false);
      if (!hit || static_cast<double>(hit->distance) > k_thin_wall ||
          glm::dot(model.geometry.normals[hit->facet], normal) > k_opposite)
        continue;
      const double thickness = model.frame.diagonal * std::max(k_inward, static_cast<double>(hit->distance));
      const glm::dvec3 there = at - thickness * normal;
      const PieceIndex other = *std::ranges::min_element(pieces_of[hit->facet], {}, [&](PieceIndex one) {
        return glm::distance(
            nearest_in_triangle(there, {mesh.corner(one, 0), mesh.corner(one, 1), mesh.corner(one, 2)}),
            there);
      });
      found.push_back({piece, other, k_slot_weight * area / thickness});
    }
  }
  return found;
}

}  // namespace moldlight
