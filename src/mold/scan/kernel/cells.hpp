// The entries of a texel, and what is counted as they are written.
#pragma once

#include "mold/scan/kernel/vectors.hpp"

/// What the fragments of one facet share, and what becomes of them.
struct Job {
  std::int64_t front, back;  // entries, but for the height
  std::uint32_t facet;
  Layer layer = k_up_layer;  // of lanes that stand empty too: what is fetched ahead for them is somewhere
  std::uint32_t fragments, lost;  // lost: those that lie behind other facets
};

template <Entries k_entries>
struct CellWriter {
  static constexpr bool k_front = k_entries != Entries::back, k_back = k_entries != Entries::front;

  const RasterTarget& target;
  const float* weights;
  const std::uint32_t* clusters;
  RasterSums* sums;
  const std::int64_t oldest;  // the last entry of older generations

  /// Facets that fragments in front of theirs have hidden, by layer: put down here, counted later, so that
  /// nothing waits for a branch that cannot be foreseen.
  static constexpr std::size_t k_queue_size = 1024;
  std::uint32_t replaced[2][k_queue_size + 4];
  std::size_t replaced_count[2] = {};

  explicit CellWriter(const RasterTarget& of_target, const RasterInput& input = {},
                      RasterSums* of_sums = nullptr)
      : target(of_target),
        weights(input.weights),
        clusters(input.clusters),
        sums(of_sums),
        oldest((static_cast<std::int64_t>(of_target.generation) << 56) - 1) {}
  ~CellWriter() {
    for (const Layer layer : {k_up_layer, k_down_layer}) count_replaced(layer);
  }
  CellWriter(const CellWriter&) = delete;
  CellWriter& operator=(const CellWriter&) = delete;

  inline void start_job(Job& job, std::uint32_t facet, Layer layer) const {
    const std::int64_t front =
        (target.generation << k_height_bits) | (layer == k_up_layer ? 0 : k_height_limit);
    const std::int64_t number = ~facet;
    job.front = front << 32 | number;
    job.back = (front ^ k_height_limit) << 32 | number;
    job.facet = facet;
    job.layer = layer;
    job.fragments = job.lost = 0;
  }

  /// Cells are written some time after they are known: until then they are fetched.
  inline void fetch_ahead(Layer layer, std::int32_t cell) const {
    __builtin_prefetch((k_front ? target.front : target.back)[layer] + cell, 1);
  }

  inline void write_four(std::int32_t cell, Long4 depths, Long4 inside, Job& job) {
    if constexpr (k_front) {
      std::int64_t* front = target.front[job.layer] + cell;
      const Long4 fresh = depths ^ job.front;
      const auto old = load<Long4>(front);
      const Long4 wins = (fresh > old) & inside;
      store(front, wins ? fresh : old);
      const Long4 taken = (old > oldest) & inside;  // by a fragment of the present generation
      const std::uint32_t hides = lanes_set(taken & wins);
      job.lost += bit_count(lanes_set(taken & ~wins));
      queue_replaced(old, hides, job.layer);
    }
    if constexpr (k_back) {
      std::int64_t* back = target.back[job.layer] + cell;
      const Long4 fresh = depths ^ job.back;
      const auto old = load<Long4>(back);
      store(back, (fresh > old) & inside ? fresh : old);
    }
  }

  /// Returns true if the fragment is lost.
  inline bool write_one(std::int32_t cell, std::int32_t height, const Job& job) {
    const std::int64_t depth = static_cast<std::int64_t>(height) << 32;
    bool lost = false;
    if constexpr (k_front) {
      std::int64_t& front = target.front[job.layer][cell];
      const std::int64_t fresh = depth ^ job.front, old = front;
      const bool wins = fresh > old, taken = old > oldest;
      front = wins ? fresh : old;
      lost = taken & !wins;
      std::size_t& count = replaced_count[job.layer];
      replaced[job.layer][count] = facet_of(old);
      count += (taken & wins) ? 1 : 0;
      if (count >= k_queue_size) count_replaced(job.layer);
    }
    if constexpr (k_back) {
      std::int64_t& back = target.back[job.layer][cell];
      const std::int64_t fresh = depth ^ job.back;
      back = fresh > back ? fresh : back;
    }
    return lost;
  }

  inline void queue_replaced(Long4 entries, std::uint32_t which, Layer layer) {
    std::size_t& count = replaced_count[layer];
    auto* end = reinterpret_cast<std::int32_t*>(replaced[layer] + count);
    const Int4 low_halves =
        __builtin_shufflevector(bits_as<Int8>(entries), bits_as<Int8>(entries), 0, 2, 4, 6);
    store_set(end, ~low_halves, which);
    count += bit_count(which);
    if (count >= k_queue_size) count_replaced(layer);
  }

  void count_replaced(Layer layer) {
    if constexpr (k_front) {
      sums->hidden[layer] += replaced_count[layer];
      for (std::size_t i = 0; i < replaced_count[layer]; ++i) {
        const std::uint32_t facet = replaced[layer][i];
        sums->clusters[2 * clusters[facet] + layer].hidden_weight += static_cast<double>(weights[facet]);
      }
    }
    replaced_count[layer] = 0;
  }

  inline void finish_job(const Job& job) {
    if constexpr (!k_front) return;
    if (job.fragments == 0) return;
    sums->fragments[job.layer] += job.fragments;
    sums->hidden[job.layer] += job.lost;
    const double weight = static_cast<double>(weights[job.facet]);
    if (weight <= 0.0) return;
    ClusterSums& cluster = sums->clusters[2 * clusters[job.facet] + job.layer];
    cluster.fragments += job.fragments;
    cluster.weight += weight * static_cast<double>(job.fragments);
    cluster.hidden_weight += weight * static_cast<double>(job.lost);
  }
};
