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

/// Four triangles of either winding, small enough for edge functions of 32 bits, made counter-clockwise.
struct Small4 {
  Corners4 corners;
  Int4 down, area;  // mask of those that were turned; twice the area
  Box4 box;
  Int4 px, py;             // first centre of the box
  Float4 rise0, rise2;     // of the height, by the functions of the edges 0 and 2
  Float4 lowest, highest;  // heights
};

template <typename Corner>
inline Small4 load_small(const Corner& corner, int size) {
  Small4 four;
  four.corners = load_corners(corner);
  const Int4 *x = four.corners.x, *y = four.corners.y;
  const Float4* z = four.corners.z;
  const Int4 signed_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  four.down = signed_area < 0;
  four.area = four.down ? -signed_area : signed_area;
  reverse(four.down, four.corners);
  four.box = box_of(four.corners, size);
  four.px = four.box.left * k_subtexel + k_half_texel;
  four.py = four.box.bottom * k_subtexel + k_half_texel;
  const Float4 inverse = 1.0F / __builtin_convertvector(four.area, Float4);
  four.rise2 = (z[1] - z[0]) * inverse;
  four.rise0 = (z[2] - z[0]) * inverse;
  const Float4 low01 = z[0] < z[1] ? z[0] : z[1], high01 = z[0] < z[1] ? z[1] : z[0];
  four.lowest = low01 < z[2] ? low01 : z[2];
  four.highest = high01 < z[2] ? z[2] : high01;
  return four;
}
