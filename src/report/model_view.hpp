// The part and what belongs to it as a page's script draws them: surfaces in groups, each with its colour and
// the way it takes when the mold opens; and how they are packed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/json.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mold/region.hpp"

namespace moldlight::report {

/// Bytes as a page's script unpacks them (page/files/model.js): numbers of seven bits a byte, deflated
/// (zlib), in base64.
class PackedBytes {
 public:
  /// Seven bits a byte, the lowest first.
  void add(std::uint32_t value) {
    for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(0x80 | (value & 0x7F));
    bytes_ += static_cast<char>(value);
  }
  /// Folded: 0, -1, 1, -2, …
  void add_signed(std::int32_t value) {
    add(value < 0 ? ~(static_cast<std::uint32_t>(value) << 1) : static_cast<std::uint32_t>(value) << 1);
  }
  void add_byte(unsigned char byte) { bytes_ += static_cast<char>(byte); }
  void append(const PackedBytes& others) { bytes_ += others.bytes_; }
  [[nodiscard]] std::string deflated_base64() const;

 private:
  std::string bytes_;
};

/// The vertices of the facets in the order of their first use; adds to `bytes`, for every corner, the number
/// of the next new vertex less its own.
[[nodiscard]] std::vector<VertexIndex> pack_corners(const TriangleMesh& mesh, PackedBytes& bytes);

/// Surface that is named, coloured and moved together. Lengths are in the part's unit.
struct ViewGroup {
  std::string name = {};   // in the legend; empty: is not in it
  std::string aside = {};  // beside the name in the legend: an area, a travel
  Colour colour = {};
  bool hatched = false;
  bool stays_opaque = false;  // whatever the transparency
  glm::dvec3 shift{0.0};      // once the mold is open
  double turn_rad = 0.0;      // by then, about `axis` through `point`
  glm::dvec3 point{0.0}, axis{0, 0, 1};
  bool hidden = false;                         // at first
  bool without_edges = false;                  // its sharp edges are not drawn
  std::optional<std::size_t> shown_with = {};  // a named group: hidden when that is
};

struct ViewSurface {
  TriangleMesh mesh;
  std::vector<std::uint16_t> group_of_facet;
};

/// A line over the surface.
struct ViewLine {
  std::vector<glm::dvec3> points;
  bool closed = false;
  std::uint16_t group = 0;
};

/// A number at a place of the surface, shown from where the surface there faces; `normal` unit.
struct ViewCallout {
  std::string text;
  glm::dvec3 place{0.0}, normal{0, 0, 1};
};

struct ModelView {
  std::vector<ViewGroup> groups;
  std::vector<ViewSurface> surfaces;
  std::vector<ViewLine> lines;
  std::vector<ViewCallout> callouts = {};
  glm::dvec3 centre{0.0};         // of the part
  double diagonal = 1.0;          // of it
  glm::dvec3 direction{0, 0, 1};  // unit; upward
  glm::dvec3 to_viewer{1, 0, 0};  // unit
  double opened = 0.0;            // [0, 1], at first
  std::string opens;              // what the slider does: "Open the mold"
};

/// The view for a page's script: everything but the meshes as JSON, and the meshes in `data`: varints,
/// deflated (zlib), in base64. Of each surface: corners in the order of their first use, 16 bits a coordinate
/// within the surface's box, each the difference from the last; for every corner of every facet the next new
/// corner's number less its own; the group of each facet as a difference from the last. Of each line: its
/// points as differences, in the part's box. Differences that may be negative are folded (0, -1, 1, -2, …).
[[nodiscard]] Json packed(const ModelView& view);

}  // namespace moldlight::report
