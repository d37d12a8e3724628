#include "parting/wished_facets.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "mesh/faces.hpp"

namespace moldlight {

std::vector<FacetWish> wished_facets(const PartModel& model, const MoldSettings& settings) {
  std::vector<FacetWish> wished(model.part.mesh.facets.size(), FacetWish::none);
  if (settings.cosmetic.empty()) return wished;
  const Faces faces = part_faces(model.part, model.geometry, model.adjacency);
  for (const CosmeticFaces& half : parse_cosmetic(settings.cosmetic)) {
    for (const std::uint32_t face : half.faces) {
      if (face >= faces.count())
        throw UsageError(
            fmt::format("--cosmetic: there is no face {}; the part has 0 to {}", face, faces.count() - 1));
      for (const FacetIndex facet : faces.facets(face))
        wished[facet] = half.core ? FacetWish::core : FacetWish::cavity;
    }
  }
  return wished;
}

}  // namespace moldlight
