// Triangles of at most two by two texel centres. First the fragments of a batch are found, then they are
// written: neither has a branch that cannot be foreseen.
#pragma once

#include "mold/scan/kernel/cells.hpp"
#include "mold/scan/kernel/triangles.hpp"
#include "mold/scan/kernel/vectors.hpp"

struct TinyBatch {
  static constexpr std::size_t k_size = 64;
  std::int32_t cell[4 * k_size + 4], height[4 * k_size + 4], place[4 * k_size + 4];  // of each fragment
  std::int32_t covered[k_size + 4];  // places of triangles that have fragments
  std::size_t fragments = 0, triangles = 0;
  Job jobs[k_size];  // by place
};

/// Finds the fragments of four triangles, whose jobs start at a place of the batch.
template <Entries k_entries, typename Corner>
inline void add_tiny(const Corner& corner, const std::uint32_t* facets, std::size_t lanes, std::size_t place,
                     const CellWriter<k_entries>& cells, TinyBatch& batch) {
  const Small4 four = load_small(corner, cells.target.size);
  const Int4 *x = four.corners.x, *y = four.corners.y;
  const Box4& box = four.box;
  // Edge functions at the first centre, less one where ties are the neighbour's, and their steps.
  Int4 value[3], dx[3], dy[3];
  for (int e = 0; e < 3; ++e) {
    const int f = e == 2 ? 0 : e + 1;
    dx[e] = x[f] - x[e];
    dy[e] = y[f] - y[e];
    value[e] = dx[e] * (four.py - y[e]) - dy[e] * (four.px - x[e]);
  }
  const Int4 exists = (Int4{0, 1, 2, 3} < static_cast<std::int32_t>(lanes)) & (four.area > 0);
  const Int4 first = box.bottom * cells.target.pitch + box.left;
  const Int4 places = Int4{0, 1, 2, 3} + static_cast<std::int32_t>(place);
  Int4 fragments = {};
  for (int k = 0; k < 4; ++k) {
    const std::int32_t column = k & 1, row = k >> 1;
    Int4 inside = exists & (box.left + column <= box.right) & (box.bottom + row <= box.top);
    Int4 at[3];
    for (int e = 0; e < 3; ++e) {
      at[e] = value[e] + (row * dx[e] - column * dy[e]) * k_subtexel;
      inside &= at[e] + yields_ties(dx[e], dy[e]) >= 0;
    }
    Float4 heights = four.corners.z[0] + four.rise2 * __builtin_convertvector(at[2], Float4) +
                     four.rise0 * __builtin_convertvector(at[0], Float4);
    heights = heights < four.lowest ? four.lowest : heights;
    heights = heights > four.highest ? four.highest : heights;
    const std::uint32_t covered = lanes_set(inside);
    store_set(batch.cell + batch.fragments, first + (row * cells.target.pitch + column), covered);
    store_set(batch.height + batch.fragments, __builtin_convertvector(heights, Int4), covered);
    store_set(batch.place + batch.fragments, places, covered);
    batch.fragments += bit_count(covered);
    fragments -= inside;
  }
  const std::uint32_t any = lanes_set(fragments > 0);
  store_set(batch.covered + batch.triangles, places, any);
  batch.triangles += bit_count(any);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const int l = static_cast<int>(lane);
    Job& job = batch.jobs[place + lane];
    cells.start_job(job, facets[lane], four.down[l] != 0 ? k_down_layer : k_up_layer);
    job.fragments = static_cast<std::uint32_t>(fragments[l]);
  }
}

template <Entries k_entries>
inline void write_tiny(TinyBatch& batch, CellWriter<k_entries>& cells) {
  for (std::size_t i = 0; i < batch.fragments; ++i) {
    Job& job = batch.jobs[batch.place[i]];
    job.lost += cells.write_one(batch.cell[i], batch.height[i], job) ? 1 : 0;
  }
  for (std::size_t i = 0; i < batch.triangles; ++i) cells.finish_job(batch.jobs[batch.covered[i]]);
  batch.fragments = batch.triangles = 0;
}
