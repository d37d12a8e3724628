#include "io/polygon_part_builder.hpp"

#include "io/file_contents.hpp"
#include "mesh/polygon_triangulation.hpp"
#include "mesh/weld.hpp"

namespace moldlight {

namespace {

constexpr std::uint64_t k_base_cutting_work = 50'000'000;
constexpr std::uint64_t k_cutting_work_a_corner = 200;
constexpr std::size_t k_polygons_between_reports = 1 << 16;

/// Ends the last body and begins one; a body that got no facets goes, one of the same name goes on.
void begin_body(Part& part, const std::string& name) {
  const auto facets = static_cast<FacetIndex>(part.mesh.facets.size());
  if (!part.bodies.empty() && part.bodies.back().first_facet == facets) part.bodies.pop_back();
  if (part.bodies.empty() || part.bodies.back().name != name) part.bodies.push_back({name, facets, 0});
}

}  // namespace

void PolygonPartBuilder::add_vertex(const glm::dvec3& point) {
  if (vertices_.size() == k_max_vertices)
    context_.fail("", "holds more than {} vertices; split the part", k_max_vertices);
  vertices_.push_back(point);
}

void PolygonPartBuilder::add_polygon(std::span<const std::uint32_t> corners) {
  facets_ += corners.size() - 2;
  context_.check_facet_count(facets_);
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  polygon_ends_.push_back(corners_.size());
}

Part PolygonPartBuilder::finish(const std::vector<BodyStart>& bodies) {
  if (polygon_ends_.empty()) context_.fail("", "holds no facets; export the part as a mesh of polygons");
  context_.contents.release();
  check_memory(context_.path,
               2 * facets_ * sizeof(std::array<VertexIndex, 3>) + vertices_.size() * sizeof(glm::dvec3));
  Part part;
  part.warnings = std::move(warnings_);
  cut_polygons(part, bodies);
  part.mesh.vertices = std::move(vertices_);
  part.mesh = weld_vertices(part.mesh);
  return part;
}

void PolygonPartBuilder::cut_polygons(Part& part, const std::vector<BodyStart>& bodies) {
  part.mesh.facets.reserve(facets_);
  const bool all_triangles = facets_ == polygon_ends_.size();
  if (!all_triangles) part.facet_source.reserve(facets_);
  PolygonTriangulator triangulator(k_base_cutting_work + k_cutting_work_a_corner * corners_.size());
  std::vector<glm::dvec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t odd_polygons = 0, first_odd = 0, next_body = 0;
  std::uint64_t start = 0;
  begin_body(part, "");
  for (std::size_t polygon = 0; polygon < polygon_ends_.size(); ++polygon) {
    if (polygon % k_polygons_between_reports == 0) {
      context_.progress.report("cutting polygons",
                               static_cast<double>(polygon) / static_cast<double>(polygon_ends_.size()));
    }
    for (; next_body < bodies.size() && bodies[next_body].first_polygon <= polygon; ++next_body)
      begin_body(part, bodies[next_body].name);
    const std::span<const std::uint32_t> corners(corners_.data() + start, polygon_ends_[polygon] - start);
    start = polygon_ends_[polygon];
    if (corners.size() == 3) {
      part.mesh.facets.push_back({corners[0], corners[1], corners[2]});
    } else {
      points.clear();
      for (const std::uint32_t corner : corners) points.push_back(vertices_[corner]);
      if (triangulator.triangulate(points, triangles) == PolygonCut::fan_of_odd && odd_polygons++ == 0)
        first_odd = polygon;
      for (const auto& t : triangles)
        part.mesh.facets.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
    }
    if (!all_triangles)
      part.facet_source.resize(part.mesh.facets.size(), static_cast<std::uint32_t>(polygon));
  }
  for (std::size_t i = 0; i < part.bodies.size(); ++i) {
    const std::size_t end =
        i + 1 < part.bodies.size() ? part.bodies[i + 1].first_facet : part.mesh.facets.size();
    part.bodies[i].facet_count = static_cast<FacetIndex>(end - part.bodies[i].first_facet);
  }
  if (odd_polygons > 0) {
    part.warnings.push_back(
        fmt::format("{} polygons, the first of them polygon {}, cross themselves and were cut as fans; check "
                    "the surface there",
                    odd_polygons, first_odd));
  }
}

}  // namespace moldlight
