// Vectors of the compiler, and what it lacks of them.
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

inline Double4 to_double(Int4 values) { return __builtin_convertvector(values, Double4); }
inline Long4 widen(Int4 mask) { return __builtin_convertvector(mask, Long4); }

/// Bit k tells of lane k: of four lanes, each all ones or none, and of eight lanes whether it is negative.
inline std::uint32_t lanes_set(Int4 mask) {
#if defined(MOLDLIGHT_SCAN_AVX2)
  return static_cast<std::uint32_t>(__builtin_ia32_movmskps(bits_as<Float4>(mask)));
#else
  constexpr Int4 k_bits = {1, 2, 4, 8};
  const Int4 bits = mask & k_bits;
  return static_cast<std::uint32_t>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

inline std::uint32_t lanes_set(Int8 mask) {
#if defined(MOLDLIGHT_SCAN_AVX2)
  return static_cast<std::uint32_t>(__builtin_ia32_movmskps256(bits_as<Float8>(mask)));
#else
  constexpr Int8 k_bits = {1, 2, 4, 8, 16, 32, 64, 128};
  const Int8 bits = (mask < 0) & k_bits;
  const Int4 half = load<Int4>(&bits) | load<Int4>(reinterpret_cast<const char*>(&bits) + sizeof(Int4));
  const auto pair = bits_as<Long2>(half);
  const auto folded = static_cast<std::uint64_t>(pair[0] | pair[1]);
  return static_cast<std::uint32_t>(folded | (folded >> 32)) & 0xFFU;
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

/// Of a number of at most four bits.
inline std::uint32_t bit_count(std::uint32_t four_bits) {
#if defined(MOLDLIGHT_SCAN_AVX2)
  return static_cast<std::uint32_t>(__builtin_popcount(four_bits));
#else
  constexpr std::uint64_t k_counts = 0x4332322132212110U;  // four bits each
  return static_cast<std::uint32_t>(k_counts >> (4 * four_bits)) & 0xFU;
#endif
}

/// Stores the lanes whose bits are set one behind the other; what lies in the three places behind them is
/// lost.
inline void store_set(std::int32_t* to, Int4 values, std::uint32_t four_bits) {
#if defined(MOLDLIGHT_SCAN_AVX2)
  alignas(16) static constexpr std::int32_t k_places[16][4] = {
      {0}, {0},    {1},    {0, 1},    {2},    {0, 2},    {1, 2},    {0, 1, 2},
      {3}, {0, 3}, {1, 3}, {0, 1, 3}, {2, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1, 2, 3}};
  store(to, __builtin_ia32_vpermilvarps(bits_as<Float4>(values), load<Int4>(k_places[four_bits])));
#else
  for (std::uint32_t lane = 0, at = 0; lane < 4; at += four_bits >> lane & 1U, ++lane)
    to[at] = values[static_cast<int>(lane)];
#endif
}

/// The lanes whose bits are set.
inline Long4 lane_mask(std::uint32_t four_bits) {
  constexpr Long4 k_bits = {1, 2, 4, 8};
  return (k_bits & static_cast<std::int64_t>(four_bits)) != 0;
}
