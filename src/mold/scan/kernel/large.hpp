// Triangles of any size, as spans.
#pragma once

#include "mold/scan/kernel/cells.hpp"
#include "mold/scan/kernel/triangles.hpp"
#include "mold/scan/kernel/vectors.hpp"

/// Texels next to one another in a row.
struct Span {
  std::uint32_t job;
  std::int32_t cell;  // index in the layer
  std::int32_t count;
  float height, step;  // at the first texel, and from one texel to the next
};
constexpr std::size_t k_span_batch = 512, k_job_batch = 64;

/// Four triangles ready to be filled, one a lane. Rows count from y0, columns from x0; heights are at texel
/// centres.
struct Setup4 {
  Double4 bound[3],
      bound_step[3];  // where each edge crosses row 0, and how far it moves with each row, in texels
  Long4 is_upper[3];  // the edge bounds the columns from above; otherwise minus the columns
  Double4 height, height_x, height_y;
  Float4 lowest, highest;
  Int4 x0, y0, width, rows;  // no rows where there is nothing to fill
  Int4 faces_down;           // mask
};

/// Sets up triangles of either winding.
///
/// Spans are exact: a column is inside an edge if it is not above a quotient of integers (as a double), which
/// is moved off the integers by half a step of the numerator; that is more than all roundings together.
template <typename Corner>
inline void set_up(const Corner& corner, int size, Setup4& setup) {
  Corners4 corners = load_corners(corner);
  const Int4 *x = corners.x, *y = corners.y;
  const Float4* z = corners.z;
  // Counter-clockwise.
  const Double4 signed_area =
      to_double(x[1] - x[0]) * to_double(y[2] - y[0]) - to_double(x[2] - x[0]) * to_double(y[1] - y[0]);
  const Int4 down = __builtin_convertvector(signed_area < 0.0, Int4);
  reverse(down, corners);
  const Double4 area = signed_area < 0.0 ? -signed_area : signed_area;

  const auto [left, right, bottom, top] = box_of(corners, size);
  const Int4 has_area = __builtin_convertvector(area > 0.0, Int4);
  setup.x0 = left;
  setup.y0 = bottom;
  setup.width = right - left;
  setup.rows = (setup.width >= 0) & has_area ? greatest(top - bottom + 1, Int4{}) : Int4{};
  setup.faces_down = down;

  const Int4 px = left * k_subtexel + k_half_texel, py = bottom * k_subtexel + k_half_texel;
  for (int e = 0; e < 3; ++e) {
    const int f = e == 2 ? 0 : e + 1;
    const Int4 dx = x[f] - x[e], dy = y[f] - y[e];
    const Double4 across = to_double(dx), along = to_double(dy);
    const Double4 value =
        across * to_double(py - y[e]) - along * to_double(px - x[e]) + (to_double(yields_ties(dx, dy)) + 0.5);
    // A level edge is as good as almost level: it lets in either all columns or none.
    const Double4 rise = along < 0.0 ? -along : along;
    const Double4 inverse = 1.0 / ((rise == 0.0 ? Double4{} + 0x1p-30 : rise) * k_subtexel);
    setup.bound[e] = value * inverse;
    setup.bound_step[e] = across * inverse * k_subtexel;
    setup.is_upper[e] = widen(dy >= 0);
  }
  const Float4 rise1 = z[1] - z[0], rise2 = z[2] - z[0];
  const Double4 up1 = __builtin_convertvector(rise1, Double4), up2 = __builtin_convertvector(rise2, Double4);
  const Double4 per_texel = k_subtexel / area;
  setup.height_x = (up1 * to_double(y[2] - y[0]) - up2 * to_double(y[1] - y[0])) * per_texel;
  setup.height_y = (up2 * to_double(x[1] - x[0]) - up1 * to_double(x[2] - x[0])) * per_texel;
  constexpr double k_texel_share = 1.0 / k_subtexel;
  setup.height = __builtin_convertvector(z[0], Double4) +
                 setup.height_x * (to_double(px - x[0]) * k_texel_share) +
                 setup.height_y * (to_double(py - y[0]) * k_texel_share);
  const Float4 low01 = z[0] < z[1] ? z[0] : z[1], high01 = z[0] < z[1] ? z[1] : z[0];
  setup.lowest = low01 < z[2] ? low01 : z[2];
  setup.highest = high01 < z[2] ? z[2] : high01;
}

/// Fills triangles of any size.
template <Entries k_entries>
struct LargeFiller {
  CellWriter<k_entries>& cells;
  Job jobs[k_job_batch];
  std::int32_t lowest[k_job_batch], highest[k_job_batch];  // heights of the facets
  Span spans[k_span_batch];
  std::size_t span_count = 0;

  explicit LargeFiller(CellWriter<k_entries>& of_cells) : cells(of_cells) {}

  inline void start_jobs(const Setup4& setup, const std::uint32_t* facets, std::size_t count,
                         std::size_t first_job, const Layer* only_layer) {
    for (std::size_t lane = 0; lane < count; ++lane) {
      const int l = static_cast<int>(lane);
      const Layer layer = only_layer != nullptr      ? *only_layer
                          : setup.faces_down[l] != 0 ? k_down_layer
                                                     : k_up_layer;
      cells.start_job(jobs[first_job + lane], facets[lane], layer);
      lowest[first_job + lane] = static_cast<std::int32_t>(setup.lowest[l]);
      highest[first_job + lane] = static_cast<std::int32_t>(setup.highest[l]);
    }
  }

  inline void add_span(std::size_t job, std::int32_t cell, std::int32_t count, float height, float step) {
    spans[span_count] = {static_cast<std::uint32_t>(job), cell, count, height, step};
    span_count += count > 0 ? 1 : 0;
    cells.fetch_ahead(jobs[job].layer, cell);
  }

  /// Of four rows of one triangle.
  struct Columns {
    Int4 first, count;
  };
  static inline Columns columns(const Double4 bound[3], const Double4 step[3], const Long4 is_upper[3],
                                Double4 row, Double4 width) {
    constexpr double k_far = 65536.0;  // texels; beyond every map
    constexpr auto k_offset = static_cast<std::int32_t>(k_far);
    const Double4 at0 = bound[0] + step[0] * row, at1 = bound[1] + step[1] * row,
                  at2 = bound[2] + step[2] * row;
    Double4 upper = width, lower = Double4{} + 0.5;  // last column, and minus the first, before rounding down
    upper = (at0 < upper) & is_upper[0] ? at0 : upper;
    lower = (at0 < lower) & ~is_upper[0] ? at0 : lower;
    upper = (at1 < upper) & is_upper[1] ? at1 : upper;
    lower = (at1 < lower) & ~is_upper[1] ? at1 : lower;
    upper = (at2 < upper) & is_upper[2] ? at2 : upper;
    lower = (at2 < lower) & ~is_upper[2] ? at2 : lower;
    const Double4 far = Double4{} - k_far;
    upper = upper < far ? far : upper;
    lower = lower < far ? far : lower;
    const Int4 end = __builtin_convertvector(upper + k_far, Int4) - (k_offset - 1);
    const Int4 first = k_offset - __builtin_convertvector(lower + k_far, Int4);
    return {first, end - first};
  }

  static inline Float4 within(Float4 heights, Float4 lowest, Float4 highest) {
    heights = heights < lowest ? lowest : heights;
    return heights > highest ? highest : heights;
  }

  /// One triangle, four rows at a time.
  inline void add(const Setup4& setup, int lane, std::size_t job) {
    Double4 bound[3], step[3];
    Long4 is_upper[3];
    for (int e = 0; e < 3; ++e) {
      bound[e] = Double4{} + setup.bound[e][lane];
      step[e] = Double4{} + setup.bound_step[e][lane];
      is_upper[e] = Long4{} + setup.is_upper[e][lane];
    }
    constexpr Int4 k_rows = {0, 1, 2, 3};
    const Double4 width = Double4{} + (static_cast<double>(setup.width[lane]) + 0.5);
    const Double4 height_x = Double4{} + setup.height_x[lane], height_y = Double4{} + setup.height_y[lane];
    const auto height_step = static_cast<float>(setup.height_x[lane]);
    const std::int32_t rows = setup.rows[lane], origin = setup.y0[lane] * cells.target.pitch + setup.x0[lane];
    for (std::int32_t row = 0; row < rows; row += 4) {
      const Int4 row_numbers = k_rows + row;
      const Double4 at_row = to_double(row_numbers);
      const Columns found = columns(bound, step, is_upper, at_row, width);
      const Int4 count = row_numbers < rows ? found.count : Int4{};
      if (lanes_set(count > 0) == 0) continue;
      const Double4 raw = setup.height[lane] + height_x * to_double(found.first) + height_y * at_row;
      const Float4 heights = within(__builtin_convertvector(raw, Float4), Float4{} + setup.lowest[lane],
                                    Float4{} + setup.highest[lane]);
      const Int4 at = origin + row_numbers * cells.target.pitch + found.first;
      for (int r = 0; r < 4; ++r) add_span(job, at[r], count[r], heights[r], height_step);
      if (span_count + 4 > k_span_batch) flush();
    }
  }

  void flush() {
    constexpr Float4 k_texel = {0, 1, 2, 3};
    // Texels inside a span of n: four lanes from k_inside[4 - n] on.
    alignas(32) static constexpr std::int64_t k_inside[8] = {-1, -1, -1, -1, 0, 0, 0, 0};
    for (std::size_t i = 0; i < span_count; ++i) {
      const Span& span = spans[i];
      Job& job = jobs[span.job];
      const Int4 least_height = Int4{} + lowest[span.job], greatest_height = Int4{} + highest[span.job];
      Float4 heights = span.height + span.step * k_texel;
      for (std::int32_t done = 0; done < span.count; done += 4, heights += 4.0F * span.step) {
        const Int4 h = least(greatest(__builtin_convertvector(heights, Int4), least_height), greatest_height);
        const std::int32_t left = span.count - done;
        cells.write_four(span.cell + done, __builtin_convertvector(h, Long4) << 32,
                         load<Long4>(k_inside + 4 - (left < 4 ? left : 4)), job);
      }
      job.fragments += static_cast<std::uint32_t>(span.count);
    }
    span_count = 0;
  }

  void finish_jobs(std::size_t count) {
    flush();
    for (std::size_t i = 0; i < count; ++i) cells.finish_job(jobs[i]);
  }
};
