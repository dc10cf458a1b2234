// SPDX-License-Identifier: MIT
// The solver's own return mapping, one stress at a time.
#pragma once

#include "solver/core/symmetric.h"
#include "solver/effects/elasticity.h"
#include "solver/effects/plasticity.h"
#include "solver/scene/scene.h"

namespace bake {

using Stress = Symmetric<double>;  ///< Kirchhoff stress tau_E [Pa]

double pressure_of(const Stress& tau);   ///< p = -tr(tau)/3
double effective_of(const Stress& tau);  ///< q = sqrt(3/2) |tau + p I|
Stress uniaxial(double p, double q);     ///< a stress with these invariants, its axis along x

/// a(n) of Eq. 12 as printed; 0 at n = 0: what the solver's own is held against.
double published_cap(double n);

/// The flow of one material at one porosity in one time step.
class FlowStep {
 public:
  /// The first material of `scene`, at its start temperature. `porosity` n from 0 to 0.97, dt > 0 [s].
  FlowStep(const Scene& scene, double porosity, double dt);

  Stress image(const Stress& trial) const;  ///< what Plasticity::gather makes of a trial stress
  double bulk() const { return k_.bulk; }
  double mu() const { return k_.mu; }
  double tau_y() const { return tau_y_; }
  double eta_dt() const { return eta_ / dt_; }

 private:
  Plasticity::Constants<double> k_;
  Elasticity::Constants<double> elastic_;
  double porosity_, dt_, temperature_;
  double tau_y_ = 0, eta_ = 0;
};

}  // namespace bake
