// SPDX-License-Identifier: MIT
// Exponential, logarithm, powers, sine, cosine and angle out of sums, products, quotients and square roots alone, whose results IEEE 754
// fixes to the last bit. glibc takes other variants of its own on processors with fused multiply-add, which end in other bits; so whatever
// a scene is built from takes these. Errors are given for double precision: relative but for sine and cosine, in units of 2^-53.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace bake::elementary {

namespace detail {

/// 1 / n! for n < N.
template <int N>
inline constexpr std::array<double, N> k_inverse_factorials = [] {
  std::array<double, N> list{};
  double factorial = 1;  // exact up to 18!
  for (int n = 0; n < N; ++n) list[n] = 1 / (factorial *= n > 0 ? n : 1);
  return list;
}();

/// ln 2 and pi / 2 as sums, of which the first parts have so few bits that small whole multiples of them are exact.
inline constexpr double k_ln2_head = 0x1.62e42fee00000p-1, k_ln2_tail = 0x1.a39ef35793c76p-33;
inline constexpr double k_quarter_head = 0x1.921fb54400000p+0, k_quarter_middle = 0x1.0b4611a600000p-34,
                        k_quarter_tail = 0x1.3198a2e037073p-69;

/// Sine and cosine of |r| <= pi / 4 by their series.
inline double sine_near_zero(double r) {
  double sum = 0;
  for (int n = 17; n > 1; n -= 2) sum = -r * r * (k_inverse_factorials<19>[n] + sum);
  return r + r * sum;
}
inline double cosine_near_zero(double r) {
  double sum = 0;
  for (int n = 18; n > 0; n -= 2) sum = -r * r * (k_inverse_factorials<19>[n] + sum);
  return 1 + sum;
}

struct Quarter {
  int count;    ///< of right angles, modulo 4
  double rest;  ///< within half a right angle
};
inline Quarter quarter(double angle_rad) {
  const double count = std::nearbyint(angle_rad * (2 / std::numbers::pi));
  const double rest = ((angle_rad - count * k_quarter_head) - count * k_quarter_middle) - count * k_quarter_tail;
  return {static_cast<int>(count - 4 * std::floor(count / 4)), rest};
}

}  // namespace detail

/// e^x, to 2 units; 0 and infinity beyond the range of double.
inline double exp(double x) {
  if (!(x > -746)) return x == x ? 0 : x;
  if (x > 710) return std::numeric_limits<double>::infinity();
  const double k = std::nearbyint(x / std::numbers::ln2);
  const double r = (x - k * detail::k_ln2_head) - k * detail::k_ln2_tail;
  double sum = 0;
  for (int n = 14; n > 0; --n) sum = r * (detail::k_inverse_factorials<15>[n] + sum);
  return std::ldexp(1 + sum, static_cast<int>(k));
}

/// Natural logarithm of x > 0, to 3 units.
inline double log(double x) {
  int k = 0;
  double m = std::frexp(x, &k);  // from 1/2 to 1
  if (m < std::numbers::sqrt2 / 2) m *= 2, --k;
  const double s = (m - 1) / (m + 1), z = s * s;  // ln m = 2 artanh s, |s| < 0.172
  double sum = 0;
  for (int n = 23; n > 1; n -= 2) sum = z * (1. / n + sum);
  return k * detail::k_ln2_head + (2 * s + (2 * s * sum + k * detail::k_ln2_tail));
}

/// x^y for x >= 0 and y > 0, to 3 + 3 |y ln x| units.
inline double power(double x, double y) { return x > 0 ? exp(y * log(x)) : 0; }

/// Sine and cosine, to 2 units of 1 up to 10^5 rad; beyond the error grows in proportion to the angle.
inline double sine(double angle_rad) {
  const auto [count, rest] = detail::quarter(angle_rad);
  const double value = count % 2 == 0 ? detail::sine_near_zero(rest) : detail::cosine_near_zero(rest);
  return count < 2 ? value : -value;
}
inline double cosine(double angle_rad) {
  const auto [count, rest] = detail::quarter(angle_rad);
  const double value = count % 2 == 0 ? detail::cosine_near_zero(rest) : detail::sine_near_zero(rest);
  return count == 0 || count == 3 ? value : -value;
}

/// The angle [rad] from the x axis to (x, y), for x, y >= 0 that are not both 0, to 8 units.
inline double angle(double y, double x) {
  double t = y / (x + std::sqrt(x * x + y * y));  // tangent of half of it, at most 1
  for (int halving = 0; halving < 2; ++halving) t = t / (1 + std::sqrt(1 + t * t));
  double sum = 0;  // |t| < 0.2
  for (int n = 25; n > 1; n -= 2) sum = -t * t * (1. / n + sum);
  return 8 * (t + t * sum);
}

}  // namespace bake::elementary
