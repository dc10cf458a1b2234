// SPDX-License-Identifier: MIT
#include "experiments/fig14_return_map/stress_state.h"

#include <cmath>

#include "solver/effects/elasticity.h"
#include "solver/effects/particle_of_everything.h"
#include "solver/effects/plasticity.h"
#include "solver/engine/physics.h"
#include "solver/scene/scene.h"

namespace bake {

double pressure_of(const Stress& tau) { return -trace(tau) / 3; }

double effective_of(const Stress& tau) {
  Stress s = tau;
  for (int i = 0; i < 3; ++i) s.at[i] += pressure_of(tau);
  return std::sqrt(1.5 * norm_squared(s));
}

Stress uniaxial(double p, double q) { return {{-p + q * 2 / 3, -p - q / 3, -p - q / 3, 0, 0, 0}}; }

double published_cap(double n) {
  if (n == 0) return 0;
  const double ln = std::log(1 / n);
  return 9 / (4 * ln * ln * (3.5 * n + 1));
}

FlowStep::FlowStep(const Scene& scene, double porosity, double dt)
    : k_(scene, scene.materials[0]), elastic_(scene, scene.materials[0]), porosity_(porosity), dt_(dt) {
  temperature_ = scene.materials[0].initial_temperature_C;
  const auto theta = lanes<double>(temperature_);
  Lanes<double> tau_y, eta;
  Plasticity::curves<Lanes<double>>(theta, theta, k_, tau_y, eta);
  tau_y_ = tau_y[0];
  eta_ = eta[0];
}

Stress FlowStep::image(const Stress& trial) const {
  ParticleOfEverything<double> particle;
  const double p = pressure_of(trial);
  for (int i = 0; i < 6; ++i)  // epsilon = C^-1 : tau
    particle[field::epsilon][i] = lanes<double>((trial.at[i] + (i < 3 ? p : 0)) / (2 * k_.mu) - (i < 3 ? p / (3 * k_.bulk) : 0));
  particle[field::theta] = particle[field::theta_peak] = lanes<double>(temperature_);
  particle[field::V_0] = lanes<double>(1);
  particle[field::J_P] = lanes<double>((1 - k_.n_0) / (1 - porosity_));  // n = 1 - (1 - n_0)/J_P
  Step<double> step;
  step.dt = dt_;
  BooksOfEverything<double> books;
  Plasticity::gather(particle, 0, k_, step, books);
  Elasticity::stress(particle, elastic_);
  Stress image;
  for (int i = 0; i < 6; ++i) image.at[i] = particle[field::tau][i][0];
  return image;
}

}  // namespace bake
