// Geometry of a picture beside PartBuffers, and of solids beside it, made once on the CPU: on any
// thread, without GL.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/exact/split_mesh.hpp"
#include "mold/region.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

/// As shaders/view/surface_bits.glsl has them: where a surface's first word has facet + 1 and that it is a
/// section's cut, and from where on a piece's source has its accessibility bits.
inline constexpr std::uint32_t k_surface_number_mask = 0x0FFFFFFFU, k_surface_cut_bit = 0x10000000U;
inline constexpr int k_source_bits_shift = 30;

/// A corner as the geometry pass reads it: 16 bytes.
struct ViewVertex {
  glm::vec3 position;                  // unit frame
  std::array<std::int16_t, 2> normal;  // octahedral, of the smooth surface
};
static_assert(sizeof(ViewVertex) == 16);

struct ViewSegment {
  glm::vec3 start, end;  // unit frame
};

struct ViewGeometry {
  std::vector<ViewVertex> vertices;
  std::vector<std::array<VertexIndex, 3>> facets;  // facet k is facet k of the mesh
  std::vector<ViewSegment> feature_edges;
  std::vector<glm::vec3> extremes;  // outermost vertices in a few hundred directions, unit frame: enough to
                                    // frame a picture by
  bool closed = false;     // every facet has a neighbour across each edge, so that no back is ever seen
  bool all_solid = false;  // every facet is of a body without open edges
  std::vector<std::array<VertexIndex, 3>> solids;  // the facets that are, where not all of them are
};
[[nodiscard]] ViewGeometry view_geometry(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                         const Adjacency& adjacency, const UnitFrame& frame);

/// The same without some facets, of which it keeps the numbers: a facet of which `hidden` has anything but 0
/// is no triangle any more, and its edges go.
[[nodiscard]] ViewGeometry shown_part(const ViewGeometry& whole, std::span<const std::uint8_t> hidden);

/// Where regions other than undercuts border on each other: along the direction these lines make the part's
/// outline, and they are where mold halves can meet.
[[nodiscard]] std::vector<ViewSegment> parting_line(const SplitMesh& split, const UnitFrame& frame);

/// A vector of any length but zero on the octahedron, folded into a square (Cigolle et al. 2014), in steps of
/// 1 / 32767.
[[nodiscard]] std::array<std::int16_t, 2> octahedral(const glm::vec3& vector);
/// The unit vector back from it.
[[nodiscard]] glm::vec3 from_octahedral(const std::array<std::int16_t, 2>& steps);

/// The surface of a part, split at the borders of its regions, as pictures draw it.
struct SplitGeometry {
  /// Those of the view geometry first; then the corners that cuts have made, a copy for each facet.
  std::vector<ViewVertex> vertices;
  std::vector<std::array<VertexIndex, 3>> pieces;
  std::vector<std::uint32_t> sources;  // of each piece: its facet, and its accessibility bits from bit 30 on
};

/// `view` is the view geometry of `mesh`, `split` a split of it. Pieces of facets that the view hides are no
/// triangles either. Normals are interpolated over each facet, so
/// that a split surface has the same light as a whole one. Some milliseconds for 500,000 facets.
[[nodiscard]] SplitGeometry split_geometry(const SplitMesh& split, const TriangleMesh& mesh,
                                           const ViewGeometry& view, const UnitFrame& frame);

/// Where an arrow stands. Unit frame.
struct ViewArrow {
  glm::dvec3 tail{0.0}, tip{0.0};
  double shaft_radius = 0.0, head_radius = 0.0, head_length = 0.0;
};

/// The arrow that points along `toward` (unit) from above the part, of which `extremes` are the outermost
/// points; an opened mold moves it out by `opened`.
[[nodiscard]] ViewArrow parting_arrow(std::span<const glm::vec3> extremes, const glm::dvec3& toward,
                                      double opened);
/// The arrow by which a section plane is held: on the plane, towards what is cut away.
[[nodiscard]] ViewArrow section_arrow(const CutPlane& cut);

/// A solid beside the part that a side action moves, translucent over the finished picture.
struct ViewBody {
  std::vector<ViewVertex> vertices;
  std::vector<std::array<VertexIndex, 3>> facets;
  Colour colour;
};

/// A closed mesh in the part's unit, each facet flat.
[[nodiscard]] ViewBody view_body(const TriangleMesh& mesh, const UnitFrame& frame, Colour colour);

/// How a body of steel moves while its mold opens: with a half, and out along a way of its own.
struct SteelMotion {
  double half = 0.0;    // 1: with the core, along the direction; -1: with the cavity
  glm::dvec3 way{0.0};  // unit frame
  bool first = true;    // before the halves, else after them

  /// Unit frame, for a unit direction.
  [[nodiscard]] glm::dvec3 shift(const SteelLook& look, const glm::dvec3& direction) const {
    return half * look.opened * k_mold_travel * direction + (first ? look.first : look.last) * way;
  }
};
/// A body of steel around the part, which is surface of the picture itself.
struct ViewSolid {
  ViewBody body;  // its colour is that of what is moved
  Steel steel = Steel::core;
  std::vector<ViewSegment> edges;  // sharper than the crease angle
  SteelMotion motion;              // that of a half is known
};
/// A closed mesh in the part's unit, each facet flat.
[[nodiscard]] ViewSolid view_solid(const TriangleMesh& mesh, const UnitFrame& frame, Steel steel);

/// Of one part, which must outlive it. Remembers the extent along the normal last asked for: millions of
/// vertices are not gone through for every picture.
class SectionPlanes {
 public:
  SectionPlanes(const TriangleMesh& mesh, const UnitFrame& frame) : mesh_(&mesh), frame_(&frame) {}

  /// The plane for a parting direction (unit); nothing where no section is chosen.
  [[nodiscard]] std::optional<CutPlane> plane(const LookSettings& look, const glm::dvec3& direction);

 private:
  const TriangleMesh* mesh_;
  const UnitFrame* frame_;
  glm::dvec3 normal_{0.0};               // last asked for
  double least_ = 0.0, greatest_ = 0.0;  // of the part along it, unit frame
};

}  // namespace moldlight
