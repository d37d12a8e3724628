#include "compare/compare_picture.hpp"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "classify/view_choice.hpp"
#include "picture/canvas.hpp"

namespace moldlight {

namespace {

constexpr Colour k_gone{200, 60, 200}, k_new{245, 150, 20}, k_other{240, 220, 40};
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

/// What is lit on one of the parts.
struct Lit {
  const ComparedPart& part;
  const std::vector<LeftOver>& left;
  const std::vector<std::uint32_t>& place_of;
  Colour colour;
  std::string_view label;
  bool former = true;
};

std::vector<StillBody> lit_bodies(const Lit& lit, const SurfaceChange& surface) {
  const double thickness = k_raised * lit.part.model->frame.diagonal;
  const auto normal_of = [&](PieceIndex piece) {
    return lit.part.model->geometry.normals[lit.part.result.split->pieces[piece].facet];
  };
  Plates changed(thickness), other(thickness);
  for (std::size_t k = 0; k < lit.left.size(); ++k)
    if (lit.place_of[k] != k_no_change) changed.add(lit.left[k].polygon, normal_of(lit.left[k].piece));
  for (std::size_t k = 0; k < surface.of_former.regions.size(); ++k) {
    const OtherRegion& one = surface.of_former.regions[k];
    if (surface.change_of_region[k] != k_no_change)
      other.add(one.polygon, normal_of(lit.former ? one.piece : one.other));
  }
  std::vector<StillBody> bodies;
  if (!changed.mesh.facets.empty())
    bodies.push_back({std::move(changed.mesh), glm::dmat4(1.0), lit.colour, std::string(lit.label)});
  if (!other.mesh.facets.empty())
    bodies.push_back({std::move(other.mesh), glm::dmat4(1.0), k_other, "another region"});
  return bodies;
}

/// From where most of what is lit is seen, which stands for the undercuts that views are chosen by.
glm::dquat seen_from(const Lit& lit, const SurfaceChange& surface) {
  auto split = std::make_shared<SplitMesh>(*lit.part.result.split);
  for (SplitPiece& piece : split->pieces) piece.region = Region::both;
  const auto mark = [&](PieceIndex piece) { split->pieces[piece].region = Region::undercut; };
  for (std::size_t k = 0; k < lit.left.size(); ++k)
    if (lit.place_of[k] != k_no_change) mark(lit.left[k].piece);
  for (std::size_t k = 0; k < surface.of_former.regions.size(); ++k)
    if (surface.change_of_region[k] != k_no_change)
      mark(lit.former ? surface.of_former.regions[k].piece : surface.of_former.regions[k].other);
  const std::shared_ptr<const SplitMesh> marked = std::move(split);
  return revealing_orientation(*lit.part.model, std::span(&marked, 1), lit.part.result.direction);
}

}  // namespace

Image comparison_picture(const gl::Context& context, const Comparison& comparison, StillSettings settings,
                         const Progress& progress) {
  validate(settings);
  const SurfaceChange& surface = comparison.surface;
  const std::array<Lit, 2> sides = {
      {{comparison.a, surface.of_former.left, surface.place_of_former, k_gone, "gone", true},
       {comparison.b, surface.of_fresh.left, surface.place_of_fresh, k_new, "new", false}}};
  const glm::ivec2 whole = settings.size;
  if (!settings.seen_from)
    settings.seen_from = seen_from(sides[surface.gone.area > surface.fresh.area ? 0 : 1], surface);
  Canvas canvas(whole.x, whole.y);
  settings.size.x = std::max(whole.x / 2, k_least_picture_px);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<StillBody> bodies = lit_bodies(sides[k], surface);
    const Image image =
        StillPainter(context, sides[k].part.model).draw(sides[k].part.result, settings, progress, bodies);
    const double half = 0.5 * whole.x;
    canvas.picture(image, {{k == 0 ? 0.0 : half, 0.0}, {half, static_cast<double>(whole.y)}});
  }
  return canvas.image();
}

}  // namespace moldlight
