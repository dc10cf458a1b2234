// SPDX-License-Identifier: MIT
// Smooth noise in space, the same on every machine.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace bake {

/// A whole number mixed so that neighbours have nothing in common (the finaliser of MurmurHash3).
constexpr std::uint32_t mixed(std::uint32_t h) {
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return h ^ (h >> 16);
}

/// From -1 to 1 at a point with whole coordinates.
inline float lattice_noise(int x, int y, int z) {
  const std::uint32_t h =
      mixed(static_cast<std::uint32_t>(x) + mixed(static_cast<std::uint32_t>(y) + mixed(static_cast<std::uint32_t>(z))));
  return static_cast<float>(h >> 8) * 0x1p-23f - 1;
}

/// Value noise: from -1 to 1, with continuous slope, bumps about one unit wide.
inline float noise(const Eigen::Vector3f& p) {
  const Eigen::Vector3f low = p.array().floor();
  const Eigen::Vector3f s = p - low;
  const Eigen::Vector3f w = s.array() * s.array() * (3 - 2 * s.array());
  const int x = static_cast<int>(low.x()), y = static_cast<int>(low.y()), z = static_cast<int>(low.z());
  const auto row = [&](int j, int k) { return std::lerp(lattice_noise(x, y + j, z + k), lattice_noise(x + 1, y + j, z + k), w.x()); };
  return std::lerp(std::lerp(row(0, 0), row(1, 0), w.y()), std::lerp(row(0, 1), row(1, 1), w.y()), w.z());
}

/// Octaves of noise, each half as large and half as high as the one before; mostly within -1 to 1.
inline float fractal_noise(Eigen::Vector3f p, int octaves) {
  float sum = 0, height = 0.6f;
  for (int i = 0; i < octaves; ++i) {
    sum += height * noise(p);
    p = 2.03f * p + Eigen::Vector3f(17.1f, 5.7f, 9.3f);
    height *= 0.5f;
  }
  return sum;
}

}  // namespace bake
