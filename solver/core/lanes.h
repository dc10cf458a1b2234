// SPDX-License-Identifier: MIT
// Lanes: a pack of W numbers, one register wide, on which all particle and node physics is written.
//
// `Lanes<Real>` is a GCC/clang vector: + - * / and comparisons work lane by lane, and `mask ? a : b` selects. The
// width follows the target: vectors wider than the machine's registers would be lowered to scalars where they are
// shuffled (measured: 18 times slower).
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

#define BAKE_INLINE inline __attribute__((always_inline))

namespace bake {

#if defined(__AVX512F__)
inline constexpr int k_register_bytes = 64;
#elif defined(__AVX__)
inline constexpr int k_register_bytes = 32;
#else
inline constexpr int k_register_bytes = 16;
#endif

template <class Real>
struct LaneTraits;
template <>
struct LaneTraits<float> {
  typedef float Vector __attribute__((vector_size(k_register_bytes)));
  typedef std::int32_t Mask __attribute__((vector_size(k_register_bytes)));
};
template <>
struct LaneTraits<double> {
  typedef double Vector __attribute__((vector_size(k_register_bytes)));
  typedef std::int64_t Mask __attribute__((vector_size(k_register_bytes)));
};

template <class Real>
using Lanes = typename LaneTraits<Real>::Vector;
/// Lanes of integers as wide as Real; comparisons give -1 (true) or 0 (false).
template <class Real>
using LaneMask = typename LaneTraits<Real>::Mask;
/// Number of lanes.
template <class Real>
inline constexpr int k_width = k_register_bytes / static_cast<int>(sizeof(Real));

/// The same number in all lanes.
template <class Real>
BAKE_INLINE Lanes<Real> lanes(std::type_identity_t<Real> x) {
  return x - Lanes<Real>{};
}

template <class V>
BAKE_INLINE V max(V a, V b) {
  return a > b ? a : b;
}
template <class V>
BAKE_INLINE V min(V a, V b) {
  return a < b ? a : b;
}
template <class V>
BAKE_INLINE V abs(V a) {
  return max(a, -a);
}
template <class V>
BAKE_INLINE V clamp(V a, V low, V high) {
  return min(max(a, low), high);
}

template <class V>
BAKE_INLINE V sqrt(V a) {
  V result;
  for (unsigned l = 0; l < sizeof(a) / sizeof(a[0]); ++l) result[l] = std::sqrt(a[l]);  // one instruction
  return result;
}

// Exact to a few units in the last place. Not inlined, because they are long.
Lanes<float> exp(Lanes<float> a);
Lanes<double> exp(Lanes<double> a);
Lanes<float> log(Lanes<float> a);
Lanes<double> log(Lanes<double> a);
Lanes<float> expm1(Lanes<float> a);
Lanes<double> expm1(Lanes<double> a);
Lanes<float> log1p(Lanes<float> a);
Lanes<double> log1p(Lanes<double> a);
Lanes<float> atan(Lanes<float> a);
Lanes<double> atan(Lanes<double> a);

/// Is any lane true?
template <class Mask>
BAKE_INLINE bool any(Mask mask) {
  // the compiler's own functions, not the intrinsics: the header of those takes half a second to compile
  [[maybe_unused]] constexpr bool narrow = sizeof(mask[0]) == 4;
#if defined(__AVX512DQ__)
  typedef long long Whole __attribute__((vector_size(64)));
  if constexpr (narrow) return __builtin_ia32_cvtd2mask512(mask) != 0;
  return __builtin_ia32_cvtq2mask512(reinterpret_cast<Whole>(mask)) != 0;
#elif defined(__SSE2__) && !defined(__AVX512F__)
  using Singles = Lanes<float>;
  using Doubles = Lanes<double>;
#if defined(__AVX__)
  if constexpr (narrow) return __builtin_ia32_movmskps256(reinterpret_cast<Singles>(mask)) != 0;
  return __builtin_ia32_movmskpd256(reinterpret_cast<Doubles>(mask)) != 0;
#else
  if constexpr (narrow) return __builtin_ia32_movmskps(reinterpret_cast<Singles>(mask)) != 0;
  return __builtin_ia32_movmskpd(reinterpret_cast<Doubles>(mask)) != 0;
#endif
#else
  auto found = mask[0];
  for (unsigned l = 1; l < sizeof(mask) / sizeof(mask[0]); ++l) found |= mask[l];
  return found != 0;
#endif
}

template <class V>
BAKE_INLINE auto largest_lane(V a) {
  auto result = a[0];
  for (unsigned l = 1; l < sizeof(a) / sizeof(a[0]); ++l) result = a[l] > result ? a[l] : result;
  return result;
}
template <class V>
BAKE_INLINE auto smallest_lane(V a) {
  return -largest_lane(-a);
}
/// The sum of the lanes in double. It is summed by halves, which takes a few instructions; adding one lane after the other would wait for
/// each sum.
template <class V>
BAKE_INLINE double sum_lanes(V a) {
  constexpr int n = sizeof(a) / sizeof(a[0]);
  double part[n];
  for (int l = 0; l < n; ++l) part[l] = static_cast<double>(a[l]);
#pragma GCC unroll 4
  for (int half = n / 2; half > 0; half /= 2)
    for (int l = 0; l < half; ++l) part[l] += part[l + half];
  return part[0];
}

namespace detail {
// Lane l of a pair (a, b) of which a keeps the lanes without bit S and takes b's partner for the others.
template <int S, class V, int... L>
BAKE_INLINE V keep_low(V a, V b, std::integer_sequence<int, L...>) {
  constexpr int W = sizeof...(L);
  return __builtin_shufflevector(a, b, ((L & S) == 0 ? L : W + L - S)...);
}
template <int S, class V, int... L>
BAKE_INLINE V keep_high(V a, V b, std::integer_sequence<int, L...>) {
  constexpr int W = sizeof...(L);
  return __builtin_shufflevector(a, b, ((L & S) == 0 ? L + S : W + L)...);
}
template <int S, class V>
BAKE_INLINE void transpose_stage(V* rows) {
  constexpr int W = sizeof(V) / sizeof((*rows)[0]);
  if constexpr (S < W) {
    using Index = std::make_integer_sequence<int, W>;
#pragma GCC unroll 16
    for (int i = 0; i < W; ++i)
      if ((i & S) == 0) {
        const V a = rows[i], b = rows[i + S];
        rows[i] = keep_low<S>(a, b, Index{});
        rows[i + S] = keep_high<S>(a, b, Index{});
      }
    transpose_stage<2 * S>(rows);
  }
}
}  // namespace detail

/// Transposes a W x W matrix held in W registers: a butterfly of log2 W stages.
template <class V>
BAKE_INLINE void transpose(V* rows) {
  detail::transpose_stage<1>(rows);
}

}  // namespace bake
