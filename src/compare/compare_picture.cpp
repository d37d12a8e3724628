#include "compare/compare_picture.hpp"

#include <algorithm>

#include "classify/still_picture.hpp"
#include "picture/canvas.hpp"

namespace moldlight {

namespace {

struct LitFacts {
  Colour colour;
  std::string_view name;
};

const LitFacts& facts_of(Lit what) {
  static constexpr LitFacts k_facts[] = {
      {{200, 60, 200}, "gone"}, {{245, 150, 20}, "new"}, {{240, 220, 40}, "another region"}};
  return k_facts[static_cast<std::size_t>(what)];
}

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
  return revision == Revision::a ? comparison.a : comparison.b;
}

}  // namespace

Colour lit_colour(Lit what) { return facts_of(what).colour; }

std::vector<LitPolygon> lit_surface(const Comparison& comparison, bool of_a) {
  const SurfaceChange& surface = comparison.surface;
  const std::vector<LeftOver>& left = of_a ? surface.of_a.left : surface.of_b.left;
  const std::vector<std::uint32_t>& place_of = of_a ? surface.place_of_a : surface.place_of_b;
  std::vector<LitPolygon> lit;
  for (std::size_t k = 0; k < left.size(); ++k) {
    if (place_of[k] != k_no_change)
      lit.push_back({&left[k].polygon, left[k].piece, of_a ? Lit::gone : Lit::added, place_of[k]});
  }
  for (std::size_t k = 0; k < surface.of_a.regions.size(); ++k) {
    const OtherRegion& one = surface.of_a.regions[k];
    if (surface.change_of_region[k] != k_no_change)
      lit.push_back(
          {&one.polygon, of_a ? one.piece : one.other, Lit::other_region, surface.change_of_region[k]});
  }
  return lit;
}

std::shared_ptr<const SplitMesh> marked_split(const ComparedPart& part, std::span<const LitPolygon> lit) {
  auto split = std::make_shared<SplitMesh>(*part.result.split);
  for (SplitPiece& piece : split->pieces) piece.region = Region::both;
  for (const LitPolygon& one : lit) split->pieces[one.piece].region = Region::undercut;
  return split;
}

std::vector<StillBody> lit_bodies(const Comparison& comparison, Revision revision) {
  const ComparedPart& part = part_of(comparison, revision);
  const double thickness = k_raised * part.model->frame.diagonal;
  const std::vector<LitPolygon> lit = lit_surface(comparison, revision == Revision::a);
  std::vector<StillBody> bodies;
  for (const Lit what : {Lit::gone, Lit::added, Lit::other_region}) {
    Plates plates(thickness);
    for (const LitPolygon& one : lit) {
      if (one.what == what)
        plates.add(*one.polygon, part.model->geometry.normals[part.result.split->pieces[one.piece].facet]);
    }
    if (!plates.mesh.facets.empty())
      bodies.push_back(
          {std::move(plates.mesh), glm::dmat4(1.0), lit_colour(what), std::string(facts_of(what).name)});
  }
  return bodies;
}

glm::dquat lit_seen_from(const Comparison& comparison) {
  const bool of_a = comparison.surface.gone.area > comparison.surface.added.area;
  const ComparedPart& part = of_a ? comparison.a : comparison.b;
  const std::shared_ptr<const SplitMesh> marked = marked_split(part, lit_surface(comparison, of_a));
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
  for (const Revision revision : {Revision::a, Revision::b}) {
    const ComparedPart& part = part_of(comparison, revision);
    const std::vector<StillBody> bodies = lit_bodies(comparison, revision);
    const Image image = StillPainter(context, part.model).draw(part.result, settings, progress, bodies);
    canvas.picture(image,
                   {{revision == Revision::a ? 0.0 : half, 0.0}, {half, static_cast<double>(whole.y)}});
  }
  return canvas.image();
}

}  // namespace moldlight
