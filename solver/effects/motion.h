// SPDX-License-Identifier: MIT
// Motion: momentum, the affine velocity field and the volume it carries along.
#pragma once

#include "solver/core/parameter.h"
#include "solver/core/symmetric.h"
#include "solver/effects/fields.h"
#include "solver/effects/totals.h"

namespace bake {

struct Motion {
  static constexpr const char* name = "motion";
  static constexpr const char* meaning = "particles move: momentum, transfers, gravity, colliders";

  enum class Transfer { apic, pic, flip };
  friend constexpr auto choice_names(Transfer) { return std::array{"apic", "pic", "flip"}; }

  struct Settings {
    Transfer transfer = Transfer::apic;
    double flip_blend = 0.95;
    Vector3 gravity_m_per_s2 = {0, 0, -9.81};
    double inertia_scale = 1;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"transfer", &Settings::transfer, "", any_number, "velocity transfer between particles and grid"},
          Parameter{"flip_blend", &Settings::flip_blend, "1", fraction, "share of FLIP in a FLIP/PIC blend (transfer = \"flip\")"},
          Parameter{"gravity_m_per_s2", &Settings::gravity_m_per_s2, "m/s^2", any_number, "acceleration of gravity"},
          Parameter{"inertia_scale", &Settings::inertia_scale, "1", positive,
                    "multiplies the inertial mass only (mass scaling for quasi-static baking)"},
      };
    }
  };
  struct Material {
    static constexpr auto parameters() { return std::tuple{}; }
  };

  using Stored = FieldList<field::VolumeRatio>;
  using Transient = FieldList<field::Velocity, field::AffineVelocity, field::KirchhoffStress>;
  using Moments = FieldList<channel::Momentum>;
  using Values = FieldList<channel::Mass>;
  using Gathered = FieldList<channel::NodeVelocity>;

  template <class Real>
  struct Constants {
    Real affine, flip, inertia;
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial&) {
      const auto& settings = scene.settings.template get<Settings>();
      affine = settings.transfer == Transfer::apic;
      flip = settings.transfer == Transfer::flip ? static_cast<Real>(settings.flip_blend) : Real(0);
      inertia = static_cast<Real>(settings.inertia_scale);
    }
  };

  template <class P>
  static void fill(P& p, int lane, double, double) {
    p[field::J][lane] = 1;
  }

  /// x += dt v, J *= det(I + dt C), with v and C = grad v of the nodes around.
  template <class P, class From, class K, class S, class R>
  BAKE_INLINE static void gather(P& p, const From& from, const K& k, const S& step, R&) {
    for (int i = 0; i < 3; ++i) {
      const auto v = from.value(channel::velocity, i);
      p[field::x][i] += (step.dt / step.dx) * v;
      if constexpr (P::template stores<field::Velocity>)
        p[field::v][i] = v + k.flip * (p[field::v][i] - from.value(channel::old_velocity, i));
      else
        p[field::v][i] = v;
      for (int j = 0; j < 3; ++j) p[field::C][3 * i + j] = from.gradient(channel::velocity, i, j);
    }
    const auto& C = p[field::C];
    const auto a = [&](int i, int j) { return i == j ? 1 + step.dt * C[3 * i + j] : step.dt * C[3 * i + j]; };
    p[field::J] *= a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) - a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
                   a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
  }

  /// w m (v + C r) - dt V_0 tau D^-1 w r; tau is the Kirchhoff stress of the whole mixture.   [Ding19 Eq. 26-27]
  template <class P, class To, class K, class S, class R>
  BAKE_INLINE static void scatter(P& p, To& to, const K& k, const S& step, R&) {
    const auto m = k.inertia * p.mass();
    const auto force = -step.dt_next * step.inverse_d * p[field::V_0];
    to.value(channel::mass) += m;
    for (int i = 0; i < 3; ++i) {
      to.value(channel::momentum, i) += m * p[field::v][i];
      for (int j = 0; j < 3; ++j)
        to.moment(channel::momentum, i, j) += k.affine * m * p[field::C][3 * i + j] + force * p[field::tau][k_component[i][j]];
    }
  }

  template <class P, class K, class S, class R>
  BAKE_INLINE static void limits(P& p, const K& k, const S&, R& report) {
    auto& e = report.extremes;
    auto speed2 = p[field::v][0] * p[field::v][0], deformation2 = p[field::C][0] * p[field::C][0];
    for (int i = 1; i < 3; ++i) speed2 += p[field::v][i] * p[field::v][i];
    for (int i = 1; i < 9; ++i) deformation2 += p[field::C][i] * p[field::C][i];
    e.speed2 = max(e.speed2, speed2);
    e.deformation2 = max(e.deformation2, deformation2);
    e.wave2 = max(e.wave2, p.stiffness * p[field::V_0] / (k.inertia * p.mass()));
  }

  /// v_i = momentum / mass, the mass being that after the step's water fluxes. Vapour leaves with the node's velocity, so that
  /// drying pushes nothing.
  template <class N, class S, class B>
  BAKE_INLINE static void update(N& node, const S&, B&) {
    auto& mass = node.sums.inertia;
    mass = node[channel::mass];
    if constexpr (N::template scatters<channel::WaterChange>) mass += node.inertia * (node.sums.moved + node.sums.evaporated);
    const auto inverse = mass > 0 ? 1 / mass : 0 * mass;
    for (int i = 0; i < 3; ++i) node.out(channel::velocity, i) = node[channel::momentum][i] * inverse;
    if constexpr (N::template scatters<channel::OldMomentum>)
      for (int i = 0; i < 3; ++i)
        node.out(channel::old_velocity, i) = node[channel::mass] > 0 ? node[channel::old_momentum][i] / node[channel::mass] : 0 * mass;
  }

  /// Of the inertial mass, which is what impulses act on. The water's own momentum is that of which the nodes know: the new flux
  /// acts on the solid in the next step.
  template <class P, class K, class S, class R>
  static void totals(P& p, const K& k, const S& step, R& report) {
    using V = typename P::V;
    const V m = k.inertia * p.mass(), affine_inertia = m / step.inverse_d;
    const auto& C = p[field::C];
    V position[3], momentum[3], kinetic = 0 * m;
    for (int i = 0; i < 3; ++i) {
      position[i] = report.origin[i] + step.dx * p[field::x][i];
      momentum[i] = m * p[field::v][i];
      if constexpr (P::template has<field::WaterMomentum>) momentum[i] += k.inertia * p[field::Q_old][i];
      kinetic += momentum[i] * p[field::v][i];
    }
    for (int i = 0; i < 9; ++i) kinetic += affine_inertia * C[i] * C[i];
    report.add(Total::kinetic, typename P::Real(0.5) * kinetic);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      report.add(static_cast<Total>(static_cast<int>(Total::momentum_x) + i), momentum[i]);
      report.add(static_cast<Total>(static_cast<int>(Total::angular_x) + i),
                 position[j] * momentum[l] - position[l] * momentum[j] + affine_inertia * (C[3 * l + j] - C[3 * j + l]));
    }
  }
};

}  // namespace bake
