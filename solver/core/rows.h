// SPDX-License-Identifier: MIT
// Rows: the numbers of one node or particle side by side, and the transposition of rows into lanes.
#pragma once

#include "solver/core/lanes.h"

namespace bake {

/// R numbers in registers: one register if R numbers fit, else several.
template <class Real, int R>
struct Row {
  static constexpr int k_chunk = R < k_width<Real> ? R : k_width<Real>;
  static constexpr int k_chunks = R / k_chunk;
  typedef Real Chunk __attribute__((vector_size(k_chunk * sizeof(Real)), may_alias));
  Chunk at[k_chunks];

  BAKE_INLINE static Row load(const Real* p) {
    Row r;
#pragma GCC unroll 8
    for (int c = 0; c < k_chunks; ++c) r.at[c] = reinterpret_cast<const Chunk*>(p)[c];
    return r;
  }
  BAKE_INLINE void store(Real* p) const {
#pragma GCC unroll 8
    for (int c = 0; c < k_chunks; ++c) reinterpret_cast<Chunk*>(p)[c] = at[c];
  }
  BAKE_INLINE static Row zero() {
    Row r;
#pragma GCC unroll 8
    for (int c = 0; c < k_chunks; ++c) r.at[c] = Chunk{};
    return r;
  }
  /// *this += a * s
  BAKE_INLINE void add(const Row& a, Real s) {
#pragma GCC unroll 8
    for (int c = 0; c < k_chunks; ++c) at[c] += a.at[c] * s;
  }
  BAKE_INLINE Row operator*(Real s) const {
    Row r;
#pragma GCC unroll 8
    for (int c = 0; c < k_chunks; ++c) r.at[c] = at[c] * s;
    return r;
  }
  /// *this + n a for a small whole number n, computed by sums, which leave the multipliers free. `a` may be a shorter row.
  template <int S>
  BAKE_INLINE Row plus(int n, const Row<Real, S>& a) const {
    static_assert(Row<Real, S>::k_chunk == k_chunk && S <= R);
    Row r = *this;
#pragma GCC unroll 8
    for (int c = 0; c < a.k_chunks; ++c)
      r.at[c] = n == 0 ? r.at[c] : n == -1 ? r.at[c] - a.at[c] : n == 1 ? r.at[c] + a.at[c] : r.at[c] + Real(n) * a.at[c];
    return r;
  }
};

/// Two rows side by side in one register or in two.
template <class Real, int R>
using RowPair = Row<Real, 2 * R>;

/// Prefetches rows that will be read and written soon.
template <class Real>
BAKE_INLINE void prefetch_rows(const Real* first, std::size_t numbers) {
  for (std::size_t i = 0; i < numbers; i += 64 / sizeof(Real)) __builtin_prefetch(first + i, 1, 2);
}

namespace detail {
template <class Real, int R, int... I>
BAKE_INLINE RowPair<Real, R> halves(Real low, Real high, std::integer_sequence<int, I...>) {
  typedef typename RowPair<Real, R>::Chunk Chunk;
  const Chunk a = low - Chunk{}, b = high - Chunk{};
  return {{__builtin_shufflevector(a, b, (I < R ? I : 2 * R + I)...)}};
}
template <class Real, int R, int first, int... I>
BAKE_INLINE Row<Real, R> half(const RowPair<Real, R>& pair, std::integer_sequence<int, I...>) {
  if constexpr (RowPair<Real, R>::k_chunks == 1) {
    return {{__builtin_shufflevector(pair.at[0], pair.at[0], (first + I)...)}};
  } else {
    Row<Real, R> r;
#pragma GCC unroll 8
    for (int c = 0; c < r.k_chunks; ++c) r.at[c] = pair.at[first / r.k_chunk + c];
    return r;
  }
}
template <class V, class Chunk, int... L>
BAKE_INLINE V widened(Chunk a, std::integer_sequence<int, L...>) {
  constexpr int R = sizeof(Chunk) / sizeof(a[0]);
  return __builtin_shufflevector(a, a, (L < R ? L : -1)...);
}
template <class Chunk, class V, int... L>
BAKE_INLINE Chunk narrowed(V a, std::integer_sequence<int, L...>) {
  return __builtin_shufflevector(a, a, L...);
}
}  // namespace detail

/// A pair in one register: all numbers of its lower row are `low`, all of its upper row `high`.
template <int R, class Real>
BAKE_INLINE RowPair<Real, R> halves(Real low, Real high) {
  return detail::halves<Real, R>(low, high, std::make_integer_sequence<int, 2 * R>{});
}
template <class Real, int R>
BAKE_INLINE RowPair<Real, R> joined(const Row<Real, R>& low, const Row<Real, R>& high) {
  RowPair<Real, R> both;
#pragma GCC unroll 8
  for (int c = 0; c < low.k_chunks; ++c) both.at[c] = low.at[c], both.at[low.k_chunks + c] = high.at[c];
  return both;
}
template <int R, class Real>
BAKE_INLINE Row<Real, R> lower(const RowPair<Real, R>& pair) {
  return detail::half<Real, R, 0>(pair, std::make_integer_sequence<int, R>{});
}
template <int R, class Real>
BAKE_INLINE Row<Real, R> upper(const RowPair<Real, R>& pair) {
  return detail::half<Real, R, R>(pair, std::make_integer_sequence<int, R>{});
}

/// From W rows of R numbers (aligned, one after another) to R packs of lanes. R: a power of two.
template <int R, class Real>
BAKE_INLINE void rows_to_lanes(const Real* rows, Lanes<Real>* columns) {
  constexpr int W = k_width<Real>, width = Row<Real, R>::k_chunk;
  using Chunk = typename Row<Real, R>::Chunk;
  for (int c = 0; c < R; c += width) {
    Lanes<Real> square[W];
    for (int l = 0; l < W; ++l) {
      const Chunk part = *reinterpret_cast<const Chunk*>(rows + l * R + c);
      if constexpr (width == W)
        square[l] = part;
      else
        square[l] = detail::widened<Lanes<Real>>(part, std::make_integer_sequence<int, W>{});
    }
    transpose(square);
    for (int l = 0; l < width; ++l) columns[c + l] = square[l];
  }
}

/// The reverse.
template <int R, class Real>
BAKE_INLINE void lanes_to_rows(const Lanes<Real>* columns, Real* rows, int stride = R) {
  constexpr int W = k_width<Real>, width = Row<Real, R>::k_chunk;
  using Chunk = typename Row<Real, R>::Chunk;
  for (int c = 0; c < R; c += width) {
    Lanes<Real> square[W];
    for (int l = 0; l < W; ++l) square[l] = columns[c + l % width];  // numbers beyond the row are not used
    transpose(square);
    for (int l = 0; l < W; ++l) {
      Chunk& part = *reinterpret_cast<Chunk*>(rows + l * stride + c);
      if constexpr (width == W)
        part = square[l];
      else
        part = detail::narrowed<Chunk>(square[l], std::make_integer_sequence<int, width>{});
    }
  }
}

}  // namespace bake
