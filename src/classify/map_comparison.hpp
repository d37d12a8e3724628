// How far the regions that the shadow maps show are from the exact ones, measured by samples of the split
// mesh's pieces: what region a piece has is known, what the maps say of its samples is looked up.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/unit_frame.hpp"
#include "mold/exact/split_mesh.hpp"
#include "mold/region.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

/// Areas in model units squared.
struct MapComparison {
  /// By exact region, then by that of the maps. A row's sum is the exact area.
  std::array<RegionValues, k_region_count> areas;
  /// Of differing(): twice its standard deviation if the samples lay at random; evenly as they lie, it is off
  /// by less.
  double error = 0.0;
  std::size_t samples = 0;

  [[nodiscard]] double total() const;
  [[nodiscard]] double differing() const;
  /// Area by the maps less the exact one.
  [[nodiscard]] double excess(Region region) const;
};

/// Model units squared.
[[nodiscard]] double piece_area(const SplitMesh& split, const SplitPiece& piece);
/// Model units.
[[nodiscard]] glm::dvec3 piece_point(const SplitMesh& split, const SplitPiece& piece,
                                     const TrianglePlace& place);

/// Points of the pieces, in equal steps of area over each region.
struct PieceSamples {
  std::vector<SurfaceSample> samples;  // ordered by exact region; the facet of each is the source facet
  std::array<std::size_t, k_region_count + 1> first{};  // those of region k are [first[k], first[k + 1])
  RegionValues areas;                                   // exact, model units squared
};
/// `wanted` samples over the whole part, in proportion to the regions' areas, but four for each region that
/// is there. `frame` is the part's. On any thread, without GL.
[[nodiscard]] PieceSamples sample_pieces(const SplitMesh& split, const UnitFrame& frame, std::size_t wanted);

/// `verdicts`: what the maps say of each sample (mold/measure.hpp).
[[nodiscard]] MapComparison compare_maps(const PieceSamples& samples, std::span<const std::uint8_t> verdicts);

/// "shadow maps: 0.80 % of the area differs, undercut 0.30 % too large", shares of the part's area.
[[nodiscard]] std::string comparison_text(const MapComparison& comparison);

}  // namespace moldlight
