// Bodies of the scan kernel, included by the files that compile them for one instruction set each, inside a
// namespace of their own. Fixed-point edge functions: every texel centre on a shared edge belongs to exactly
// one facet.
#pragma once

using Int4 = std::int32_t __attribute__((vector_size(16)));
using Float4 = float __attribute__((vector_size(16)));
using Long2 = std::int64_t __attribute__((vector_size(16)));
using Long4 = std::int64_t __attribute__((vector_size(32)));
using Double4 = double __attribute__((vector_size(32)));
using Int8 = std::int32_t __attribute__((vector_size(32)));
using Float8 = float __attribute__((vector_size(32)));

template <typename Vector>
inline Vector load(const void* from) {
  Vector vector;
  __builtin_memcpy(&vector, from, sizeof vector);
  return vector;
}

template <typename Vector>
inline void store(void* to, const Vector& vector) {
  __builtin_memcpy(to, &vector, sizeof vector);
}

/// The same bits as another type.
template <typename To, typename From>
inline To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return load<To>(&from);
}

inline Int4 least(Int4 a, Int4 b) { return a < b ? a : b; }
inline Int4 greatest(Int4 a, Int4 b) { return a > b ? a : b; }

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

/// One bit a lane of a mask vector.
inline std::uint32_t lane_bits(Int8 mask) {
  constexpr Int8 k_lane_bit = {1, 2, 4, 8, 16, 32, 64, 128};
  const Int8 bits = mask & k_lane_bit;
  const Int4 half = load<Int4>(&bits) | load<Int4>(reinterpret_cast<const char*>(&bits) + sizeof(Int4));
  const auto pair = bits_as<Long2>(half);
  const auto folded = static_cast<std::uint64_t>(pair[0] | pair[1]);
  return static_cast<std::uint32_t>(folded | (folded >> 32)) & 0xFFU;
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
    for (std::uint32_t steep = lane_bits(steepness < input.threshold + k_slope_rounding); steep != 0;
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

constexpr std::int32_t k_half_texel = k_subtexel / 2;
constexpr std::size_t k_cull_batch = 1024, k_job_batch = 64;  // facets
constexpr std::int32_t k_tiny_rows = 2, k_short_rows = 4;

/// Facets whose bounding boxes hold texel centres, by the box: of up to k_tiny_rows rows and columns, of up
/// to k_short_rows rows, and others.
enum Bin { k_tiny, k_short, k_tall, k_bins };
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
    const std::uint32_t rows = extents[i] & 0xFFFFU, columns = extents[i] >> 16;
    const std::size_t bin = (rows >= static_cast<std::uint32_t>(k_short_rows) ? 1U : 0U) +
                            ((rows | columns) >= static_cast<std::uint32_t>(k_tiny_rows) ? 1U : 0U);
    survivors.facets[bin][survivors.count[bin]++] = facets[i];
  }
}

inline Double4 to_double(Int4 values) { return __builtin_convertvector(values, Double4); }
inline Long4 widen(Int4 mask) { return __builtin_convertvector(mask, Long4); }

/// What the fragments of one facet share, and what becomes of them.
struct Job {
  std::int64_t front, back;      // entries, but for the height
  std::int32_t lowest, highest;  // heights of the facet
  std::uint32_t facet;
  Layer layer = k_up_layer;  // of lanes that stand empty too: what is fetched ahead for them is somewhere
  std::uint32_t fragments, lost;  // lost: those that lie behind other facets
};

/// Texels next to one another in a row.
struct Span {
  std::uint32_t job;
  std::int32_t cell;  // index in the layer
  std::int32_t count;
  float height, step;  // at the first texel, and from one texel to the next
};
constexpr std::size_t k_span_batch = 512;

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

inline std::uint32_t lanes_set(Int4 mask) {
#if defined(MOLDLIGHT_SCAN_AVX2)
  return static_cast<std::uint32_t>(__builtin_ia32_movmskps(bits_as<Float4>(mask)));
#else
  constexpr Int4 k_bits = {1, 2, 4, 8};
  const Int4 bits = mask & k_bits;
  return static_cast<std::uint32_t>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

inline std::uint32_t lanes_set(Long4 mask) {
#if defined(MOLDLIGHT_SCAN_AVX2)
  return static_cast<std::uint32_t>(__builtin_ia32_movmskpd256(bits_as<Double4>(mask)));
#else
  constexpr Long4 k_bits = {1, 2, 4, 8};
  const Long4 bits = mask & k_bits;
  return static_cast<std::uint32_t>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

inline std::uint32_t bit_count(std::uint32_t four_bits) {
#if defined(MOLDLIGHT_SCAN_AVX2)
  return static_cast<std::uint32_t>(__builtin_popcount(four_bits));
#else
  constexpr std::uint64_t k_counts = 0x4332322132212110U;  // four bits each
  return static_cast<std::uint32_t>(k_counts >> (4 * four_bits)) & 0xFU;
#endif
}

/// Turns facets into fragments and writes them.
template <Entries k_entries>
struct Filler {
  static constexpr bool k_front = k_entries != Entries::back, k_back = k_entries != Entries::front;

  const RasterTarget& target;
  const float* weights;
  const std::uint32_t* clusters;
  RasterSums* sums;
  const std::int64_t oldest;  // the last entry of older generations

  Job jobs[k_job_batch];
  Span spans[k_span_batch];
  std::size_t span_count = 0;

  /// Facets that fragments in front of theirs have hidden, by layer: put down here, counted later, so that
  /// nothing waits for a branch that cannot be foreseen.
  static constexpr std::size_t k_queue_size = 1024;
  std::uint32_t replaced[2][k_queue_size + 4];
  std::size_t replaced_count[2] = {};

  explicit Filler(const RasterTarget& of_target, const RasterInput& input = {}, RasterSums* of_sums = nullptr)
      : target(of_target),
        weights(input.weights),
        clusters(input.clusters),
        sums(of_sums),
        oldest((static_cast<std::int64_t>(of_target.generation) << 56) - 1) {}
  ~Filler() {
    for (const Layer layer : {k_up_layer, k_down_layer}) count_replaced(layer);
  }
  Filler(const Filler&) = delete;
  Filler& operator=(const Filler&) = delete;

  inline void start_job(Job& job, std::uint32_t facet, Layer layer, float lowest, float highest) const {
    const std::int64_t front =
        (target.generation << k_height_bits) | (layer == k_up_layer ? 0 : k_height_limit);
    const std::int64_t number = ~facet;
    job.front = front << 32 | number;
    job.back = (front ^ k_height_limit) << 32 | number;
    job.lowest = static_cast<std::int32_t>(lowest);
    job.highest = static_cast<std::int32_t>(highest);
    job.facet = facet;
    job.layer = layer;
    job.fragments = job.lost = 0;
  }

  inline void start_jobs(const Setup4& setup, const std::uint32_t* facets, std::size_t count,
                         std::size_t first_job, const Layer* only_layer) {
    for (std::size_t lane = 0; lane < count; ++lane) {
      const int l = static_cast<int>(lane);
      const Layer layer = only_layer != nullptr      ? *only_layer
                          : setup.faces_down[l] != 0 ? k_down_layer
                                                     : k_up_layer;
      start_job(jobs[first_job + lane], facets[lane], layer, setup.lowest[l], setup.highest[l]);
    }
  }

  inline void add_span(std::size_t job, std::int32_t cell, std::int32_t count, float height, float step) {
    spans[span_count] = {static_cast<std::uint32_t>(job), cell, count, height, step};
    span_count += count > 0 ? 1 : 0;
    // Written only after the other facets of the batch: by then the entries are at hand.
    if constexpr (k_front) __builtin_prefetch(target.front[jobs[job].layer] + cell, 1);
  }

  /// Spans of one row each of four triangles or of four rows of one triangle.
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

  /// Four triangles at a time, row by row.
  inline void add_short(const Setup4& setup, std::size_t lanes, std::size_t first_job) {
    const Double4 width = to_double(setup.width) + 0.5;
    const Int4 rows = (Int4{0, 1, 2, 3} < static_cast<std::int32_t>(lanes)) ? setup.rows : Int4{};
    const Int4 origin = setup.y0 * target.pitch + setup.x0;
    const Float4 steps = __builtin_convertvector(setup.height_x, Float4);
    for (std::int32_t row = 0; row < k_short_rows && lanes_set(rows > row) != 0; ++row) {
      const Double4 at_row = Double4{} + static_cast<double>(row);
      const Columns found = columns(setup.bound, setup.bound_step, setup.is_upper, at_row, width);
      const Int4 count = rows > row ? found.count : Int4{};
      const Double4 raw = setup.height + setup.height_x * to_double(found.first) + setup.height_y * at_row;
      const Float4 heights = within(__builtin_convertvector(raw, Float4), setup.lowest, setup.highest);
      const Int4 cells = origin + row * target.pitch + found.first;
      for (int lane = 0; lane < 4; ++lane) {
        add_span(first_job + static_cast<std::size_t>(lane), cells[lane], count[lane], heights[lane],
                 steps[lane]);
      }
    }
  }

  /// One triangle of any size, four rows at a time.
  inline void add_tall(const Setup4& setup, int lane, std::size_t job) {
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
    const Float4 lowest = Float4{} + setup.lowest[lane], highest = Float4{} + setup.highest[lane];
    const auto height_step = static_cast<float>(setup.height_x[lane]);
    const std::int32_t rows = setup.rows[lane], origin = setup.y0[lane] * target.pitch + setup.x0[lane];
    for (std::int32_t row = 0; row < rows; row += 4) {
      const Int4 row_numbers = k_rows + row;
      const Double4 at_row = to_double(row_numbers);
      const Columns found = columns(bound, step, is_upper, at_row, width);
      const Int4 count = row_numbers < rows ? found.count : Int4{};
      if (lanes_set(count > 0) == 0) continue;
      const Double4 raw = setup.height[lane] + height_x * to_double(found.first) + height_y * at_row;
      const Float4 heights = within(__builtin_convertvector(raw, Float4), lowest, highest);
      const Int4 cells = origin + row_numbers * target.pitch + found.first;
      for (int r = 0; r < 4; ++r) add_span(job, cells[r], count[r], heights[r], height_step);
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
      const Int4 lowest = Int4{} + job.lowest, highest = Int4{} + job.highest;
      Float4 heights = span.height + span.step * k_texel;
      for (std::int32_t done = 0; done < span.count; done += 4, heights += 4.0F * span.step) {
        const Int4 h = least(greatest(__builtin_convertvector(heights, Int4), lowest), highest);
        const std::int32_t left = span.count - done;
        write_four(span.cell + done, __builtin_convertvector(h, Long4) << 32,
                   load<Long4>(k_inside + 4 - (left < 4 ? left : 4)), job);
      }
      job.fragments += static_cast<std::uint32_t>(span.count);
    }
    span_count = 0;
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
    std::uint32_t* end = replaced[layer] + count;
#if defined(MOLDLIGHT_SCAN_AVX2)
    // The low halves of the entries whose bits are set come first.
    alignas(32) static constexpr std::int32_t k_places[16][8] = {
        {0, 0, 0, 0}, {0, 0, 0, 0}, {2, 0, 0, 0}, {0, 2, 0, 0}, {4, 0, 0, 0}, {0, 4, 0, 0},
        {2, 4, 0, 0}, {0, 2, 4, 0}, {6, 0, 0, 0}, {0, 6, 0, 0}, {2, 6, 0, 0}, {0, 2, 6, 0},
        {4, 6, 0, 0}, {0, 4, 6, 0}, {2, 4, 6, 0}, {0, 2, 4, 6}};
    const auto packed =
        bits_as<Int8>(__builtin_ia32_permvarsi256(bits_as<Int8>(entries), load<Int8>(k_places[which])));
    store(end, ~load<Int4>(&packed));
#else
    for (std::uint32_t lane = 0, at = 0; lane < 4; at += which >> lane & 1U, ++lane)
      end[at] = facet_of(entries[static_cast<int>(lane)]);
#endif
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

  void finish_jobs(std::size_t count) {
    flush();
    if constexpr (k_front) {
      for (std::size_t i = 0; i < count; ++i) finish_job(jobs[i]);
    }
  }

  /// Four triangles of at most two by two texel centres, each centre tested by itself.
  template <typename Corner>
  inline void add_tiny(const Corner& corner, const std::uint32_t* facets, std::size_t lanes) {
    Corners4 corners = load_corners(corner);
    const Int4 *x = corners.x, *y = corners.y;
    const Float4* z = corners.z;
    const Int4 signed_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    const Int4 down = signed_area < 0;
    reverse(down, corners);
    const Int4 area = down ? -signed_area : signed_area;
    const Box4 box = box_of(corners, target.size);
    const Int4 px = box.left * k_subtexel + k_half_texel, py = box.bottom * k_subtexel + k_half_texel;
    // Edge functions at the first centre, less one where ties are the neighbour's, and their steps.
    Int4 value[3], dx[3], dy[3];
    for (int e = 0; e < 3; ++e) {
      const int f = e == 2 ? 0 : e + 1;
      dx[e] = x[f] - x[e];
      dy[e] = y[f] - y[e];
      value[e] = dx[e] * (py - y[e]) - dy[e] * (px - x[e]);
    }
    const Int4 exists = (Int4{0, 1, 2, 3} < static_cast<std::int32_t>(lanes)) & (area > 0);
    const Float4 inverse = 1.0F / __builtin_convertvector(area, Float4);
    const Float4 rise1 = (z[1] - z[0]) * inverse, rise2 = (z[2] - z[0]) * inverse;
    const Float4 low01 = z[0] < z[1] ? z[0] : z[1], high01 = z[0] < z[1] ? z[1] : z[0];
    const Float4 lowest = low01 < z[2] ? low01 : z[2], highest = high01 < z[2] ? z[2] : high01;
    std::uint32_t covered[4];
    Float4 heights[4];
    Int4 fragments = {};
    for (int k = 0; k < 4; ++k) {
      const std::int32_t column = k & 1, row = k >> 1;
      Int4 inside = exists & (box.left + column <= box.right) & (box.bottom + row <= box.top);
      Int4 at[3];
      for (int e = 0; e < 3; ++e) {
        at[e] = value[e] + (row * dx[e] - column * dy[e]) * k_subtexel;
        inside &= at[e] + yields_ties(dx[e], dy[e]) >= 0;
      }
      covered[k] = lanes_set(inside);
      fragments -= inside;
      heights[k] = z[0] + rise1 * __builtin_convertvector(at[2], Float4) +
                   rise2 * __builtin_convertvector(at[0], Float4);
    }
    const Int4 cells = box.bottom * target.pitch + box.left;
    for (std::uint32_t any = covered[0] | covered[1] | covered[2] | covered[3]; any != 0; any &= any - 1) {
      const int lane = __builtin_ctz(any);
      Job job;
      start_job(job, facets[lane], down[lane] != 0 ? k_down_layer : k_up_layer, lowest[lane], highest[lane]);
      for (int k = 0; k < 4; ++k) {
        if ((covered[k] >> lane & 1U) == 0) continue;
        const auto height = static_cast<std::int32_t>(heights[k][lane]);
        const std::int32_t least_height = height < job.lowest ? job.lowest : height;
        const std::int32_t within = least_height > job.highest ? job.highest : least_height;
        job.lost += write_one(cells[lane] + (k >> 1) * target.pitch + (k & 1), within, job) ? 1 : 0;
      }
      job.fragments = static_cast<std::uint32_t>(fragments[lane]);
      if constexpr (k_front) finish_job(job);
    }
  }
};

template <Entries k_entries>
inline void rasterize_entries(const RasterInput& input, const RasterTarget& target, RasterSums& sums) {
  Survivors survivors;
  Filler<k_entries> filler(target, input, &sums);
  for (std::size_t begin = 0; begin < input.facet_count; begin += k_cull_batch) {
    cull(input, begin, begin + k_cull_batch < input.facet_count ? begin + k_cull_batch : input.facet_count,
         survivors);
    for (int bin = 0; bin < k_bins; ++bin) {
      const std::uint32_t* facets = survivors.facets[bin];
      const std::size_t count = survivors.count[bin];
      std::size_t job = 0;
      for (std::size_t i = 0; i < count; i += 4) {
        const std::size_t lanes = count - i < 4 ? count - i : 4;
        const auto corner = [&](std::size_t lane, int k) {
          return input.vertices +
                 input.facets[facets[lane < lanes ? i + lane : i]][static_cast<std::size_t>(k)];
        };
        if (bin == k_tiny) {
          filler.add_tiny(corner, facets + i, lanes);
          continue;
        }
        if (job == k_job_batch) {
          filler.finish_jobs(job);
          job = 0;
        }
        Setup4 setup;
        set_up(corner, target.size, setup);
        filler.start_jobs(setup, facets + i, lanes, job, nullptr);
        if (bin == k_short) {
          filler.add_short(setup, lanes, job);
        } else {
          for (std::size_t lane = 0; lane < lanes; ++lane)
            filler.add_tall(setup, static_cast<int>(lane), job + lane);
        }
        job += lanes;
      }
      filler.finish_jobs(job);
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
  Filler<Entries::back> filler(target);
  for (std::size_t i = 0; i < count; i += 4) {
    const std::size_t lanes = count - i < 4 ? count - i : 4;
    Setup4 setup;
    set_up([&](std::size_t lane, int k) { return corners + 3 * (lane < lanes ? i + lane : i) + k; },
           target.size, setup);
    filler.start_jobs(setup, facets + i, lanes, 0, &layer);
    for (std::size_t lane = 0; lane < lanes; ++lane) filler.add_tall(setup, static_cast<int>(lane), lane);
    filler.finish_jobs(lanes);
  }
}
