// SPDX-License-Identifier: MIT
// A ball as bake-render model would have left it: three moments in which it grows, warm at one side, wet at another, brown outside.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "solver/io/frames.h"
#include "solver/io/mesh_file.h"
#include "tests/unit/io/files.h"

namespace bake::report {

/// The fields at a place of a ball of radius `r`.
struct AtPlace {
  double temperature_C, saturation, porosity, browning;
  AtPlace(double x, double y, double z, double r)
      : temperature_C(60 + 40 * x / r),
        saturation(0.5 + 0.4 * y / r),
        porosity(0.3 + 0.2 * z / r),
        browning(std::pow(std::min(1.0, std::hypot(x, y, z) / r), 8) * 0.8) {}
};

inline double radius_at(int frame) { return 0.2 + 0.05 * frame; }

/// A sphere of triangles between circles of latitude, closed at its poles.
inline Mesh sphere(double r, double time_s, double centre_x = 0) {
  constexpr int k_circles = 24, k_sides = 48;
  Mesh mesh;
  mesh.time_s = time_s;
  for (const char* name : {"temperature", "saturation", "porosity", "browning"}) mesh.fields.push_back({name, "1", 1, {}});
  const auto add = [&](double polar, double round) {
    const double x = r * std::sin(polar) * std::cos(round), y = r * std::sin(polar) * std::sin(round), z = r * std::cos(polar);
    mesh.points.insert(mesh.points.end(), {x + centre_x, y, z});
    const AtPlace at(x, y, z, r);
    mesh.fields[0].values.push_back(at.temperature_C);
    mesh.fields[1].values.push_back(at.saturation);
    mesh.fields[2].values.push_back(at.porosity);
    mesh.fields[3].values.push_back(at.browning);
  };
  add(0, 0);
  for (int c = 1; c < k_circles; ++c)
    for (int s = 0; s < k_sides; ++s) add(std::numbers::pi * c / k_circles, 2 * std::numbers::pi * s / k_sides);
  add(std::numbers::pi, 0);
  const auto vertex = [&](int c, int s) { return std::int64_t{1} + (c - 1) * k_sides + s % k_sides; };
  const auto last = static_cast<std::int64_t>(mesh.vertex_count()) - 1;
  for (int s = 0; s < k_sides; ++s) {
    mesh.cells.insert(mesh.cells.end(), {0, vertex(1, s), vertex(1, s + 1)});
    for (int c = 1; c + 1 < k_circles; ++c)
      mesh.cells.insert(mesh.cells.end(),
                        {vertex(c, s), vertex(c + 1, s), vertex(c + 1, s + 1), vertex(c, s), vertex(c + 1, s + 1), vertex(c, s + 1)});
    mesh.cells.insert(mesh.cells.end(), {last, vertex(k_circles - 1, s + 1), vertex(k_circles - 1, s)});
  }
  return mesh;
}

/// Writes the particles of the ball; every `gone`-th is not there.
inline void write_particles(const std::filesystem::path& path, double r, double time_s, std::int64_t gone) {
  constexpr int k_half = 9;
  FrameData data;
  std::vector<float> positions;
  std::vector<std::int64_t> ids;
  std::vector<float> columns[5];
  std::int64_t id = 0;
  for (int k = -k_half; k <= k_half; ++k)
    for (int j = -k_half; j <= k_half; ++j)
      for (int i = -k_half; i <= k_half; ++i) {
        if (i * i + j * j + k * k > k_half * k_half || ++id % gone == 0) continue;
        const double h = r / k_half, x = h * i, y = h * j, z = h * k;
        positions.insert(positions.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
        const AtPlace at(x, y, z, r);
        ids.push_back(id);
        const double values[] = {h * h * h, at.temperature_C, at.saturation, at.porosity, at.browning};
        for (int c = 0; c < 5; ++c) columns[c].push_back(static_cast<float>(values[c]));
      }
  data.positions = std::move(positions);
  data.columns.push_back({"id", "", ids, 1});
  const char* names[] = {"volume", "temperature", "saturation", "porosity", "browning"};
  for (int c = 0; c < 5; ++c) data.columns.push_back({names[c], "1", columns[c], 1});
  write_frame(path, time_s, data);
}

inline void write_ball(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (int frame = 0; frame < 3; ++frame) {
    const std::string name = frame_name(10 * frame);
    write_mesh(folder / ("surface_" + name), sphere(radius_at(frame), frame));
    write_particles(folder / ("particles_" + name), radius_at(frame), frame, frame == 1 ? 5 : 1'000'000);
  }
  put(folder / "look.json", R"({"skin": [[0, "edd9ad"], [1, "2e170d"]], "crumb": [[0, "f5e8c7"], [1, "703817"]]})");
}

}  // namespace bake::report
