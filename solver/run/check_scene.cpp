// SPDX-License-Identifier: MIT
#include "solver/run/check_scene.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "solver/boundary/fill.h"
#include "solver/engine/physics.h"
#include "solver/grid/grid.h"
#include "solver/io/provenance.h"
#include "solver/run/fill_scene.h"
#include "solver/run/frame_times.h"
#include "solver/run/skins.h"
#include "solver/scene/scene.h"

namespace bake {

namespace {

constexpr double k_usual_speed = 1e7;  ///< particle-steps a second of an ordinary machine, for the estimate of time

/// At least: where a particle of a body begins, its columns with their room for sorting, and its place in the new order.
template <class Real>
double bytes_of_a_particle(const Scene& scene) {
  return sizeof(Point) + 17. / 16 * sizeof(Real) * make_physics<Real>(scene)->column_count + 3 * sizeof(std::uint32_t);
}

/// What the machine has, or what the process may have of it (`ulimit -v`) [bytes].
double memory_there() {
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  const auto all = static_cast<double>(memory_bytes());
  return limit.rlim_cur == RLIM_INFINITY ? all : std::min(all, static_cast<double>(limit.rlim_cur));
}

/// Gathers what a run takes and complains as soon as it is more than there is.
class Memory {
 public:
  explicit Memory(const Scene& scene) : scene_(scene) {}

  /// `what` the scene's `key` asks for takes so many bytes.
  void take(const std::string& key, const std::string& what, double bytes) {
    taken_ += bytes;
    if (taken_ > there_)
      throw InputError(fmt::format("{}: found {} (at least {}), allowed: up to {} of memory (a coarser --quality or grid.dx_m)",
                                   scene_.at(key), what, words(bytes), words(there_)));
  }

 private:
  static std::string words(double bytes) {
    return bytes < 1e12 ? fmt::format("{:.3g} GB", bytes / 1e9) : fmt::format("{:.3g} TB", bytes / 1e12);
  }
  const Scene& scene_;
  const double there_ = memory_there();
  double taken_ = 0;
};

}  // namespace

double bytes_per_particle(const Scene& scene) {
  return scene.run.precision == Precision::single_precision ? bytes_of_a_particle<float>(scene) : bytes_of_a_particle<double>(scene);
}

void check_size(const Scene& scene) {
  const double per_particle = bytes_per_particle(scene);
  Memory memory(scene);
  const GridGeometry geometry(scene.domain.min_m, scene.domain.max_m, scene.dx());
  const double blocks = double(geometry.blocks(0)) * geometry.blocks(1) * geometry.blocks(2);
  // ActiveBlocks::slot_of, and its copy while particles are sorted
  memory.take("domain", fmt::format("about {:.2g} blocks of 64 nodes", blocks), blocks * 2 * sizeof(std::int32_t));
  for (const ShapeToFill& s : shapes_to_fill(scene)) {
    const FillingSize size = estimate_filling(*s.shape, s.spacing);
    const double poisson_cells = s.filling == Filling::poisson ? size.places * std::pow(std::sqrt(3) / k_poisson_radius, 3) : 0;
    memory.take(s.name, fmt::format("about {:.2g} particles, which take about {:.2g} s a step", size.points, size.points / k_usual_speed),
                size.points * per_particle + poisson_cells * sizeof(std::int32_t));
    if (size.places > k_most_places)
      throw InputError(
          fmt::format("{}: found bounds with room for about {:.2g} particles, allowed: up to {:.2g} (parts that lie far apart as "
                      "bodies of their own)",
                      scene.at(s.name), size.places, k_most_places));
  }
}

void check_scene(const Scene& scene) {
  const FrameTimes times(scene);  // throws if they cannot be counted
  check_size(scene);
  check_filling(scene);
  make_skins(scene);  // throws if one cannot be made
}

}  // namespace bake
