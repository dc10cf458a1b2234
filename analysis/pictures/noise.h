// SPDX-License-Identifier: MIT
// Smooth noise in space, and its slope.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace bake {

/// Mixes a whole number so that the results of neighbours are unrelated (the finaliser of MurmurHash3).
constexpr std::uint32_t mixed(std::uint32_t h) {
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return h ^ (h >> 16);
}

/// From -1 to 1 at a point with whole coordinates.
inline float lattice_noise(int x, int y, int z) {
  const std::uint32_t h = mixed(static_cast<std::uint32_t>(x) * 0x8da6b343u ^ static_cast<std::uint32_t>(y) * 0xd8163841u ^
                                static_cast<std::uint32_t>(z) * 0xcb1ab31fu);
  return static_cast<float>(h >> 8) * 0x1p-23f - 1;
}

struct Noise {
  float value;
  Eigen::Vector3f slope;
};

/// Value noise: from -1 to 1, with continuous slope, bumps about one unit wide.
inline Noise noise(const Eigen::Vector3f& p) {
  const Eigen::Array3f low = p.array().floor(), s = p.array() - low;
  const Eigen::Array3f w = s * s * (3 - 2 * s), dw = 6 * s * (1 - s);
  const int x = static_cast<int>(low.x()), y = static_cast<int>(low.y()), z = static_cast<int>(low.z());
  float corner[2][2][2];
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) corner[k][j][i] = lattice_noise(x + i, y + j, z + k);
  const auto mix = [](float a, float b, float t) { return a + t * (b - a); };
  const auto along_x = [&](int k, int j) { return mix(corner[k][j][0], corner[k][j][1], w.x()); };
  const auto step_x = [&](int k, int j) { return corner[k][j][1] - corner[k][j][0]; };
  const float low_z = mix(along_x(0, 0), along_x(0, 1), w.y()), high_z = mix(along_x(1, 0), along_x(1, 1), w.y());
  const Eigen::Vector3f slope(dw.x() * mix(mix(step_x(0, 0), step_x(0, 1), w.y()), mix(step_x(1, 0), step_x(1, 1), w.y()), w.z()),
                              dw.y() * mix(along_x(0, 1) - along_x(0, 0), along_x(1, 1) - along_x(1, 0), w.z()), dw.z() * (high_z - low_z));
  return {mix(low_z, high_z, w.z()), slope};
}

/// Octaves of noise, each half as large and half as high as the one before; mostly within -1 to 1.
inline Noise fractal_noise(const Eigen::Vector3f& p, int octaves) {
  Noise sum{0, Eigen::Vector3f::Zero()};
  Eigen::Vector3f q = p;
  float height = 0.6f, frequency = 1;
  constexpr float k_finer = 2.03f;  // not quite 2: lattices of octaves never coincide
  for (int i = 0; i < octaves; ++i) {
    const Noise octave = noise(q);
    sum.value += height * octave.value;
    sum.slope += height * frequency * octave.slope;
    q = k_finer * q + Eigen::Vector3f(17.1f, 5.7f, 9.3f);
    frequency *= k_finer;
    height *= 0.5f;
  }
  return sum;
}

}  // namespace bake
