#include "render/view_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "base/check.hpp"
#include "mesh/adjacency.hpp"

namespace moldlight {

namespace {

constexpr int k_extreme_directions = 128;  // each with its opposite

/// The outermost vertices along directions spread evenly over a half-sphere, and their opposites; each once.
std::vector<glm::vec3> extreme_vertices(const std::vector<ViewVertex>& vertices) {
  std::vector<std::size_t> found;
  for (int k = 0; k < k_extreme_directions && !vertices.empty(); ++k) {
    const float z = (static_cast<float>(k) + 0.5F) / k_extreme_directions;
    const float angle = 2.3999632F * static_cast<float>(k);  // the golden angle
    const float radius = std::sqrt(1.0F - z * z);
    const glm::vec3 direction(radius * std::cos(angle), radius * std::sin(angle), z);
    std::size_t least = 0, most = 0;
    float low = std::numeric_limits<float>::infinity(), high = -low;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const float along = glm::dot(direction, vertices[i].position);
      if (along < low) {
        low = along;
        least = i;
      }
      if (along > high) {
        high = along;
        most = i;
      }
    }
    found.push_back(least);
    found.push_back(most);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<glm::vec3> points;
  for (const std::size_t vertex : found) points.push_back(vertices[vertex].position);
  return points;
}

/// The octahedron's lower half, folded out over the square's corners; its own inverse.
glm::vec2 folded(const glm::vec2& place) {
  return {std::copysign(1.0F - std::abs(place.y), place.x), std::copysign(1.0F - std::abs(place.x), place.y)};
}

constexpr float k_least_square = 1e-6F;  // of a mean normal; one shorter says nothing

/// Shares of a facet's corners in a point of it, sum 1; those of the first corner alone for a facet without
/// area.
glm::dvec3 corner_weights(const TriangleMesh& mesh, FacetIndex facet, const glm::dvec3& point) {
  const glm::dvec3& origin = mesh.corner(facet, 0);
  const glm::dvec3 to_1 = mesh.corner(facet, 1) - origin, to_2 = mesh.corner(facet, 2) - origin;
  const glm::dvec3 normal = glm::cross(to_1, to_2), at = point - origin;
  const double square = glm::dot(normal, normal);
  if (!(square > 0.0)) return {1.0, 0.0, 0.0};
  const double second = glm::dot(glm::cross(at, to_2), normal) / square;
  const double third = glm::dot(glm::cross(to_1, at), normal) / square;
  return {1.0 - second - third, second, third};
}

constexpr double k_gap = 0.035, k_length = 0.13, k_head_length = 0.048, k_head_radius = 0.0145,
                 k_shaft_radius = 0.0045;

ViewArrow arrow_from(const glm::dvec3& tail, const glm::dvec3& toward) {
  return {.tail = tail,
          .tip = tail + k_length * toward,
          .shaft_radius = k_shaft_radius,
          .head_radius = k_head_radius,
          .head_length = k_head_length};
}

constexpr double k_aside = 0.12;  // unit frame

/// Across the direction: the coordinate axis that lies most across it, turned about it.
glm::dvec3 across(const glm::dvec3& direction, double turn_deg) {
  const glm::dvec3 size = glm::abs(direction);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                          : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                               : glm::dvec3(0, 0, 1);
  const glm::dvec3 start = glm::normalize(axis - glm::dot(axis, direction) * direction);
  const double turn = glm::radians(turn_deg);
  return std::cos(turn) * start + std::sin(turn) * glm::cross(direction, start);
}

}  // namespace

std::array<std::int16_t, 2> octahedral(const glm::vec3& vector) {
  const glm::vec2 flat = glm::vec2(vector) / (std::abs(vector.x) + std::abs(vector.y) + std::abs(vector.z));
  const glm::vec2 place = vector.z < 0.0F ? folded(flat) : flat;
  const auto step = [](float value) { return static_cast<std::int16_t>(std::lround(32767.0F * value)); };
  return {step(place.x), step(place.y)};
}

glm::vec3 from_octahedral(const std::array<std::int16_t, 2>& steps) {
  const glm::vec2 place = glm::vec2(steps[0], steps[1]) / 32767.0F;
  const float z = 1.0F - std::abs(place.x) - std::abs(place.y);
  return glm::normalize(glm::vec3(z < 0.0F ? folded(place) : place, z));
}

ViewGeometry view_geometry(const TriangleMesh& mesh, const FacetGeometry& geometry,
                           const Adjacency& adjacency, const UnitFrame& frame) {
  ViewGeometry view;
  SmoothCorners smooth = smooth_corners(mesh, geometry, adjacency);
  view.vertices.reserve(smooth.source.size());
  for (std::size_t i = 0; i < smooth.source.size(); ++i)
    view.vertices.push_back({frame.to_unit(mesh.vertices[smooth.source[i]]), octahedral(smooth.normals[i])});
  view.facets = std::move(smooth.of_facet);
  for (const EdgeEnds& edge : crease_edges(mesh, geometry, adjacency)) {
    view.feature_edges.push_back(
        {frame.to_unit(mesh.vertices[edge.a]), frame.to_unit(mesh.vertices[edge.b])});
  }
  view.extremes = extreme_vertices(view.vertices);
  view.closed = true;
  for (FacetIndex facet = 0; facet < mesh.facets.size() && view.closed; ++facet) {
    for (const FacetIndex across : adjacency.across[facet])
      if (across == k_no_facet && geometry.areas[facet] > 0.0) view.closed = false;
  }
  const std::vector<bool> solid = solid_facets(mesh, adjacency);
  view.all_solid = std::ranges::find(solid, false) == solid.end();
  for (FacetIndex facet = 0; facet < solid.size() && !view.all_solid; ++facet)
    if (solid[facet]) view.solids.push_back(view.facets[facet]);
  return view;
}

ViewGeometry shown_part(const ViewGeometry& whole, std::span<const std::uint8_t> hidden) {
  ViewGeometry shown = whole;
  const auto place_of = [](const glm::vec3& point) { return std::array{point.x, point.y, point.z}; };
  std::set<std::array<float, 3>> places;  // of what is left
  shown.solids.clear();
  shown.all_solid = false;
  for (std::size_t facet = 0; facet < whole.facets.size(); ++facet) {
    if (hidden[facet] != 0) {
      shown.facets[facet] = {};
      continue;
    }
    for (const VertexIndex corner : whole.facets[facet])
      places.insert(place_of(whole.vertices[corner].position));
    if (whole.all_solid) shown.solids.push_back(whole.facets[facet]);
  }
  const auto is_hidden = [&](const auto& corners) {
    return !places.contains(place_of(whole.vertices[corners[0]].position));
  };
  if (!whole.all_solid) {
    shown.solids = whole.solids;
    std::erase_if(shown.solids, is_hidden);
  }
  std::erase_if(shown.feature_edges,
                [&](const ViewSegment& edge) { return !places.contains(place_of(edge.start)); });
  return shown;
}

std::vector<ViewSegment> parting_line(const SplitMesh& split, const UnitFrame& frame) {
  std::vector<ViewSegment> segments;
  for (const RegionBorder& border : region_borders(split)) {
    if (border.left == Region::undercut || border.right == Region::undercut) continue;
    for (std::size_t k = 1; k < border.vertices.size(); ++k) {
      segments.push_back({frame.to_unit(split.vertices[border.vertices[k - 1]]),
                          frame.to_unit(split.vertices[border.vertices[k]])});
    }
  }
  return segments;
}

SplitGeometry split_geometry(const SplitMesh& split, const TriangleMesh& mesh, const ViewGeometry& view,
                             const UnitFrame& frame) {
  CHECK(mesh.facets.size() < k_surface_number_mask);
  SplitGeometry geometry;
  geometry.vertices.reserve(view.vertices.size() + 2 * (split.vertices.size() - mesh.vertices.size()));
  geometry.vertices = view.vertices;
  geometry.pieces.reserve(split.pieces.size());
  geometry.sources.reserve(split.pieces.size());
  // Of each vertex of the split mesh that is no corner of the facet at hand: the last facet that used it, and
  // its copy for that.
  struct Copy {
    FacetIndex facet = k_no_facet;
    VertexIndex vertex = 0;
  };
  std::vector<Copy> copies(split.vertices.size());
  const auto cut_vertex = [&](FacetIndex facet, VertexIndex number) {
    Copy& copy = copies[number];
    if (copy.facet != facet) {
      copy = {facet, static_cast<VertexIndex>(geometry.vertices.size())};
      const glm::dvec3 weights = corner_weights(mesh, facet, split.vertices[number]);
      glm::vec3 normal(0.0F);
      for (int k = 0; k < 3; ++k) {
        const VertexIndex corner = view.facets[facet][static_cast<std::size_t>(k)];
        normal += static_cast<float>(weights[k]) * from_octahedral(view.vertices[corner].normal);
      }
      const ViewVertex& first = view.vertices[view.facets[facet][0]];
      geometry.vertices.push_back(
          {frame.to_unit(split.vertices[number]),
           glm::dot(normal, normal) > k_least_square ? octahedral(normal) : first.normal});
    }
    return copy.vertex;
  };
  for (const SplitPiece& piece : split.pieces) {
    const auto& whole = mesh.facets[piece.facet];
    std::array<VertexIndex, 3> corners = view.facets[piece.facet];
    const bool hidden = corners[0] == corners[1] && whole[0] != whole[1];
    if (!hidden && piece.corners != whole) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto* corner = std::find(whole.begin(), whole.end(), piece.corners[k]);
        corners[k] = corner != whole.end()
                         ? view.facets[piece.facet][static_cast<std::size_t>(corner - whole.begin())]
                         : cut_vertex(piece.facet, piece.corners[k]);
      }
    }
    geometry.pieces.push_back(corners);
    geometry.sources.push_back(piece.facet | facts(piece.region).accessible << k_source_bits_shift);
  }
  return geometry;
}

ViewArrow parting_arrow(std::span<const glm::vec3> extremes, const glm::dvec3& toward, double open_mold) {
  double top = 0.0;
  for (const glm::vec3& point : extremes) top = std::max(top, glm::dot(glm::dvec3(point), toward));
  const glm::dvec3 tail = (top + open_mold * k_mold_travel + k_gap) * toward;
  return arrow_from(tail, toward);
}

ViewArrow section_arrow(const CutPlane& cut) { return arrow_from(cut.foot, cut.normal); }

ViewBody view_body(const TriangleMesh& mesh, const UnitFrame& frame, Colour colour) {
  ViewBody body;
  body.colour = colour;
  for (const auto& [a, b, c] : mesh.facets) {
    const glm::dvec3 normal =
        glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
    const double length = glm::length(normal);
    if (length <= 0.0) continue;
    const auto first = static_cast<VertexIndex>(body.vertices.size());
    body.facets.push_back({first, first + 1, first + 2});
    for (const VertexIndex vertex : {a, b, c})
      body.vertices.push_back({frame.to_unit(mesh.vertices[vertex]), octahedral(glm::vec3(normal / length))});
  }
  return body;
}

ViewSolid view_solid(const TriangleMesh& mesh, const UnitFrame& frame, Steel steel) {
  const double half = steel == Steel::core ? 1.0 : steel == Steel::cavity ? -1.0 : 0.0;
  ViewSolid solid{.body = view_body(mesh, frame, {}), .steel = steel, .edges = {}, .motion = {.half = half}};
  for (const EdgeEnds& edge : crease_edges(mesh, facet_geometry(mesh), build_adjacency(mesh)))
    solid.edges.push_back({frame.to_unit(mesh.vertices[edge.a]), frame.to_unit(mesh.vertices[edge.b])});
  return solid;
}

std::optional<CutPlane> SectionPlanes::plane(const LookSettings& look, const glm::dvec3& direction) {
  if (look.section == Section::off) return std::nullopt;
  // Of an axis the side goes that the usual view shows.
  const glm::dvec3 normal = look.section == Section::across  ? direction
                            : look.section == Section::along ? across(direction, look.section_turn_deg)
                            : look.section == Section::x     ? glm::dvec3(1, 0, 0)
                            : look.section == Section::y     ? glm::dvec3(0, -1, 0)
                                                             : glm::dvec3(0, 0, 1);
  if (normal != normal_) {
    normal_ = normal;
    least_ = std::numeric_limits<double>::infinity();
    greatest_ = -least_;
    for (const glm::dvec3& vertex : mesh_->vertices) {
      const double height = glm::dot(vertex - frame_->center, normal) / frame_->diagonal;
      least_ = std::min(least_, height);
      greatest_ = std::max(greatest_, height);
    }
  }
  const double extent = greatest_ - least_;
  const double offset = least_ + look.section_at * extent;
  // Beside the direction's own arrow.
  const glm::dvec3 aside =
      std::abs(glm::dot(normal, direction)) > 0.9 ? k_aside * across(normal, 45.0) : glm::dvec3(0.0);
  return CutPlane{.normal = normal, .offset = offset, .extent = extent, .foot = offset * normal + aside};
}

}  // namespace moldlight
