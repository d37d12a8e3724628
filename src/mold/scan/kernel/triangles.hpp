// Four triangles at a time, one a lane.
#pragma once

#include "mold/scan/kernel/vectors.hpp"

constexpr std::int32_t k_half_texel = k_subtexel / 2;

/// Corners of four triangles, one a lane.
struct Corners4 {
  Int4 x[3], y[3];
  Float4 z[3];
};

/// `corner(lane, k)` is a pointer to corner k of a triangle.
template <typename Corner>
inline Corners4 load_corners(const Corner& corner) {
  Corners4 corners;
  for (int k = 0; k < 3; ++k) {
    const auto a = load<Int4>(corner(0, k)), b = load<Int4>(corner(1, k)), c = load<Int4>(corner(2, k)),
               d = load<Int4>(corner(3, k));
    const Int4 ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    corners.x[k] = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
    corners.y[k] = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
    const Int4 ab_z = __builtin_shufflevector(a, b, 2, 6, 3, 7),
               cd_z = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    corners.z[k] = bits_as<Float4>(__builtin_shufflevector(ab_z, cd_z, 0, 1, 4, 5));
  }
  return corners;
}

/// Makes the masked triangles run the other way round.
inline void reverse(Int4 mask, Corners4& corners) {
  const Int4 x1 = mask ? corners.x[2] : corners.x[1], y1 = mask ? corners.y[2] : corners.y[1];
  const Float4 z1 = mask ? corners.z[2] : corners.z[1];
  corners.x[2] = mask ? corners.x[1] : corners.x[2];
  corners.y[2] = mask ? corners.y[1] : corners.y[2];
  corners.z[2] = mask ? corners.z[1] : corners.z[2];
  corners.x[1] = x1;
  corners.y[1] = y1;
  corners.z[1] = z1;
}

/// First and last texel centres of bounding boxes, within the map.
struct Box4 {
  Int4 left, right, bottom, top;
};
inline Box4 box_of(const Corners4& corners, int size) {
  const Int4 *x = corners.x, *y = corners.y;
  const Int4 zero = {}, last = zero + (size - 1);
  return {greatest((least(least(x[0], x[1]), x[2]) + (k_half_texel - 1)) >> k_subtexel_bits, zero),
          least((greatest(greatest(x[0], x[1]), x[2]) - k_half_texel) >> k_subtexel_bits, last),
          greatest((least(least(y[0], y[1]), y[2]) + (k_half_texel - 1)) >> k_subtexel_bits, zero),
          least((greatest(greatest(y[0], y[1]), y[2]) - k_half_texel) >> k_subtexel_bits, last)};
}

/// Edges that leave the texel centres on them to the facet on their other side.
inline Int4 yields_ties(Int4 dx, Int4 dy) { return (dy < 0) | ((dy == 0) & (dx > 0)); }
