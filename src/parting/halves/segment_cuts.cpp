#include "parting/halves/segment_cuts.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

void cut_segments(Sheets& sheets, const std::vector<SegmentCut>& cuts) {
  std::unordered_map<std::uint64_t, std::vector<PlanePoint>> on_segment;
  for (const SegmentCut& cut : cuts) on_segment[Sheets::edge_key(cut.a, cut.b)].push_back(cut.at);
  Sheets::OnEdges on_edges;
  for (const Sheet sheet : {Sheet::upper, Sheet::lower, Sheet::hidden, Sheet::beside, Sheet::parting}) {
    for (const SheetEdge& edge : sheets.ends(Sheets::bit(sheet))) {
      const auto [low, high] = std::minmax(edge.from, edge.to);
      const auto found = on_segment.find(Sheets::edge_key(sheets.column_of[low], sheets.column_of[high]));
      if (sheets.column_of[low] == k_no_plane_point || sheets.column_of[high] == k_no_plane_point ||
          found == on_segment.end() || on_edges.contains(Sheets::edge_key(low, high)))
        continue;
      const glm::dvec2 a(sheets.vertices[low]), b(sheets.vertices[high]);
      std::vector<std::pair<double, PlanePoint>> places;
      for (const PlanePoint column : found->second)
        places.emplace_back(glm::dot(sheets.columns[column] - a, b - a) / glm::dot(b - a, b - a), column);
      std::ranges::sort(places);
      std::vector<SheetVertex>& list = on_edges[Sheets::edge_key(low, high)];
      const double z_low = sheets.vertices[low].z, z_high = sheets.vertices[high].z;
      for (const auto& [share, column] : places) {
        if (!list.empty() && sheets.column_of[list.back()] == column) continue;
        list.push_back(sheets.add_vertex(column, glm::mix(z_low, z_high, share)));
      }
    }
  }
  sheets.divide_edges(on_edges);
}

}  // namespace moldlight
