#include "gui/chosen_face.hpp"

#include <algorithm>

#include "session/classify_report.hpp"

namespace moldlight::gui {

std::optional<ChosenFace> face_of(const PartModel& model, FacetIndex facet) {
  const std::vector<std::uint32_t>& sources = model.part.facet_source;
  if (sources.empty() || sources[facet] == k_no_facet) return std::nullopt;
  ChosenFace face{.number = sources[facet], .facets = {}, .figures = {}};
  for (FacetIndex other = 0; other < sources.size(); ++other) {
    if (sources[other] == face.number) face.facets.push_back(other);
  }
  return face;
}

std::optional<SourceAreas> face_figures(const PartModel& model, const Classification& result,
                                        std::uint32_t number) {
  const std::vector<SourceAreas> all = face_areas(model, result);
  const auto found = std::ranges::find(all, number, &SourceAreas::source);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

std::vector<ViewSegment> outline_of(const PartModel& model, const ChosenFace& face) {
  const TriangleMesh& mesh = model.part.mesh;
  const std::vector<std::uint32_t>& sources = model.part.facet_source;
  std::vector<ViewSegment> outline;
  for (const FacetIndex facet : face.facets) {
    for (int edge = 0; edge < 3; ++edge) {
      const FacetIndex across = model.adjacency.across[facet][static_cast<std::size_t>(edge)];
      if (across != k_no_facet && sources[across] == face.number) continue;
      outline.push_back({model.frame.to_unit(mesh.corner(facet, edge)),
                         model.frame.to_unit(mesh.corner(facet, (edge + 1) % 3))});
    }
  }
  return outline;
}

}  // namespace moldlight::gui
