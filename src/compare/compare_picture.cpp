#include "compare/compare_picture.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "classify/view_choice.hpp"
#include "compare/lit_surface.hpp"
#include "picture/canvas.hpp"

namespace moldlight {

namespace {

/// Of the diagonal: by how much lit surface stands out.
constexpr double k_raised = 0.003;

/// A thin plate on each polygon: closed, as bodies of pictures are.
class Plates {
 public:
  explicit Plates(double thickness) : thickness_(thickness) {}

  void add(const ConvexPolygon& polygon, const glm::dvec3& normal) {
    const auto count = static_cast<VertexIndex>(polygon.size());
    const auto first = static_cast<VertexIndex>(mesh.vertices.size());
    for (const double height : {-thickness_, thickness_})
      for (const glm::dvec3& corner : polygon) mesh.vertices.push_back(corner + height * normal);
    for (VertexIndex k = 2; k < count; ++k) {
      mesh.facets.push_back({first, first + k, first + k - 1});
      mesh.facets.push_back({first + count, first + count + k - 1, first + count + k});
    }
    for (VertexIndex k = 0; k < count; ++k) {
      const VertexIndex next = (k + 1) % count;
      mesh.facets.push_back({first + k, first + next, first + count + next});
      mesh.facets.push_back({first + k, first + count + next, first + count + k});
    }
  }

  TriangleMesh mesh;

 private:
  double thickness_;
};

const ComparedPart& part_of(const Comparison& comparison, Revision revision) {
  return revision == Revision::former ? comparison.a : comparison.b;
}

}  // namespace

std::vector<StillBody> lit_bodies(const Comparison& comparison, Revision revision) {
  const ComparedPart& part = part_of(comparison, revision);
  const double thickness = k_raised * part.model->frame.diagonal;
  const std::vector<LitPolygon> lit = lit_surface(comparison, revision == Revision::former);
  std::vector<StillBody> bodies;
  for (const Lit what : {Lit::gone, Lit::fresh, Lit::other_region}) {
    Plates plates(thickness);
    for (const LitPolygon& one : lit) {
      if (one.what == what)
        plates.add(*one.polygon, part.model->geometry.normals[part.result.split->pieces[one.piece].facet]);
    }
    if (!plates.mesh.facets.empty())
      bodies.push_back(
          {std::move(plates.mesh), glm::dmat4(1.0), lit_colour(what), std::string(lit_name(what))});
  }
  return bodies;
}

glm::dquat lit_seen_from(const Comparison& comparison) {
  const bool former = comparison.surface.gone.area > comparison.surface.fresh.area;
  const ComparedPart& part = former ? comparison.a : comparison.b;
  const std::shared_ptr<const SplitMesh> marked = marked_split(part, lit_surface(comparison, former));
  return revealing_orientation(*part.model, std::span(&marked, 1), part.result.direction);
}

Image comparison_picture(const gl::Context& context, const Comparison& comparison, StillSettings settings,
                         const Progress& progress) {
  validate(settings);
  const glm::ivec2 whole = settings.size;
  if (!settings.seen_from) settings.seen_from = lit_seen_from(comparison);
  Canvas canvas(whole.x, whole.y);
  settings.size.x = std::max(whole.x / 2, k_least_picture_px);
  const double half = 0.5 * whole.x;
  for (const Revision revision : {Revision::former, Revision::fresh}) {
    const ComparedPart& part = part_of(comparison, revision);
    const std::vector<StillBody> bodies = lit_bodies(comparison, revision);
    const Image image = StillPainter(context, part.model).draw(part.result, settings, progress, bodies);
    canvas.picture(image,
                   {{revision == Revision::former ? 0.0 : half, 0.0}, {half, static_cast<double>(whole.y)}});
  }
  return canvas.image();
}

}  // namespace moldlight
