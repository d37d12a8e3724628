#include "parting/assigned_facets.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "mesh/faces.hpp"

namespace moldlight {

std::vector<FacetWish> assigned_facets(const PartModel& model, const MoldSettings& settings) {
  std::vector<FacetWish> assigned(model.part.mesh.facets.size(), FacetWish::none);
  if (settings.cosmetic.empty()) return assigned;
  const Faces faces = part_faces(model.part, model.geometry, model.adjacency);
  for (const CosmeticFaces& half : parse_cosmetic(settings.cosmetic)) {
    for (const std::uint32_t face : half.faces) {
      if (face >= faces.count())
        throw UsageError(
            fmt::format("--cosmetic: there is no face {}; the part has 0 to {}", face, faces.count() - 1));
      for (const FacetIndex facet : faces.facets(face))
        assigned[facet] = half.core ? FacetWish::core : FacetWish::cavity;
    }
  }
  return assigned;
}

}  // namespace moldlight
