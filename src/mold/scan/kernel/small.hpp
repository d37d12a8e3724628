// Triangles whose bounding boxes are small enough for edge functions of 32 bits: every texel centre of the
// box is tested.
#pragma once

#include "mold/scan/kernel/cells.hpp"
#include "mold/scan/kernel/facets.hpp"
#include "mold/scan/kernel/triangles.hpp"
#include "mold/scan/kernel/vectors.hpp"

/// Triangles ready to be filled. Edge functions are those of the centre at the box's lower left, and are not
/// negative inside; heights follow from the functions of the edges 0 and 2.
struct SmallBatch {
  static constexpr std::size_t k_size = 32;
  alignas(16) std::int32_t edge[3][k_size], column_step[3][k_size], row_step[3][k_size];
  alignas(16) float base[k_size], rise0[k_size], rise2[k_size], lowest[k_size], highest[k_size];
  alignas(16) std::int32_t cell[k_size], rows[k_size], columns[k_size], down[k_size];
  Job jobs[k_size];

  /// Eight texels in a row of a triangle's box, some of which it covers: bits of these, row, column of the
  /// first and place of the triangle, eight bits each.
  static constexpr int k_row_bit = 8, k_column_bit = 16, k_place_bit = 24;
  static constexpr std::size_t k_most_eights = 2048;
  std::uint32_t eights[k_most_eights + 1];
  std::size_t count = 0;
};

constexpr std::size_t k_most_eights_of_one =
    static_cast<std::size_t>(k_small_rows * ((k_small_columns + 7) / 8));

/// Four triangles into places of the batch. Rows of those of no area are none.
template <typename Corner>
inline void set_up_small(const Corner& corner, int size, int pitch, SmallBatch& batch, std::size_t at) {
  const Small4 four = load_small(corner, size);
  const Int4 *x = four.corners.x, *y = four.corners.y;
  Int4 yields[3];
  for (int e = 0; e < 3; ++e) {
    const int f = e == 2 ? 0 : e + 1;
    const Int4 dx = x[f] - x[e], dy = y[f] - y[e];
    yields[e] = yields_ties(dx, dy);
    store(batch.edge[e] + at, dx * (four.py - y[e]) - dy * (four.px - x[e]) + yields[e]);
    store(batch.column_step[e] + at, dy * -k_subtexel);
    store(batch.row_step[e] + at, dx * k_subtexel);
  }
  // The functions stand one too low where ties are the neighbour's.
  store(batch.base + at, four.corners.z[0] - four.rise2 * __builtin_convertvector(yields[2], Float4) -
                             four.rise0 * __builtin_convertvector(yields[0], Float4));
  store(batch.rise0 + at, four.rise0);
  store(batch.rise2 + at, four.rise2);
  store(batch.lowest + at, four.lowest);
  store(batch.highest + at, four.highest);
  store(batch.cell + at, four.box.bottom * pitch + four.box.left);
  store(batch.rows + at, four.area > 0 ? four.box.top - four.box.bottom + 1 : Int4{});
  store(batch.columns + at, four.box.right - four.box.left + 1);
  store(batch.down + at, four.down);
}

/// Finds what a triangle covers.
inline void find_eights(SmallBatch& batch, std::size_t place) {
  constexpr Int8 k_columns = {0, 1, 2, 3, 4, 5, 6, 7};
  for (std::int32_t column = 0; column < batch.columns[place]; column += 8) {
    Int8 edge[3], step[3];
    for (int e = 0; e < 3; ++e) {
      edge[e] = batch.edge[e][place] + batch.column_step[e][place] * (k_columns + column);
      step[e] = Int8{} + batch.row_step[e][place];
    }
    std::uint32_t* end = batch.eights + batch.count;
    std::uint32_t eight = static_cast<std::uint32_t>(place) << SmallBatch::k_place_bit |
                          static_cast<std::uint32_t>(column) << SmallBatch::k_column_bit;
    for (std::int32_t row = 0; row < batch.rows[place]; ++row, eight += 1U << SmallBatch::k_row_bit) {
      const std::uint32_t covered = lanes_set(edge[0] | edge[1] | edge[2]) ^ 0xFFU;
      *end = eight | covered;
      end += covered != 0 ? 1 : 0;
      for (int e = 0; e < 3; ++e) edge[e] += step[e];
    }
    batch.count = static_cast<std::size_t>(end - batch.eights);
  }
}

template <Entries k_entries>
inline void write_eights(SmallBatch& batch, CellWriter<k_entries>& cells) {
  constexpr Int4 k_four = {0, 1, 2, 3};
  for (std::size_t i = 0; i < batch.count; ++i) {
    const std::uint32_t eight = batch.eights[i];
    const std::size_t place = eight >> SmallBatch::k_place_bit;
    Job& job = batch.jobs[place];
    const auto row = static_cast<std::int32_t>(eight >> SmallBatch::k_row_bit & 0xFFU);
    const std::int32_t row_cell = batch.cell[place] + row * cells.target.pitch;
    const std::int32_t edge0 = batch.edge[0][place] + row * batch.row_step[0][place],
                       edge2 = batch.edge[2][place] + row * batch.row_step[2][place];
    const Float4 lowest = Float4{} + batch.lowest[place], highest = Float4{} + batch.highest[place];
    auto column = static_cast<std::int32_t>(eight >> SmallBatch::k_column_bit & 0xFFU);
    // The texels of a row that a triangle covers lie next to one another.
    for (std::uint32_t covered = eight & 0xFFU; covered != 0;) {
      const int skipped = __builtin_ctz(covered);
      column += skipped;
      covered >>= skipped;
      const Int4 columns = k_four + column;
      const Int4 at0 = edge0 + batch.column_step[0][place] * columns,
                 at2 = edge2 + batch.column_step[2][place] * columns;
      Float4 heights = (batch.base[place] + batch.rise2[place] * __builtin_convertvector(at2, Float4)) +
                       batch.rise0[place] * __builtin_convertvector(at0, Float4);
      heights = heights < lowest ? lowest : heights;
      heights = heights > highest ? highest : heights;
      const Int4 whole = __builtin_convertvector(heights, Int4);
      const std::uint32_t four = covered & 0xFU;
      cells.write_four(row_cell + column, __builtin_convertvector(whole, Long4) << 32, lane_mask(four), job);
      job.fragments += bit_count(four);
      column += 4;
      covered >>= 4;
    }
  }
  batch.count = 0;
}
