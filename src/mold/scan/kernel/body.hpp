// Bodies of the scan kernel, included by the files that compile them for one instruction set each, inside a
// namespace of their own. Fixed-point edge functions: every texel centre on a shared edge belongs to exactly
// one facet.
#pragma once

#include "mold/scan/kernel/cells.hpp"
#include "mold/scan/kernel/facets.hpp"
#include "mold/scan/kernel/large.hpp"
#include "mold/scan/kernel/small.hpp"
#include "mold/scan/kernel/tiny.hpp"
#include "mold/scan/kernel/triangles.hpp"
#include "mold/scan/kernel/vectors.hpp"

/// The facets of a bin, which `corners` finds by their place in it: `corners(i)(lane, k)` is corner k of the
/// facet `lane` after place i.
template <Entries k_entries, typename Corners>
void fill_bin(Bin bin, const Corners& corners, const std::uint32_t* facets, std::size_t count,
              CellWriter<k_entries>& cells) {
  const auto lanes_at = [&](std::size_t i) { return count - i < 4 ? count - i : 4; };
  switch (bin) {
    case k_tiny_bin: {
      TinyBatch batch;
      for (std::size_t begin = 0; begin < count; begin += TinyBatch::k_size) {
        for (std::size_t i = 0; i < TinyBatch::k_size && begin + i < count; i += 4)
          add_tiny(corners(begin + i), facets + begin + i, lanes_at(begin + i), i, cells, batch);
        write_tiny(batch, cells);
      }
      return;
    }
    case k_small_bin: {
      SmallBatch batch;
      for (std::size_t begin = 0; begin < count; begin += SmallBatch::k_size) {
        const std::size_t size = count - begin < SmallBatch::k_size ? count - begin : SmallBatch::k_size;
        for (std::size_t i = 0; i < size; i += 4)
          set_up_small(corners(begin + i), cells.target.size, cells.target.pitch, batch, i);
        for (std::size_t i = 0; i < size; ++i) {
          const Layer layer = batch.down[i] != 0 ? k_down_layer : k_up_layer;
          cells.start_job(batch.jobs[i], facets[begin + i], layer);
          cells.fetch_ahead(layer, batch.cell[i]);
        }
        for (std::size_t i = 0; i < size; ++i) {
          if (batch.count + k_most_eights_of_one > SmallBatch::k_most_eights) write_eights(batch, cells);
          find_eights(batch, i);
        }
        write_eights(batch, cells);
        for (std::size_t i = 0; i < size; ++i) cells.finish_job(batch.jobs[i]);
      }
      return;
    }
    default: {
      LargeFiller<k_entries> filler(cells);
      std::size_t job = 0;
      for (std::size_t i = 0; i < count; i += 4) {
        if (job == k_job_batch) {
          filler.finish_jobs(job);
          job = 0;
        }
        Setup4 setup;
        set_up(corners(i), cells.target.size, setup);
        filler.start_jobs(setup, facets + i, lanes_at(i), job, nullptr);
        for (std::size_t lane = 0; lane < lanes_at(i); ++lane)
          filler.add(setup, static_cast<int>(lane), job + lane);
        job += lanes_at(i);
      }
      filler.finish_jobs(job);
    }
  }
}

template <Entries k_entries>
void rasterize_entries(const RasterInput& input, const RasterTarget& target, RasterSums& sums) {
  Survivors survivors;
  CellWriter<k_entries> cells(target, input, &sums);
  for (std::size_t begin = 0; begin < input.facet_count; begin += k_cull_batch) {
    cull(input, begin, begin + k_cull_batch < input.facet_count ? begin + k_cull_batch : input.facet_count,
         survivors);
    for (const Bin bin : {k_tiny_bin, k_small_bin, k_large_bin}) {
      const std::uint32_t* facets = survivors.facets[bin];
      const std::size_t count = survivors.count[bin];
      const auto corners = [&](std::size_t i) {
        return [&input, facets, count, i](std::size_t lane, int k) {
          return input.vertices +
                 input.facets[facets[i + lane < count ? i + lane : i]][static_cast<std::size_t>(k)];
        };
      };
      fill_bin(bin, corners, facets, count, cells);
    }
  }
}

void rasterize(const RasterInput& input, const RasterTarget& target, RasterSums& sums) {
  switch (input.entries) {
    case Entries::front:
      return rasterize_entries<Entries::front>(input, target, sums);
    case Entries::back:
      return rasterize_entries<Entries::back>(input, target, sums);
    case Entries::both:
      return rasterize_entries<Entries::both>(input, target, sums);
  }
}

void rasterize_back(const MapVertex* corners, const std::uint32_t* facets, std::size_t count, Layer layer,
                    const RasterTarget& target) {
  CellWriter<Entries::back> cells(target);
  LargeFiller<Entries::back> filler(cells);
  for (std::size_t i = 0; i < count; i += 4) {
    const std::size_t lanes = count - i < 4 ? count - i : 4;
    Setup4 setup;
    set_up([&](std::size_t lane, int k) { return corners + 3 * (lane < lanes ? i + lane : i) + k; },
           target.size, setup);
    filler.start_jobs(setup, facets + i, lanes, 0, &layer);
    for (std::size_t lane = 0; lane < lanes; ++lane) filler.add(setup, static_cast<int>(lane), lane);
    filler.finish_jobs(lanes);
  }
}
