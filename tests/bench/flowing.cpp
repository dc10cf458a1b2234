// SPDX-License-Identifier: MIT
#include "tests/bench/flowing.h"

#include "solver/core/symmetric.h"
#include "solver/effects/plasticity.h"
#include "solver/scene/scene.h"

namespace bake::bench {

double flowing_share(const Simulation& simulation, const Scene& scene) {
  using V = Lanes<double>;
  if (!scene.lists("plasticity")) return 0;
  const Snapshot now = simulation.snapshot();
  const auto &b_E = now["elastic_strain"], &J_P = now["plastic_volume_ratio"];
  const Plasticity::Constants<double> k(scene, scene.materials[0]);
  const double theta_0 = scene.materials[0].initial_temperature_C;
  const bool heats = scene.lists("heat");
  std::size_t flowing = 0;
  for (std::size_t i = 0; i < now.id.size(); ++i) {
    Symmetric<V> b;
    for (std::size_t c = 0; c < 6; ++c) b.at[c] = lanes<double>(b_E[6 * i + c]);
    Symmetric<V> e = half_log1p<double>(b);
    const V tr = trace(e), p = k.bulk * tr;
    for (int c = 0; c < 3; ++c) e.at[c] -= tr / 3;
    V tau_y, eta;
    const V theta = lanes<double>(heats ? now["temperature"][i] : theta_0),
            peak = lanes<double>(heats ? now["peak_temperature"][i] : theta_0);
    Plasticity::curves<V>(theta, peak, k, tau_y, eta);
    const V a = Plasticity::cap<V>(Plasticity::porosity<V>(lanes<double>(J_P[i]), k));
    flowing += (a * p * p + 6 * k.mu * k.mu * norm_squared(e))[0] > (1 + 1e-5) * (tau_y * tau_y)[0];
  }
  return static_cast<double>(flowing) / static_cast<double>(now.id.size());
}

}  // namespace bake::bench
