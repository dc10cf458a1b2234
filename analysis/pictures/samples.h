// SPDX-License-Identifier: MIT
// The numbers that choose a path of light: by pixel and number of the path alone, so that paths can be taken in any order.
#pragma once

#include <cstdint>

#include "analysis/pictures/noise.h"

namespace bake {

/// PCG-XSH-RR (O'Neill 2014): 32 random bits a call.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ull + 0x2545f4914f6cdd1dull) {
    bits();
    bits();
  }
  /// From 0 to below 1.
  float uniform() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }

 private:
  std::uint32_t bits() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    const auto shifted = static_cast<std::uint32_t>(((state_ >> 18) ^ state_) >> 27);
    const auto turn = static_cast<std::uint32_t>(state_ >> 59);
    return (shifted >> turn) | (shifted << (-turn & 31));
  }
  std::uint64_t state_;
};

/// A point of the unit square.
struct Sample2 {
  float u, v;
};

constexpr std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// Flips each bit by chance, by a chance that depends on the lower bits only (Laine and Karras 2011, constants of Burley 2020): with the
/// bits reversed it exchanges halves of the unit interval, halves of each half and so on (Owen 1995).
constexpr std::uint32_t flipped_upwards(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  return x ^ x * 0x8d22f6e6u;
}

/// What the second coordinate of Sobol's sequence makes of an index, with its bits reversed: bit i of the result is the sum (mod 2) of
/// the bits j for which the binomial of j over i is odd, those with i a subset of j (Lucas).
constexpr std::uint32_t second_coordinate(std::uint32_t index) {
  index ^= (index >> 16) & 0x0000ffffu;
  index ^= (index >> 8) & 0x00ff00ffu;
  index ^= (index >> 4) & 0x0f0f0f0fu;
  index ^= (index >> 2) & 0x33333333u;
  return index ^ ((index >> 1) & 0x55555555u);
}

/// Point `index` of Sobol's first two coordinates, scrambled and taken in a scrambled order by `seed` (Burley 2020, "Practical hash-based
/// Owen scrambling"). Of any 2^k points that begin at a multiple of 2^k one lies in each box of 2^-i by 2^(i-k): as even as can be, and the
/// error for smooth integrands falls with the power 3/2 of their number. Other seeds give independent points.
constexpr Sample2 even_sample(std::uint32_t index, std::uint32_t seed) {
  const auto unit = [](std::uint32_t bits) { return static_cast<float>(reversed_bits(bits) >> 8) * 0x1p-24f; };
  const std::uint32_t i = reversed_bits(flipped_upwards(reversed_bits(index), seed));
  return {unit(flipped_upwards(i, mixed(seed + 1))), unit(flipped_upwards(second_coordinate(i), mixed(seed + 2)))};
}

/// What chooses path `path` of a pixel: even pairs of numbers for its first hits, random ones for all else.
class PathSamples {
 public:
  PathSamples(std::uint32_t pixel, std::uint32_t path)
      : pixel_(mixed(pixel + 1)), path_(path), random_(static_cast<std::uint64_t>(pixel) << 32 | path) {}

  Sample2 in_pixel() const { return even(0); }
  /// The choices at the hit after that many bounces.
  struct AtHit {
    Sample2 lamp, direction;
    float lobe;  ///< which part of the reflection
  };
  AtHit at_hit(int bounces) {
    if (bounces >= k_even_hits) return {uniform2(), uniform2(), uniform()};
    const auto first = static_cast<std::uint32_t>(3 * bounces + 1);
    return {even(first), even(first + 1), even(first + 2).u};
  }
  float uniform() { return random_.uniform(); }
  Sample2 uniform2() {
    const float u = uniform();
    return {u, uniform()};
  }

 private:
  static constexpr int k_even_hits = 2;  ///< at later ones evenness no longer makes less noise
  Sample2 even(std::uint32_t choice) const { return even_sample(path_, mixed(pixel_ + choice * 0x85ebca77u)); }

  std::uint32_t pixel_, path_;
  Random random_;
};

}  // namespace bake
