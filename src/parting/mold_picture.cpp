#include "parting/mold_picture.hpp"

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

constexpr double k_gap = 0.15;           // between the bodies, in diagonals of the part
constexpr double k_tube_radius = 0.007;  // of the line, in diagonals
constexpr int k_tube_sides = 16;

class SceneMesh {
 public:
  template <typename Place>
  void add(const TriangleMesh& mesh, Region region, const Place& place) {
    const auto first = static_cast<VertexIndex>(scene.mesh.vertices.size());
    for (const glm::dvec3& vertex : mesh.vertices) scene.mesh.vertices.push_back(place(vertex));
    for (const auto& facet : mesh.facets)
      scene.mesh.facets.push_back({first + facet[0], first + facet[1], first + facet[2]});
    scene.regions.insert(scene.regions.end(), mesh.facets.size(), region);
  }

  MoldSceneMesh scene;
};

/// A round tube around a closed line; points nearer to each other than its radius are left out.
TriangleMesh tube_around(const std::vector<glm::dvec3>& loop, double radius) {
  std::vector<glm::dvec3> points;
  for (const glm::dvec3& point : loop) {
    if (points.empty() || glm::distance(points.back(), point) > radius) points.push_back(point);
  }
  while (points.size() > 1 && glm::distance(points.back(), points.front()) <= radius) points.pop_back();
  TriangleMesh mesh;
  if (points.size() < 3) return mesh;
  const std::size_t count = points.size();
  glm::dvec3 normal(0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec3 along =
        glm::normalize(points[(k + 1) % count] - points[(k + count - 1) % count] + glm::dvec3(1e-12));
    // The last section's normal, turned no more than it must be.
    normal -= along * glm::dot(normal, along);
    if (glm::length(normal) < 1e-3)
      normal = glm::cross(along, std::abs(along.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0));
    normal = glm::normalize(normal);
    const glm::dvec3 side = glm::cross(along, normal);
    for (int s = 0; s < k_tube_sides; ++s) {
      const double angle = 2.0 * std::numbers::pi * s / k_tube_sides;
      mesh.vertices.push_back(points[k] + radius * (std::cos(angle) * normal + std::sin(angle) * side));
    }
  }
  const auto at = [&](std::size_t section, std::size_t side) {
    return static_cast<VertexIndex>(section % count * k_tube_sides + side % k_tube_sides);
  };
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t s = 0; s < k_tube_sides; ++s) {
      mesh.facets.push_back({at(k, s), at(k + 1, s), at(k + 1, s + 1)});
      mesh.facets.push_back({at(k, s), at(k + 1, s + 1), at(k, s + 1)});
    }
  }
  return mesh;
}

}  // namespace

MoldSceneMesh mold_scene_mesh(const MoldScene& scene) {
  const PartModel& model = scene.model;
  const MoldHalves& halves = scene.halves;
  const double diagonal = model.frame.diagonal, scale = halves.scale;
  glm::dvec3 away(0.0);  // of the part from its place in the mold
  SceneMesh mesh;
  if (halves.made()) {
    const Bounds core = bounds(halves.core.mesh), cavity = bounds(halves.cavity.mesh);
    // For who looks from a corner: the halves side by side, the part behind them and above.
    const Bounds whole = model.health.bounds;
    const glm::dvec3 block = core.max - core.min,
                     inner = scale * glm::abs(halves.frame.to_mold(whole.max - whole.min));
    const double gap = k_gap * diagonal * scale, step = 0.25 * (block.x + block.y) + 0.5 * gap;
    // Both halves stand on their lids.
    const double lower = core.max.z + cavity.min.z;
    away.x = -0.5 * (inner.x + gap);
    away.y = 0.5 * (inner.y + gap);
    const double top = std::max(cavity.max.z, lower - core.min.z);
    away.z =
        std::max(0.0, top + 0.5 * inner.z - scale * halves.frame.to_mold(whole.center() - halves.centre).z);
    mesh.add(halves.cavity.mesh, Region::cavity,
             [&](const glm::dvec3& v) { return v + glm::dvec3(step, step, 0); });
    mesh.add(halves.core.mesh, Region::core,
             [&](const glm::dvec3& v) { return glm::dvec3(v.x - step, -v.y - step, lower - v.z); });
  }
  const auto out = [&](const glm::dvec3& v) { return v + away; };
  const auto in_place = [&](const glm::dvec3& at) {
    return out(scale * halves.frame.to_mold(at - halves.centre));
  };
  mesh.add(model.part.mesh, Region::both, in_place);
  for (const MoldBody& insert : halves.inserts) mesh.add(insert.mesh, Region::undercut, out);
  for (const PartingLoop& loop : scene.line.loops) {
    if (loop.kind == LoopKind::action) continue;
    std::vector<glm::dvec3> points;
    for (const glm::dvec3& point : loop.points) points.push_back(in_place(point));
    mesh.add(tube_around(points, k_tube_radius * diagonal * scale), Region::undercut,
             [](const glm::dvec3& v) { return v; });
  }
  return std::move(mesh.scene);
}

Image mold_picture(const gl::Context& context, const MoldScene& scene, StillSettings settings,
                   const Progress& progress) {
  MoldSceneMesh drawn = mold_scene_mesh(scene);
  Part part;
  part.file = scene.model.part.file;
  part.unit = scene.model.part.unit;
  part.mesh = std::move(drawn.mesh);
  part.bodies = {{"mold", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  const std::shared_ptr<const PartModel> model = prepare_part(std::move(part), progress);
  auto split = std::make_shared<SplitMesh>();
  split->vertices = model->part.mesh.vertices;
  for (FacetIndex facet = 0; facet < model->part.mesh.facets.size(); ++facet)
    split->pieces.push_back({model->part.mesh.facets[facet], facet, drawn.regions[facet]});
  Classification shown;
  shown.direction = {0, 0, 1};
  shown.total_area = model->geometry.total_area;
  shown.split = std::move(split);
  settings.legend = false;
  settings.look.arrows = false;
  settings.look.hatching = false;
  if (settings.view == PictureView::automatic) settings.view = PictureView::isometric;
  return StillPainter(context, model).draw(shown, settings, progress);
}

}  // namespace moldlight
