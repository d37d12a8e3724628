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
constexpr std::int32_t k_short_rows = 4;

/// Facets whose bounding boxes hold texel centres: of up to k_short_rows rows, and of more.
struct Survivors {
  std::uint32_t facets[2][k_cull_batch];
  std::size_t count[2];
};

void cull(const RasterInput& input, std::size_t begin, std::size_t end, Survivors& survivors) {
  constexpr Int4 k_up = {k_half_texel - 1, k_half_texel - 1, 0, 0};
  constexpr Int4 k_down = {k_half_texel, k_half_texel, 0, 0};
  survivors.count[0] = survivors.count[1] = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const auto& facet = input.facets[i];
    const auto a = load<Int4>(input.vertices + facet[0]);
    const auto b = load<Int4>(input.vertices + facet[1]);
    const auto c = load<Int4>(input.vertices + facet[2]);
    const Int4 low = (least(least(a, b), c) + k_up) >> k_subtexel_bits;
    const Int4 high = (greatest(greatest(a, b), c) - k_down) >> k_subtexel_bits;
    // Two 32-bit numbers, columns and rows less one, negative where there are none.
    const auto extent = static_cast<std::uint64_t>(bits_as<Long2>(high - low)[0]);
    const std::size_t tall =
        static_cast<std::int64_t>(extent) >= static_cast<std::int64_t>(k_short_rows) << 32 ? 1 : 0;
    survivors.facets[tall][survivors.count[tall]] = static_cast<std::uint32_t>(i);
    survivors.count[tall] += (extent & 0x8000000080000000U) == 0 ? 1 : 0;
  }
}

inline Double4 to_double(Int4 values) { return __builtin_convertvector(values, Double4); }
inline Long4 widen(Int4 mask) { return __builtin_convertvector(mask, Long4); }

/// What the fragments of one facet share, and what becomes of them.
struct alignas(16) Job {
  Int4 key;                      // entries of a cell, but for the height
  std::int32_t lowest, highest;  // heights of the facet
  std::uint32_t facet;
  Layer layer;
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

/// `corner(lane, k)` is a pointer to corner k of a triangle of either winding.
///
/// Spans are exact: a column is inside an edge if it is not above a quotient of integers (as a double), which
/// is moved off the integers by half a step of the numerator; that is more than all roundings together.
template <typename Corner>
inline void set_up(const Corner& corner, int size, Setup4& setup) {
  Int4 x[3], y[3];
  Float4 z[3];
  for (int k = 0; k < 3; ++k) {
    const auto a = load<Int4>(corner(0, k)), b = load<Int4>(corner(1, k)), c = load<Int4>(corner(2, k)),
               d = load<Int4>(corner(3, k));
    const Int4 ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    x[k] = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
    y[k] = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
    const Int4 ab_z = __builtin_shufflevector(a, b, 2, 6, 3, 7),
               cd_z = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    z[k] = bits_as<Float4>(__builtin_shufflevector(ab_z, cd_z, 0, 1, 4, 5));
  }
  // Counter-clockwise.
  const Double4 signed_area =
      to_double(x[1] - x[0]) * to_double(y[2] - y[0]) - to_double(x[2] - x[0]) * to_double(y[1] - y[0]);
  const Int4 down = __builtin_convertvector(signed_area < 0.0, Int4);
  const Int4 x1 = down ? x[2] : x[1], y1 = down ? y[2] : y[1];
  const Float4 z1 = down ? z[2] : z[1];
  x[2] = down ? x[1] : x[2];
  y[2] = down ? y[1] : y[2];
  z[2] = down ? z[1] : z[2];
  x[1] = x1;
  y[1] = y1;
  z[1] = z1;
  const Double4 area = signed_area < 0.0 ? -signed_area : signed_area;

  const Int4 zero = {}, last = zero + (size - 1);
  const Int4 left = greatest((least(least(x[0], x[1]), x[2]) + (k_half_texel - 1)) >> k_subtexel_bits, zero);
  const Int4 bottom =
      greatest((least(least(y[0], y[1]), y[2]) + (k_half_texel - 1)) >> k_subtexel_bits, zero);
  const Int4 right = least((greatest(greatest(x[0], x[1]), x[2]) - k_half_texel) >> k_subtexel_bits, last);
  const Int4 top = least((greatest(greatest(y[0], y[1]), y[2]) - k_half_texel) >> k_subtexel_bits, last);
  const Int4 has_area = __builtin_convertvector(area > 0.0, Int4);
  setup.x0 = left;
  setup.y0 = bottom;
  setup.width = right - left;
  setup.rows = (setup.width >= 0) & has_area ? greatest(top - bottom + 1, zero) : zero;
  setup.faces_down = down;

  const Int4 px = left * k_subtexel + k_half_texel, py = bottom * k_subtexel + k_half_texel;
  for (int e = 0; e < 3; ++e) {
    const int f = e == 2 ? 0 : e + 1;
    const Int4 dx = x[f] - x[e], dy = y[f] - y[e];
    const Double4 across = to_double(dx), along = to_double(dy);
    // Texel centres on an edge belong to one of the two facets there.
    const Int4 takes_ties = (dy < 0) | ((dy == 0) & (dx > 0));
    const Double4 value =
        across * to_double(py - y[e]) - along * to_double(px - x[e]) + (to_double(takes_ties) + 0.5);
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

inline bool any_front(Long4 mask) {
#if defined(MOLDLIGHT_SCAN_AVX2)
  return (__builtin_ia32_movmskpd256(bits_as<Double4>(mask)) & 5) != 0;
#else
  return (mask[0] | mask[2]) != 0;
#endif
}

/// Turns facets into spans and writes them. With k_back_only, front entries and sums are left alone.
template <bool k_back_only>
struct Filler {
  const RasterTarget& target;
  const float* weights;
  const std::uint32_t* clusters;
  RasterSums* sums;

  Job jobs[k_job_batch];
  Span spans[k_span_batch];
  std::size_t span_count = 0;

  explicit Filler(const RasterTarget& of_target, const RasterInput& input = {}, RasterSums* of_sums = nullptr)
      : target(of_target), weights(input.weights), clusters(input.clusters), sums(of_sums) {}

  inline void start_jobs(const Setup4& setup, const std::uint32_t* facets, std::size_t count,
                         std::size_t first_job, const Layer* only_layer) {
    for (std::size_t lane = 0; lane < count; ++lane) {
      const int l = static_cast<int>(lane);
      Job& job = jobs[first_job + lane];
      job.layer = only_layer != nullptr ? *only_layer : setup.faces_down[l] != 0 ? k_down_layer : k_up_layer;
      const std::int32_t front =
          (target.generation << k_height_bits) | (job.layer == k_up_layer ? 0 : k_height_limit);
      const auto number = static_cast<std::int32_t>(~facets[lane]);
      job.key = Int4{number, front, number, front ^ k_height_limit};
      job.lowest = static_cast<std::int32_t>(setup.lowest[l]);
      job.highest = static_cast<std::int32_t>(setup.highest[l]);
      job.facet = facets[lane];
      job.fragments = job.lost = 0;
    }
  }

  inline void add_span(std::size_t job, std::int32_t cell, std::int32_t count, float height, float step) {
    spans[span_count] = {static_cast<std::uint32_t>(job), cell, count, height, step};
    span_count += count > 0 ? 1 : 0;
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
    const Int4 origin = setup.y0 * target.size + setup.x0;
    const Float4 steps = __builtin_convertvector(setup.height_x, Float4);
    for (std::int32_t row = 0; row < k_short_rows && lanes_set(rows > row) != 0; ++row) {
      const Double4 at_row = Double4{} + static_cast<double>(row);
      const Columns found = columns(setup.bound, setup.bound_step, setup.is_upper, at_row, width);
      const Int4 count = rows > row ? found.count : Int4{};
      const Double4 raw = setup.height + setup.height_x * to_double(found.first) + setup.height_y * at_row;
      const Float4 heights = within(__builtin_convertvector(raw, Float4), setup.lowest, setup.highest);
      const Int4 cells = origin + row * target.size + found.first;
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
    const std::int32_t rows = setup.rows[lane], origin = setup.y0[lane] * target.size + setup.x0[lane];
    for (std::int32_t row = 0; row < rows; row += 4) {
      const Int4 row_numbers = k_rows + row;
      const Double4 at_row = to_double(row_numbers);
      const Columns found = columns(bound, step, is_upper, at_row, width);
      const Int4 count = row_numbers < rows ? found.count : Int4{};
      if (lanes_set(count > 0) == 0) continue;
      const Double4 raw = setup.height[lane] + height_x * to_double(found.first) + height_y * at_row;
      const Float4 heights = within(__builtin_convertvector(raw, Float4), lowest, highest);
      const Int4 cells = origin + row_numbers * target.size + found.first;
      for (int r = 0; r < 4; ++r) add_span(job, cells[r], count[r], heights[r], height_step);
      if (span_count + 4 > k_span_batch) flush();
    }
  }

  void flush() {
    constexpr Float4 k_texel = {0, 1, 2, 3};
    // Texels inside a span of n: two lanes each from k_inside[8 - 2n] on.
    alignas(32) static constexpr std::int64_t k_inside[16] = {-1, -1, -1, -1, -1, -1, -1, -1,
                                                              0,  0,  0,  0,  0,  0,  0,  0};
    const Long4 oldest = Long4{} + ((static_cast<std::int64_t>(target.generation) << 56) - 1);
    for (std::size_t i = 0; i < span_count; ++i) {
      const Span& span = spans[i];
      Job& job = jobs[span.job];
      const Int8 key = __builtin_shufflevector(job.key, job.key, 0, 1, 2, 3, 0, 1, 2, 3);
      const Int4 lowest = Int4{} + job.lowest, highest = Int4{} + job.highest;
      MapCell* cell = target.layer[job.layer] + span.cell;
      Float4 heights = span.height + span.step * k_texel;
      Long4 lost = {};  // minus their number, in the lanes of front entries
      for (std::int32_t count = span.count;;) {
        const Int4 h = least(greatest(__builtin_convertvector(heights, Int4), lowest), highest);
        const std::int64_t* inside = k_inside + (count < 4 ? 8 - 2 * count : 0);
        write_pair(cell, __builtin_shufflevector(h, h, 0, 0, 0, 0, 1, 1, 1, 1), key, load<Long4>(inside),
                   oldest, job, lost);
        if (count <= 2) break;
        write_pair(cell + 2, __builtin_shufflevector(h, h, 2, 2, 2, 2, 3, 3, 3, 3), key,
                   load<Long4>(inside + 4), oldest, job, lost);
        if (count <= 4) break;
        count -= 4;
        cell += 4;
        heights += 4.0F * span.step;
      }
      if constexpr (!k_back_only) {
        job.fragments += static_cast<std::uint32_t>(span.count);
        job.lost -= static_cast<std::uint32_t>(lost[0] + lost[2]);
      }
    }
    span_count = 0;
  }

  inline void write_pair(MapCell* pair, Int8 heights, Int8 key, Long4 inside, Long4 oldest, const Job& job,
                         Long4& lost) {
    constexpr Int8 k_depths = {0, -1, 0, -1, 0, -1, 0, -1};
    constexpr Long4 k_back = {0, -1, 0, -1};
    if constexpr (k_back_only) inside &= k_back;
    const auto fresh = bits_as<Long4>((heights & k_depths) ^ key);
    const auto old = load<Long4>(pair);
    const Long4 wins = (fresh > old) & inside;
    store(pair, wins ? fresh : old);
    if constexpr (!k_back_only) {
      const Long4 taken = (old > oldest) & inside;  // by a fragment of the present generation
      const Long4 replaced = taken & wins;
      lost += taken ^ replaced;
      if (any_front(replaced)) {
        if (replaced[0] != 0) hide(facet_of(old[0]), job.layer);
        if (replaced[2] != 0) hide(facet_of(old[2]), job.layer);
      }
    }
  }

  inline void hide(std::uint32_t facet, Layer layer) {
    ++sums->hidden[layer];
    sums->clusters[2 * clusters[facet] + layer].hidden_weight += static_cast<double>(weights[facet]);
  }

  inline void finish_jobs(std::size_t count) {
    flush();
    if constexpr (!k_back_only) {
      for (std::size_t i = 0; i < count; ++i) {
        const Job& job = jobs[i];
        if (job.fragments == 0) continue;
        sums->fragments[job.layer] += job.fragments;
        sums->hidden[job.layer] += job.lost;
        const double weight = static_cast<double>(weights[job.facet]);
        if (weight <= 0.0) continue;
        ClusterSums& cluster = sums->clusters[2 * clusters[job.facet] + job.layer];
        cluster.fragments += job.fragments;
        cluster.weight += weight * static_cast<double>(job.fragments);
        cluster.hidden_weight += weight * static_cast<double>(job.lost);
      }
    }
  }
};

void rasterize(const RasterInput& input, const RasterTarget& target, RasterSums& sums) {
  Survivors survivors;
  Filler<false> filler(target, input, &sums);
  for (std::size_t begin = 0; begin < input.facet_count; begin += k_cull_batch) {
    cull(input, begin, begin + k_cull_batch < input.facet_count ? begin + k_cull_batch : input.facet_count,
         survivors);
    for (int tall = 0; tall < 2; ++tall) {
      const std::uint32_t* facets = survivors.facets[tall];
      const std::size_t count = survivors.count[tall];
      std::size_t job = 0;
      for (std::size_t i = 0; i < count; i += 4, job += 4) {
        if (job == k_job_batch) {
          filler.finish_jobs(job);
          job = 0;
        }
        const std::size_t lanes = count - i < 4 ? count - i : 4;
        Setup4 setup;
        set_up(
            [&](std::size_t lane, int k) {
              return input.vertices +
                     input.facets[facets[lane < lanes ? i + lane : i]][static_cast<std::size_t>(k)];
            },
            target.size, setup);
        filler.start_jobs(setup, facets + i, lanes, job, nullptr);
        if (tall == 0) {
          filler.add_short(setup, lanes, job);
        } else {
          for (std::size_t lane = 0; lane < lanes; ++lane)
            filler.add_tall(setup, static_cast<int>(lane), job + lane);
        }
      }
      filler.finish_jobs(count == 0 ? 0 : job - 4 + (count - 1) % 4 + 1);
    }
  }
}

void rasterize_back(const MapVertex* corners, const std::uint32_t* facets, std::size_t count, Layer layer,
                    const RasterTarget& target) {
  Filler<true> filler(target);
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
