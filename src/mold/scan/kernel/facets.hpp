// All facets for a direction: places of their vertices, classes, and which may hold texel centres.
#pragma once

#include "mold/scan/kernel/triangles.hpp"
#include "mold/scan/kernel/vectors.hpp"

void transform(const float* positions, std::size_t count, const Projection& projection, MapVertex* vertices) {
  const auto c0 = load<Float4>(projection.column[0]), c1 = load<Float4>(projection.column[1]),
             c2 = load<Float4>(projection.column[2]), offset = load<Float4>(projection.offset);
  constexpr Float4 k_half = {0.5F, 0.5F, 0.0F, 0.0F};
  constexpr Int4 k_is_integer = {-1, -1, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const auto p = load<Float4>(positions + 4 * i);
    const Float4 value = ((p[0] * c0 + p[1] * c1) + p[2] * c2) + offset;
    const Int4 rounded = __builtin_convertvector(value + k_half, Int4);  // x and y are not negative
    const Int4 mixed = k_is_integer ? rounded : bits_as<Int4>(value);
    store(vertices + i, mixed);
  }
}

void classify(const ClassifyInput& input, ClassifyOutput& output) {
  using Double8 = double __attribute__((vector_size(64)));
  Double8 area_sum[3] = {}, projected_sum = {};
  output.steep_count = 0;
  for (std::size_t i = 0; i < input.padded_count; i += 8) {
    const Float8 sine = (load<Float8>(input.normal_x + i) * input.direction[0] +
                         load<Float8>(input.normal_y + i) * input.direction[1]) +
                        load<Float8>(input.normal_z + i) * input.direction[2];
    const Float8 area = load<Float8>(input.areas + i);
    const Float8 steepness = sine < 0.0F ? -sine : sine;
    const Int8 vertical = steepness < input.threshold;
    const Int8 down = (sine < 0.0F) & ~vertical;
    const Int8 classes = (down & 1) | (vertical & 2);
    const Float8 weight = vertical ? Float8{} : 1.0F / steepness;
    store(output.classes + i, classes);
    store(output.weights + i, weight);
    const Int8 masks[3] = {~(down | vertical), down, vertical};
    for (int c = 0; c < 3; ++c) area_sum[c] += __builtin_convertvector(masks[c] ? area : Float8{}, Double8);
    projected_sum += __builtin_convertvector(area * steepness, Double8);
    for (std::uint32_t steep = lanes_set(steepness < input.threshold + k_slope_rounding); steep != 0;
         steep &= steep - 1) {
      output.steep[output.steep_count++] =
          static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(__builtin_ctz(steep));
    }
  }
  for (int lane = 0; lane < 8; ++lane) {
    for (int c = 0; c < 3; ++c) output.class_area[c] += area_sum[c][lane];
    output.projected_area += projected_sum[lane];
  }
}

constexpr std::size_t k_cull_batch = 1024;  // facets

/// Facets whose bounding boxes hold texel centres, by the box: of up to k_tiny texels either way, of up to
/// k_small_rows and k_small_columns, and others.
constexpr std::int32_t k_tiny = 2, k_small_rows = 48, k_small_columns = 16;
enum Bin { k_tiny_bin, k_small_bin, k_large_bin, k_bins };
struct Survivors {
  std::uint32_t facets[k_bins][k_cull_batch];
  std::size_t count[k_bins];
};

void cull(const RasterInput& input, std::size_t begin, std::size_t end, Survivors& survivors) {
  constexpr Int4 k_up = {k_half_texel - 1, k_half_texel - 1, 0, 0};
  constexpr Int4 k_down = {k_half_texel, k_half_texel, 0, 0};
  std::uint32_t facets[k_cull_batch], extents[k_cull_batch];
  std::size_t found = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const auto& facet = input.facets[i];
    const auto a = load<Int4>(input.vertices + facet[0]);
    const auto b = load<Int4>(input.vertices + facet[1]);
    const auto c = load<Int4>(input.vertices + facet[2]);
    const Int4 low = (least(least(a, b), c) + k_up) >> k_subtexel_bits;
    const Int4 high = (greatest(greatest(a, b), c) - k_down) >> k_subtexel_bits;
    // Two 32-bit numbers, columns and rows less one, negative where there are none.
    const auto extent = static_cast<std::uint64_t>(bits_as<Long2>(high - low)[0]);
    facets[found] = static_cast<std::uint32_t>(i);
    extents[found] = static_cast<std::uint32_t>(extent >> 32 | extent << 16);  // either is below 2^14
    found += (extent & 0x8000000080000000U) == 0 ? 1 : 0;
  }
  for (std::size_t& count : survivors.count) count = 0;
  for (std::size_t i = 0; i < found; ++i) {
    const auto rows = static_cast<std::int32_t>(extents[i] & 0xFFFFU),
               columns = static_cast<std::int32_t>(extents[i] >> 16);
    const std::size_t bin = (rows >= k_small_rows || columns >= k_small_columns ? 1U : 0U) +
                            (rows >= k_tiny || columns >= k_tiny ? 1U : 0U);
    survivors.facets[bin][survivors.count[bin]++] = facets[i];
  }
}
