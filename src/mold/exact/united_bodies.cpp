#include "mold/exact/united_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/orient.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/exact/exact_part.hpp"
#include "mold/exact/facet_cells.hpp"
#include "mold/exact/projected_part.hpp"
#include "mold/exact/split_assembly.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_union_grain = 256;  // facets a task

/// Labels of the cells.
constexpr Region k_outside = Region::core, k_inside_material = Region::undercut;

/// The part along three directions across each other that none of its own is likely to be: every facet is
/// seen well along one of them.
class Views {
 public:
  Views(const ExactPart& part, const Progress& progress) {
    const glm::dvec3 z(std::sqrt(1.0 / 6.0), std::sqrt(1.0 / 3.0), std::sqrt(1.0 / 2.0));
    const glm::dvec3 x = glm::normalize(glm::cross(z, glm::dvec3(0.3, -0.8, 0.52)));
    for (const glm::dvec3& direction : {x, glm::cross(z, x), z})
      views_.emplace_back(part, direction, progress);
  }
  [[nodiscard]] const ProjectedPart& of(const glm::dvec3& normal) const {
    const ProjectedPart* best = &views_.front();
    for (const ProjectedPart& view : views_) {
      if (std::abs(glm::dot(view.frame().z, normal)) > std::abs(glm::dot(best->frame().z, normal)))
        best = &view;
    }
    return *best;
  }

 private:
  std::vector<ProjectedPart> views_;
};

/// The part's facets, cut where others cross them, each piece labelled.
SplitMesh cut_at_crossings(const ExactPart& part, const Progress& progress) {
  const Views views(part, progress);
  const std::vector<glm::dvec3>& positions = part.positions();
  SplitAssembly assembly(part);
  progress.report("uniting bodies", 0.0);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, part.mesh().facets.size(), k_union_grain), [&](const auto& range) {
        FacetCells cells;
        std::vector<CutSegment> segments;
        for (std::size_t k = range.begin(); k < range.end() && !progress.cancelled(); ++k) {
          const auto facet = static_cast<FacetIndex>(k);
          const auto& [a, b, c] = part.mesh().facets[facet];
          const glm::dvec3& normal = part.geometry().normals[facet];
          if (normal == glm::dvec3(0.0)) continue;
          const glm::dvec3 origin = positions[a], along = glm::normalize(positions[b] - origin);
          const glm::dvec3 across = glm::cross(normal, along);
          const auto in_plane = [&](const glm::dvec3& point) {
            return glm::dvec2(glm::dot(along, point - origin), glm::dot(across, point - origin));
          };
          const ProjectedPart& view = views.of(normal);
          const auto label = [&](const glm::dvec2& place) {
            if (progress.cancelled()) throw Cancelled();
            const glm::dvec3 point = origin + place.x * along + place.y * across;
            return view.winding_in_front(view.turned(point), facet) != 0 ? k_inside_material : k_outside;
          };
          const std::array<glm::dvec2, 3> corners = {in_plane(positions[a]), in_plane(positions[b]),
                                                     in_plane(positions[c])};
          segments.clear();
          for (const FacetCrossing& crossing : part.crossings(facet))
            segments.push_back({in_plane(crossing.start), in_plane(crossing.end)});
          if (segments.empty()) {
            cells.keep_whole(label((corners[0] + corners[1] + corners[2]) / 3.0), 0.0);
          } else {
            cells.cut(corners, segments, {}, true, label);
          }
          assembly.add(facet, cells);
        }
      });
  progress.report("uniting bodies", 1.0);
  return assembly.finish(progress);
}

}  // namespace

UnionReport unite_bodies(Part& part, const Progress& progress) {
  UnionReport report;
  turn_if_inside_out(part.mesh);
  const FacetGeometry geometry = facet_geometry(part.mesh);
  const ExactPart exact(part.mesh, geometry, unit_frame(bounds(part.mesh)), progress, part.effort,
                        {.coplanar = true});
  if (!exact.closed())
    throw Error(
        part.file +
        ": its bodies are not closed or not wound one way, so that what is inside is not known; close "
        "them to unite them, or do without --repair union");
  if (!exact.crossings_known())
    throw Error(part.file +
                ": its facets cross too many others to unite its bodies; raise --effort, or take one of them "
                "(--body)");
  for (FacetIndex facet = 0; facet < part.mesh.facets.size(); ++facet)
    if (!exact.crossings(facet).empty()) ++report.cut_facets;
  SplitMesh split = cut_at_crossings(exact, progress);

  std::vector<std::uint32_t> body_of(part.mesh.facets.size(), 0);
  for (std::uint32_t k = 0; k < part.bodies.size(); ++k) {
    const Body& body = part.bodies[k];
    std::fill_n(body_of.begin() + body.first_facet, body.facet_count, k);
  }
  TriangleMesh mesh{.vertices = std::move(split.vertices), .facets = {}};
  std::vector<FacetIndex> sources;
  for (const SplitPiece& piece : split.pieces) {
    if (piece.region == k_inside_material) continue;
    mesh.facets.push_back(piece.corners);
    sources.push_back(piece.facet);
  }
  const auto carried = [&](const std::vector<std::uint32_t>& former) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(sources.size());
    for (const FacetIndex facet : sources) numbers.push_back(former.empty() ? facet : former[facet]);
    return numbers;
  };
  if (!part.facet_source.empty()) part.facet_source = carried(part.facet_source);
  part.file_facets = carried(part.file_facets);
  for (Body& body : part.bodies) body.facet_count = 0;
  for (const FacetIndex facet : sources) ++part.bodies[body_of[facet]].facet_count;
  FacetIndex first = 0;
  for (Body& body : part.bodies) body.first_facet = std::exchange(first, first + body.facet_count);
  std::erase_if(part.bodies, [](const Body& body) { return body.facet_count == 0; });
  report.inside_area = geometry.total_area - facet_geometry(mesh).total_area;
  part.mesh = std::move(mesh);
  return report;
}

void mend_part(Part& part, const RepairOptions& options, const Progress& progress) {
  repair_part(part, options, progress);
  if (options.level != RepairLevel::unite || part.mesh.facets.empty()) return;
  std::vector<std::string> repairs = std::move(part.repairs);
  const UnionReport united = unite_bodies(part, progress);
  const std::size_t open = close_cuts(part, progress);
  repairs.push_back(fmt::format("bodies united: {} facets cut, {}{} of surface inside others dropped{}",
                                united.cut_facets, rounded(united.inside_area),
                                part.unit.empty() ? "" : " " + part.unit + "²",
                                open > 0 ? fmt::format(", {} open edges left", open) : ""));
  part.repairs = std::move(repairs);
}

}  // namespace moldlight
