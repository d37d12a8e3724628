// Volumes of changed places: planes between the places cut space into cells, and of each cell is found by how
// much more of it B's bodies fill than A's. Together that is what the bodies differ by.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "mesh/convex_polygon.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// A volume and how far it may be off, the part's unit cubed.
struct MeasuredVolume {
  double volume = 0.0, error = 0.0;
};

/// A bit of what lies in a cell.
struct CellBit {
  enum class Kind : std::uint8_t { facet, cap, changed, doubt };

  Kind kind = Kind::changed;  // of a part, closing a cut, new or gone surface, a point (one corner)
  ConvexPolygon polygon;
  std::uint32_t label = 0;  // of what changed: the number of its place
  double doubt = 0.0;       // what facets cut off round surface there, of A positive
};

struct VolumeQuestion {
  std::vector<CellBit> bits;  // what changed, and doubts
  std::uint32_t labels = 0;   // greater than each of the bits'
  double margin = 0.0;        // labels nearer to each other share a cell, > 0
  /// What comes or goes farther off the labels' boxes is no label's.
  std::optional<double> reach = std::nullopt;
};

struct DividedVolume {
  std::vector<MeasuredVolume> of_label;  // that came, negative: that went
  /// By how much surface of a label's cells alone encloses another volume: much where it is not closed.
  std::vector<double> open;
  double elsewhere = 0.0;
};

/// Both meshes must be closed. The same to the bit for any number of threads. Throws Cancelled.
[[nodiscard]] DividedVolume divided_volume(const TriangleMesh& a, const TriangleMesh& b,
                                           const VolumeQuestion& question, const Progress& progress);

}  // namespace moldlight
