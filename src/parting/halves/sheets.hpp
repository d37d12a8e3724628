// The surfaces that a mold is made of, as sheets over a plane: what is seen from above of the part, what from
// below, what is hidden, and the parting surface. Where they end, their ends stand in shared columns. Other
// bodies may stand beside the part, whose surface is in the sheets as far as it is seen.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

struct MoldFault {
  std::string what;
  std::string change;                    // what helps
  std::optional<glm::dvec3> place = {};  // in the mold's frame; none where it is all of the part
};

/// What helps where the surface itself is at fault.
inline constexpr const char* k_mend_surface =
    "repair the surface there (--repair full), or use one body of the part (--body)";
/// What helps where rounding is.
inline constexpr const char* k_avoid_rounding =
    "use larger facets there (--repair full drops needle-shaped ones), use one body of the part (--body), "
    "or turn the direction a little";

/// `beside`: what of `upper` and `lower` is of other bodies than the part, once more.
enum class Sheet : std::uint8_t { upper, lower, hidden, parting, beside };
/// The sheets whose ends have columns of their own.
inline constexpr std::array k_standing_sheets = {Sheet::upper, Sheet::lower, Sheet::hidden, Sheet::beside};

using SheetVertex = std::uint32_t;
using PlanePoint = std::uint32_t;
inline constexpr PlanePoint k_no_plane_point = ~0U;

/// A facet wound as the part's surface is; of the parting surface, as seen from above.
struct SheetFacet {
  std::array<SheetVertex, 3> corners{};
  Sheet sheet = Sheet::upper;
};

/// Where a sheet, or several taken together, ends: run through from `from` to `to`, `count` times; the sheet
/// is on the left.
struct SheetEdge {
  SheetVertex from = 0, to = 0;
  int count = 1;
};

/// An edge of a sheet over a segment between two columns, the lower number first.
struct SegmentEdge {
  SheetVertex a = 0, b = 0;  // over the segment's first and second column
  int sign = 0;              // how often it is run through from a to b, less the other way
};
/// Of each segment of the plane the edges over it.
struct SegmentEdges {
  PlanePoint a = 0, b = 0;
  std::vector<SegmentEdge> edges;
};

/// Coordinates are in the mold's frame: z is the parting direction, the part's diagonal about 1.
class Sheets {
 public:
  std::vector<glm::dvec3> vertices;
  std::vector<PlanePoint> column_of;  // one a vertex; k_no_plane_point inside a sheet
  std::vector<SheetFacet> facets;
  std::vector<glm::dvec2> columns;  // on a grid of 2^-45
  std::vector<double> moved;        // how far at most the ends in each column were moved to stand in it

  /// Puts the ends of the sheets into columns: ends nearer than `tolerance` share one; edges that pass a
  /// column that near get a vertex there; vertices of a column that near become one. A place where that does
  /// not come to an end; none where it does.
  [[nodiscard]] std::optional<glm::dvec3> align_ends(double tolerance);

  /// Ends of the sheets taken together, a bit of `sheets` each (1 << sheet), those in `turned` turned over;
  /// in order of their vertices. Where these are known to be in columns, other edges are not looked at.
  [[nodiscard]] std::vector<SheetEdge> ends(unsigned sheets, unsigned turned = 0,
                                            bool in_columns = false) const;
  [[nodiscard]] static constexpr unsigned bit(Sheet sheet) { return 1U << static_cast<unsigned>(sheet); }

  /// Edges by the segment of the plane over which they are; those that are upright, or at the block's rim,
  /// are over none.
  [[nodiscard]] std::vector<SegmentEdges> by_segment(std::span<const SheetEdge> edges) const;

  [[nodiscard]] PlanePoint add_column(const glm::dvec2& at);
  [[nodiscard]] SheetVertex add_vertex(PlanePoint column, double z);

  /// New vertices on edges, in order from the lower vertex number to the higher; facets are divided so that
  /// they have them.
  using OnEdges = std::unordered_map<std::uint64_t, std::vector<SheetVertex>>;
  [[nodiscard]] static std::uint64_t edge_key(SheetVertex a, SheetVertex b) {
    return a < b ? std::uint64_t{a} << 32U | b : std::uint64_t{b} << 32U | a;
  }
  void divide_edges(const OnEdges& on_edges);

  /// Makes one of the vertices of a column that are nearer than `tolerance`.
  void weld_columns(double tolerance);

  /// What the sheets of the part enclose with the upright surface between their ends.
  [[nodiscard]] double volume() const;
  /// Moves columns, each by the same share, up to a half, of what its ends were moved already, so that the
  /// sheets of the part enclose this volume again, or nearly; nothing where they lack more than `most`.
  void keep_volume(double assigned, double most);

 private:
  class PlaneGrid;
  struct Passing;
  void make_columns(double tolerance);
  /// A vertex that was put on an edge; none where there was none to put.
  [[nodiscard]] std::optional<glm::dvec3> insert_columns(double tolerance, Passing& passing);
  void divide(const SheetFacet& facet, const OnEdges& on_edges, std::vector<SheetFacet>& parts) const;
};

/// The point on the grid that all columns are on.
[[nodiscard]] glm::dvec2 on_grid(const glm::dvec2& at);

/// Where ends were moved farthest to stand in columns; none where there are no columns.
[[nodiscard]] std::optional<glm::dvec3> most_moved(const Sheets& sheets);

/// Around the facets' corners.
[[nodiscard]] Bounds box_of(const Sheets& sheets);

}  // namespace moldlight
