// The two halves of a mold as solids, without Boolean operations: above what is seen from above the part and
// the parting surface lies the core half, below what is seen from below it the cavity half. What lies between
// and is not the part is left to inserts. Each result carries its certificate.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "parting/halves/bodies.hpp"
#include "parting/halves/surface_figures.hpp"
#include "parting/loops.hpp"
#include "parting/mold_settings.hpp"

namespace moldlight {

/// Right-handed orthonormal axes.
struct MoldFrame {
  glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  [[nodiscard]] glm::dvec3 to_mold(const glm::dvec3& part) const {
    return {glm::dot(part, x), glm::dot(part, y), glm::dot(part, z)};
  }
  [[nodiscard]] glm::dvec3 to_part(const glm::dvec3& mold) const {
    return mold.x * x + mold.y * y + mold.z * z;
  }
};

/// For a unit direction. Along an axis of the part the mold's axes are the part's, in another order, so that
/// coordinates stay what they are to the bit.
[[nodiscard]] MoldFrame mold_frame(const glm::dvec3& direction);
/// Along other directions x and y are where the part's upright walls face, if these say so: the block is
/// square to them, and so are slides in it.
[[nodiscard]] MoldFrame mold_frame(const PartModel& model, const glm::dvec3& direction);

/// 0, 1, 2 where the direction is along that axis of the part, either way; else -1.
[[nodiscard]] int axis_of(const glm::dvec3& direction);

/// What stands between the halves: what leaves by hand, or what an action moves.
enum class PieceKind : std::uint8_t { slide, lifter, insert };
/// "slide", …
[[nodiscard]] std::string_view piece_name(PieceKind kind);

/// A solid of the mold, in the mold's frame about the part's centre, in the part's unit, with the shrinkage.
struct MoldBody {
  TriangleMesh mesh;
  double volume = 0.0;
  std::string name = {};                 // "core", "slide_1", "insert_1"
  PieceKind kind = PieceKind::insert;    // of what is no half
  std::size_t action = 0;                // number in the plan, of a slide or a lifter
  std::vector<std::size_t> blanks = {};  // numbers of the slides' blanks that are in it
  std::size_t open_edges = 0;
  std::optional<double> thinnest = {};  // way through it between faces that are opposite to each other
  std::size_t crossed_facets = 0;       // in single precision, by rounding
  // Of a half, likewise.
  std::size_t nonmanifold_edges = 0;          // in which it touches itself
  std::optional<glm::dvec3> crossed_at = {};  // one of these, in the part's coordinates
  std::size_t needles = 0;                    // facets thinner than a ten-millionth of the part's diagonal
  std::optional<glm::dvec3> needle_at = {};   // the longest of these, in the part's coordinates
  double leaning = 0.0;  // share of its area that leans along its pull by more than 0.01 degrees
};

/// A body as it goes to a file.
struct WrittenBody {
  std::string name;  // "core", "cavity", "insert_1"
  std::string file;  // path; empty where nothing was written
  TriangleMesh mesh;
  double volume = 0.0;
  bool closed = false;
  std::size_t nonmanifold_edges = 0;  // in which it touches itself; the mesh has them apart
  double undercut = 0.0;  // of a half: what faces away from its pull, as a share of the block's rectangle
  double leaning = 0.0;   // of a half: what leans so by more than 0.01 degrees, as a share of its area
};

/// The bodies in the frame of the files, rounded to single precision and tested in it. In the part's own
/// frame where the direction is one of its axes and the coordinates keep what the halves need; else in the
/// mold's, the parting direction upward, about the part's centre.
struct WrittenMold {
  std::vector<WrittenBody> bodies;  // core, cavity, and what stands between them
  TriangleMesh surface;             // between the halves, around the part and in its openings; not rounded
  bool part_frame = false;
  std::string refusal;                   // why they cannot be written; empty where they can
  std::optional<glm::dvec3> refused_at;  // in the part's coordinates
};

/// Faces given to a half by hand that it does not form.
struct MissedFaces {
  double area = 0.0;
  std::optional<glm::dvec3> at;  // where the most of it is, in the part's coordinates
};

/// Lengths in the part's unit, without the shrinkage but for bodies.
struct MoldHalves {
  std::string refusal;                   // why there are none, in a sentence; empty where there are
  std::string change;                    // what helps then
  std::optional<glm::dvec3> refused_at;  // in the part's coordinates; none where it is all of the part

  MoldFrame frame;
  glm::dvec3 centre{0.0};  // of the part, in its coordinates; the origin of the bodies
  double scale = 1.0;      // of the bodies against the part, for the shrinkage
  MoldBody core, cavity;
  TriangleMesh surface_mesh;  // between them but for upright walls, in the bodies' frame
  std::vector<MoldBody>
      inserts;  // slides, then the others, the largest first; what is thinner than a tolerance is left out
  /// Core and cavity with what their lifters form, as bodies; without facets where there are none.
  std::array<TriangleMesh, 2> with_lifted;
  double specks_volume = 0.0;  // of what is left out

  // The certificate. Volumes are those of the bodies.
  double block_volume = 0.0, part_volume = 0.0, insert_volume = 0.0;
  bool divided = false;         // whether round walls were divided to stand upright
  double upright_volume = 0.0;  // by how much the part is larger for walls that were set upright
  double volume_gap = 0.0;      // block less all of these, as a share of the block
  double fold_area =
      0.0;  // of facets of a half that face away from its pull, as a share of the block's rectangle
  double cover_gap = 0.0;  // rectangle less what the facets of a half cover, as a share of it

  SurfaceFigures surface;
  glm::dvec2 block_low{0.0}, block_high{0.0};  // the block's rectangle in the mold's frame, in diagonals
  double part_height = 0.0;                    // along the direction
  double margin = 0.0;                         // the most between the part's box and the block's sides
  double land = 0.0;                           // width of what is level between the line and a ramp
  /// How steep the part's own outline is, where that is more than was asked: less than that no parting
  /// surface can be that meets it, so that the halves touch on upright walls there. 90 at steps, 0: nowhere.
  double forced_deg = 0.0;
  std::optional<glm::dvec3> forced_at;         // in the part's coordinates
  MissedFaces missed_leaning, missed_upright;  // lean against the half; the surface would be too steep
  double contact_area = 0.0;
  std::vector<ContactWall> contacts;  // in the part's coordinates, the largest first
  double tolerance = 0.0;             // with which it succeeded, as a share of the diagonal
  WrittenMold written;                // what was certified of them
  std::size_t mended_facets = 0;      // of these, that crossed by rounding before they were moved apart

  /// What a certified half may have of faults by rounding.
  [[nodiscard]] std::size_t numerical_defects() const {
    return core.crossed_facets + cavity.crossed_facets + core.nonmanifold_edges + cavity.nonmanifold_edges;
  }
  /// Whether rounding leaves walls with an undercut.
  [[nodiscard]] bool leans() const {
    constexpr double k_most_leaning = 5e-7;
    return std::max(core.leaning, cavity.leaning) > k_most_leaning;
  }
  /// Whether the halves are solids that CAM and Boolean kernels take: closed, and nothing crosses, touches
  /// itself or leans.
  [[nodiscard]] bool certified() const {
    return made() && written.refusal.empty() && numerical_defects() == 0 && !leans();
  }
  [[nodiscard]] bool clean() const { return numerical_defects() + mended_facets == 0 && !leans(); }
  /// Of two that can be made: the cleaner one, then the one whose halves touch less on upright walls.
  [[nodiscard]] bool better_than(const MoldHalves& other) const {
    constexpr double k_same = 0.99;
    if (leans() != other.leans()) return other.leans();
    if (numerical_defects() != other.numerical_defects())
      return numerical_defects() < other.numerical_defects();
    if (contact_area < k_same * other.contact_area) return true;
    return other.contact_area >= k_same * contact_area && mended_facets < other.mended_facets;
  }
  /// Of two that can be made: one that is certified, has a flat edge, or more of its surface in one plane.
  [[nodiscard]] bool nicer_than(const MoldHalves& other) const {
    constexpr double k_same = 0.01, k_flat_rim = 1e-3;
    if (certified() != other.certified()) return certified();
    const double rim = surface.rim_range() - other.surface.rim_range();
    if (std::abs(rim) > k_flat_rim * part_height) return rim < 0.0;
    const double more = surface.shelf_share() - other.surface.shelf_share();
    return std::abs(more) > k_same ? more > 0.0 : better_than(other);
  }
  [[nodiscard]] bool made() const { return refusal.empty(); }
  /// What bodies and part leave of the block, as a share of it.
  [[nodiscard]] double share_left() const {
    return (block_volume - core.volume - cavity.volume - part_volume - insert_volume) / block_volume;
  }
  [[nodiscard]] std::size_t count(PieceKind kind) const;
  [[nodiscard]] double volume(PieceKind kind) const;
};

/// Of a closed mesh, enlarged so, with its volume.
[[nodiscard]] MoldBody mold_body(TriangleMesh mesh, double scale = 1.0);

/// What is thinner on average than half the usual lateral tolerance is no insert: the plastic fills it.
/// `unit`: the part's diagonal, with the shrinkage.
[[nodiscard]] bool is_speck(const MoldBody& body, double unit);

/// Takes coordinates of the files to the part's, whose origin is where it is enlarged from for shrinkage.
[[nodiscard]] glm::dmat4 to_part_of(const MoldHalves& halves);

/// The part's mesh, of this diagonal, in the mold's frame about its centre, in diagonals; and a body's,
/// likewise, without the shrinkage.
[[nodiscard]] TriangleMesh in_mold(const MoldHalves& halves, TriangleMesh part, double diagonal);
[[nodiscard]] TriangleMesh unscaled(const MoldHalves& halves, TriangleMesh body, double diagonal);
/// A body's mesh in the part's coordinates, without the shrinkage.
[[nodiscard]] TriangleMesh in_part(const MoldHalves& halves, TriangleMesh body);

/// The middle of the box around an insert, in the part's coordinates and without the shrinkage.
[[nodiscard]] glm::dvec3 insert_place(const MoldHalves& halves, std::size_t insert);

}  // namespace moldlight
