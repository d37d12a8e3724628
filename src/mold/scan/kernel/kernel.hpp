// The inner loops of scan conversion, compiled for any machine, for those with AVX2 and for those with
// AVX-512; all give the same results to the bit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace moldlight::scan {

/// A vertex in the maps: x and y in 1 / k_subtexel of a texel, height along +d in map height units.
struct alignas(16) MapVertex {
  std::int32_t x = 0, y = 0;
  float height = 0;
  std::int32_t unused = 0;
};
inline constexpr int k_subtexel_bits = 8;
inline constexpr int k_subtexel = 1 << k_subtexel_bits;

/// Heights from -0.5 to 0.5 of the unit frame span the 24 bits of a map height but for a margin, so that
/// rounding cannot leave them.
inline constexpr int k_height_bits = 24;
inline constexpr std::int32_t k_height_limit = (1 << k_height_bits) - 1;
inline constexpr float k_height_margin = 64.0F;
inline constexpr float k_height_scale = static_cast<float>(k_height_limit) - 2.0F * k_height_margin;

/// A texel has entries for the facets that face +d (up layer) and for those that face -d (down layer). Of
/// each layer `front` is the facet that lies first as seen from the side that it faces, `back` the one that
/// lies last: the entry of the second-depth map of the other side. An entry is the greater the earlier it
/// wins: 7 bits of generation, 24 of depth, 32 of inverted facet number. Entries of an older generation are
/// empty, so that a new direction needs no clearing.
inline constexpr int k_last_generation = 127;

[[nodiscard]] constexpr std::int32_t generation_of(std::int64_t entry) {
  return static_cast<std::int32_t>(entry >> 56);
}
/// Height of an entry's facet at the texel's centre; depths grow with the height in the front entries of the
/// up layer and in the back entries of the down layer, and fall in the others.
[[nodiscard]] constexpr std::int32_t height_of(std::int64_t entry, bool falls) {
  const auto depth = static_cast<std::int32_t>(entry >> 32) & k_height_limit;
  return falls ? k_height_limit - depth : depth;
}
[[nodiscard]] constexpr std::uint32_t facet_of(std::int64_t entry) {
  return ~static_cast<std::uint32_t>(entry);
}

/// From the unit frame to the maps: component k of the result is the sum over i of column[i][k] * p[i], plus
/// offset[k].
struct alignas(16) Projection {
  float column[3][4] = {};
  float offset[4] = {};
};

enum Layer : std::uint8_t { k_up_layer = 0, k_down_layer = 1 };

struct RasterTarget {
  // By layer; size rows each, and k_entry_padding more entries that may be read and written back.
  std::int64_t *front[2] = {}, *back[2] = {};
  int size = 0;        // rows and columns
  int pitch = 0;       // entries from row to row
  int generation = 1;  // [1, k_last_generation]
};
inline constexpr std::size_t k_entry_padding = 4;

/// Entries from row to row of a map of `size` columns: an odd number of cache lines, so that the rows of a
/// facet do not share the few places that a cache has for addresses a power of two apart.
[[nodiscard]] constexpr int map_pitch(int size) { return ((size + 7) / 8 | 1) * 8; }

/// Fragments are texel centres covered by facets, once for each facet. A fragment is hidden if another one of
/// its layer lies in front of it. Sums over the fragments of one cluster in one layer whose facets weigh
/// something.
struct ClusterSums {
  double weight = 0.0, hidden_weight = 0.0;
  std::uint64_t fragments = 0;
};

struct RasterSums {
  ClusterSums* clusters = nullptr;                  // 2 * cluster + layer
  std::uint64_t fragments[2] = {}, hidden[2] = {};  // by layer
};

/// Which entries are written; the others are left alone.
enum class Entries { front, back, both };

struct RasterInput {
  const MapVertex* vertices = nullptr;
  const std::array<std::uint32_t, 3>* facets = nullptr;
  std::size_t facet_count = 0;
  const float* weights = nullptr;           // one a facet
  const std::uint32_t* clusters = nullptr;  // one a facet
  Entries entries = Entries::both;          // with back ones alone, nothing is summed
};

/// Facets by their slope. Arrays are padded to a multiple of eight.
struct ClassifyInput {
  const float *normal_x = nullptr, *normal_y = nullptr, *normal_z = nullptr, *areas = nullptr;
  std::size_t padded_count = 0;
  float direction[3] = {};
  float threshold = 0.0F;  // sine of tau
};

/// Slopes closer to the threshold than this may be on the wrong side of it: rounding of n.d in single
/// precision.
inline constexpr float k_slope_rounding = 1e-6F;

struct ClassifyOutput {
  std::int32_t* classes = nullptr;  // as FacetClass
  float* weights = nullptr;         // 1 / |n.d| of up and down facets, 0 of near-vertical ones
  std::uint32_t* steep =
      nullptr;  // numbers of the facets that are near-vertical or closer to it than the rounding
  std::size_t steep_count = 0;
  double class_area[3] = {};    // by class
  double projected_area = 0.0;  // of all facets along the direction
};

struct Kernel {
  void (*classify)(const ClassifyInput& input, ClassifyOutput& output);
  /// Positions are arrays of four floats, of which the last is not used.
  void (*transform)(const float* positions, std::size_t count, const Projection& projection,
                    MapVertex* vertices);
  /// Boxes of facets hold fewer than 2^14 texel centres along a side.
  void (*rasterize)(const RasterInput& input, const RasterTarget& target, RasterSums& sums);
  /// Triangles of either winding into the back entries of a layer, clipped to the map: three corners and the
  /// number of a facet each.
  void (*rasterize_back)(const MapVertex* corners, const std::uint32_t* facets, std::size_t count,
                         Layer layer, const RasterTarget& target);
  const char* name;
};

extern const Kernel k_portable_kernel;
extern const Kernel k_avx2_kernel, k_avx512_kernel;  // like the portable one for other than x86 processors

/// Those that this machine runs, the fastest last.
[[nodiscard]] std::span<const Kernel* const> kernels();
[[nodiscard]] const Kernel& best_kernel();
[[nodiscard]] const Kernel& best_kernel();

}  // namespace moldlight::scan
