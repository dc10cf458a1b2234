// SPDX-License-Identifier: MIT
// Small runs as bake would have left them, for tests of what reads them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "solver/io/frames.h"
#include "tests/unit/io/files.h"

namespace bake {

/// Particles of a lattice within a ball.
struct Ball {
  std::vector<float> positions, volumes;
  std::vector<std::int64_t> ids;

  Ball(float radius, float spacing, float centre_z = 0) {
    const int n = static_cast<int>(radius / spacing) + 1;
    for (int k = -n; k <= n; ++k)
      for (int j = -n; j <= n; ++j)
        for (int i = -n; i <= n; ++i) {
          const float x = spacing * static_cast<float>(i), y = spacing * static_cast<float>(j), z = spacing * static_cast<float>(k);
          if (x * x + y * y + z * z > radius * radius) continue;
          positions.insert(positions.end(), {x, y, z + centre_z});
          volumes.push_back(spacing * spacing * spacing);
          ids.push_back(static_cast<std::int64_t>(ids.size()));
        }
  }
};

/// What a particle has at a time.
struct State {
  float temperature_C;
  float water_kg;
  std::int64_t material = 0;
};

/// Writes `frames` frames, one a second, of a ball whose particles are in the state that `state(position, time_s)` says.
inline void write_run(const std::filesystem::path& folder, const Ball& ball, int frames,
                      const std::function<State(const float* position, double time_s)>& state) {
  std::filesystem::create_directories(folder / "frames");
  std::vector<SeriesEntry> series;
  for (int frame = 0; frame < frames; ++frame) {
    std::vector<float> temperature, water;
    std::vector<std::int64_t> material;
    for (std::size_t i = 0; i < ball.ids.size(); ++i) {
      const State s = state(&ball.positions[3 * i], frame);
      temperature.push_back(s.temperature_C);
      water.push_back(s.water_kg);
      material.push_back(s.material);
    }
    write_frame(folder / "frames" / frame_name(frame), frame,
                {ball.positions,
                 {{"id", "", ball.ids, 1},
                  {"material", "1", material, 1},
                  {"temperature", "C", temperature, 1},
                  {"volume", "m^3", ball.volumes, 1},
                  {"water_mass", "kg", water, 1}}});
    series.push_back({"frames/" + frame_name(frame), static_cast<double>(frame)});
  }
  write_series(folder / "frames.hdf.series", series);
}

}  // namespace bake
