// SPDX-License-Identifier: MIT
// Motion: momentum, the affine velocity field and the volume it carries along.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "solver/core/kernel_order.h"
#include "solver/core/parameter.h"
#include "solver/core/step_limit.h"
#include "solver/core/symmetric.h"
#include "solver/effects/effect.h"
#include "solver/effects/leavening.h"

namespace bake {

namespace booked {
BAKE_FIELD(damped, Damped, 1, "damped", "J", "kinetic energy of the inertial mass that settling took");
}  // namespace booked

namespace total {
BAKE_FIELD(momentum, Momentum, 3, "momentum", "kg m/s", "momentum, sum of m v + V q, the water's flux being that of the step before");
BAKE_FIELD(angular_momentum, AngularMomentum, 3, "angular_momentum", "kg m^2/s", "angular momentum about the origin, with the affine part");
BAKE_FIELD(kinetic, Kinetic, 1, "kinetic", "J", "kinetic energy of the inertial mass, with the affine part");
}  // namespace total

namespace bound {
BAKE_FIELD(speed_squared, SpeedSquared, 1, "speed_squared", "m^2/s^2", "|v|^2");
BAKE_FIELD(sound_speed_squared, SoundSpeedSquared, 1, "sound_speed_squared", "m^2/s^2", "stiffness over density, c^2");
BAKE_FIELD(own_frequency_squared, OwnFrequencySquared, 1, "own_frequency_squared", "1/s^2",
           "of a particle's volume when it is alone on its nodes; infinite once that volume is not above 0");
BAKE_FIELD(inner_frequency_squared, InnerFrequencySquared, 1, "inner_frequency_squared", "1/s^2", "of a particle's volume inside of dough");
BAKE_FIELD(deformation_rate_squared, DeformationRateSquared, 1, "deformation_rate_squared", "1/s^2", "|C|^2");
}  // namespace bound

struct Motion : Effect {
  static constexpr const char* name = "motion";
  static constexpr const char* meaning = "particles move: momentum, transfers, gravity, colliders";

  enum class Transfer { apic, pic, flip };
  friend constexpr auto choice_names(Transfer) { return std::array{"apic", "pic", "flip"}; }

  struct Settings {
    Transfer transfer = Transfer::apic;
    double flip_blend = 0.95;
    VectorCurve gravity_m_per_s2 = Vector3{0, 0, -9.81};
    double inertia_scale = 1;
    double settle_damping_per_s = 0;
    double settle_still_m_per_s = 1e-3;
    double settle_longest_s = 1;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"transfer", &Settings::transfer, "", any_number,
                    "velocity transfer between particles and grid; \"apic\" keeps spin, \"pic\" and \"flip\" lose it with every step"},
          Parameter{"flip_blend", &Settings::flip_blend, "1", fraction, "share of FLIP in a FLIP/PIC blend (transfer = \"flip\")"},
          Parameter{"gravity_m_per_s2", &Settings::gravity_m_per_s2, "m/s^2", any_number,
                    "acceleration of gravity, over time if it changes; each step takes its mean over the step"},
          Parameter{"inertia_scale", &Settings::inertia_scale, "1", positive,
                    "multiplies the inertial mass only (mass scaling for quasi-static baking)"},
          Parameter{
              "settle_damping_per_s", &Settings::settle_damping_per_s, "1/s", non_negative,
              "if above 0, the dough settles before the scene's time begins: it moves, velocities decay at this rate, and heat, water, "
              "leavener, colliders and all clocks stand still"},
          Parameter{"settle_still_m_per_s", &Settings::settle_still_m_per_s, "m/s", positive,
                    "settling ends when no particle was faster for 1 / settle_damping_per_s"},
          Parameter{"settle_longest_s", &Settings::settle_longest_s, "s", positive, "settling ends then, still or not"},
      };
    }
  };
  using Stored = FieldList<field::VolumeRatio>;
  using Transient = FieldList<field::VolumeRatioBefore, field::Velocity, field::AffineVelocity, field::KirchhoffStress>;
  using Moments = FieldList<channel::Momentum>;
  using Values = FieldList<channel::Mass>;
  using Gathered = FieldList<channel::NodeVelocity>;
  using Booked = FieldList<booked::Damped>;
  using Totals = FieldList<total::Momentum, total::AngularMomentum, total::Kinetic>;
  using Bounds = FieldList<bound::SpeedSquared, bound::SoundSpeedSquared, bound::OwnFrequencySquared, bound::InnerFrequencySquared,
                           bound::DeformationRateSquared>;

  /// Whether pores that are pulled wide hold a vacuum, which pulls back.
  static bool pores_hold_vacuum(const auto& scene) {
    return std::find(scene.effects.begin(), scene.effects.end(), Leavening::name) != scene.effects.end() &&
           scene.settings.template get<Leavening::Settings>().pores == Leavening::Pores::closed;
  }

  template <class Real>
  struct Constants {
    Real affine, flip, inertia;
    Real room;  ///< volume with which a particle alone fills its nodes [m^3]; infinite where gas in closed pores resists opening
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial&) {
      const auto& settings = scene.settings.template get<Settings>();
      affine = settings.transfer == Transfer::apic;
      flip = settings.transfer == Transfer::flip ? static_cast<Real>(settings.flip_blend) : Real(0);
      inertia = static_cast<Real>(settings.inertia_scale);
      const double overlap = scene.grid.kernel == KernelOrder::quadratic ? 11. / 20 : 151. / 315;  // integral of N^2
      const double width = scene.dx() / overlap;
      room = pores_hold_vacuum(scene) ? static_cast<Real>(k_infinity) : static_cast<Real>(width * width * width);
    }
  };

  template <class Real>
  struct NodeConstants {
    Real inertia;
    template <class Scene>
    explicit NodeConstants(const Scene& scene) : inertia(static_cast<Real>(scene.template of<Motion>().inertia_scale)) {}
  };

  static void describe(auto& model, const auto& scene) {
    const auto& settings = scene.template of<Motion>();
    model.moves = true;
    model.samples_stress = scene.run.stress_in_frames;
    model.gravity = settings.gravity_m_per_s2;
    model.inertia_scale = settings.inertia_scale;
    using Model = std::decay_t<decltype(model)>;
    model.speed_bound = Model::Bounds::template offset<bound::SpeedSquared>;
    model.rate_bound = Model::Bounds::template offset<bound::DeformationRateSquared>;
    model.own_bound = Model::Bounds::template offset<bound::OwnFrequencySquared>;
    model.settling = {settings.settle_damping_per_s, settings.settle_still_m_per_s, settings.settle_longest_s,
                      Model::Booked::template offset<booked::Damped>};
  }

  static void fill(auto& p, int lane, const auto&) { p[field::J][lane] = 1; }

  /// x += dt v, J *= det(I + dt C), with v and C = grad v of the nodes around.
  /// A particle that is alone on its nodes gets back the C that it gave: a memory that tells nothing of the dough around, by which J would
  /// grow without end where no stress resists (torn, with open pores or no gas; a vacuum in closed pores resists). But its nodes' room is
  /// bounded: sum w w V / dx^3 is the share of it that the particle fills itself, 0.03 in fresh dough, and the dough is in pieces long
  /// before it is 1. There, V = dx^3 / (integral of N^2)^3 on average over the places in a cell, it opens no further, and forgets that it
  /// did. Its momenta stay.
  BAKE_INLINE static void gather(auto& p, const auto& from, const auto& k, const auto& step, auto&) {
    using P = std::decay_t<decltype(p)>;
    for (int i = 0; i < 3; ++i) {
      const auto v = from.value(channel::velocity, i);
      p[field::x][i] += (step.dt / step.dx) * v;
      if constexpr (P::template stores<field::Velocity>)
        p[field::v][i] = v + k.flip * (p[field::v][i] - from.value(channel::old_velocity, i));
      else
        p[field::v][i] = v;
      for (int j = 0; j < 3; ++j) p[field::C][3 * i + j] = from.gradient(channel::velocity, i, j);
    }
    auto& C = p[field::C];
    const auto a = [&](int i, int j) { return i == j ? 1 + step.dt * C[3 * i + j] : step.dt * C[3 * i + j]; };
    p[field::J_before] = p[field::J];
    const auto opened =
        p[field::J] * (a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) - a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
                       a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0)));
    const auto widest = max(p[field::J], k.room / p[field::V_0]);
    const auto full = opened > widest;
    p[field::J] = full ? widest : opened;
    const auto opening = full ? max(C[0] + C[4] + C[8], 0 * opened) * (1 / typename P::Real(3)) : 0 * opened;
    for (int i = 0; i < 9; i += 4) C[i] -= opening;
  }

  /// w m (v + C r) - dt V_0 tau D^-1 w r; tau is the Kirchhoff stress of the whole mixture.   [Ding19 Eq. 26-27]
  BAKE_INLINE static void scatter(auto& p, auto& to, const auto& k, const auto& step, auto&) {
    const auto m = k.inertia * p.own_mass();
    const auto force = -step.dt_next * step.inverse_d * p[field::V_0];
    to.value(channel::mass) += k.inertia * p.mass();
    for (int i = 0; i < 3; ++i) {
      to.value(channel::momentum, i) += m * p[field::v][i];
      for (int j = 0; j < 3; ++j)
        to.moment(channel::momentum, i, j) += k.affine * m * p[field::C][3 * i + j] + force * p[field::tau][k_component[i][j]];
    }
  }

  /// A particle alone on its nodes gets back the C that it gave, less dt tau / (rho d), d = 1 / inverse_d: its volume vibrates by
  /// d^2 tr(eps) / dt^2 = -3 K inverse_d / rho tr(eps), K being the bulk modulus of all that it is made of. Inside of dough others hold it:
  /// of the quadratic kernel's discrete equations with particles at random, 1 to 27 a cell of a volume V each, the largest
  /// eigenvalue was below omega^2 = (5.9 + 3.4 V/dx^3) K / (rho dx^2) in 99 of 100 bodies, and at most 1.16 times that.
  BAKE_INLINE static void bounds(auto& p, const auto& k, const auto& step, auto& report) {
    using P = std::decay_t<decltype(p)>;
    using Real = typename P::Real;
    auto speed2 = p[field::v][0] * p[field::v][0], deformation2 = p[field::C][0] * p[field::C][0];
    for (int i = 1; i < 3; ++i) speed2 += p[field::v][i] * p[field::v][i];
    for (int i = 1; i < 9; ++i) deformation2 += p[field::C][i] * p[field::C][i];
    report.bound(bound::speed_squared, speed2);
    report.bound(bound::deformation_rate_squared, deformation2);
    const auto per_density = p[field::V_0] / (k.inertia * p.mass());
    report.bound(bound::sound_speed_squared, p.stiffness * per_density);
    const auto own = (3 * p.stiffness - 4 * p.shear_stiffness) * per_density * step.inverse_d;
    const auto cells = p.volume() / (step.dx * step.dx * step.dx);
    report.bound(bound::inner_frequency_squared, own * min((Real(5.9) + Real(3.4) * cells) / 12, 0 * own + 1));
    report.bound(bound::own_frequency_squared, p[field::J] > 0 ? own : 0 * own + std::numeric_limits<Real>::infinity());
  }

  /// A wave crosses one cell: the highest frequency of the lumped B-spline grid is below 2 c / dx, explicit integration holds for
  /// dt < 2 / frequency. So it does for a particle alone, whose frequency is higher where it resists a change of volume more than one of
  /// shape, or for those that come next to that. |dt C| below 1/2 keeps I + dt C far from singular. Gravity accelerates the inertial mass
  /// by g / inertia_scale.
  static void largest_step(const auto& most, const StepScale& at, const auto& scene, StepLimit& limit) {
    const double c2 = most(bound::sound_speed_squared), C2 = most(bound::deformation_rate_squared), v2 = most(bound::speed_squared);
    const double own2 = most(bound::own_frequency_squared), inner2 = most(bound::inner_frequency_squared);
    const auto& motion = scene.template of<Motion>();
    const double acceleration = largest_length(motion.gravity_m_per_s2) / motion.inertia_scale;
    if (std::isinf(own2)) limit.at_most(0, "a particle's volume fell to zero");
    if (own2 > 0) limit.at_most(share_of_exact(at) * 2 / std::sqrt(std::max(at.alone * own2, inner2)), "vibration of single particles");
    if (c2 > 0) limit.at_most(at.safety * at.dx / std::sqrt(c2), "stiffness (elastic, pore gas and water)");
    if (C2 > 0) limit.at_most(0.5 / std::sqrt(C2), "rate of deformation");
    if (v2 > 0) limit.at_most(at.cfl * at.dx / std::sqrt(v2), "particle travel (time.cfl)");
    if (acceleration > 0) limit.at_most(std::sqrt(at.cfl * at.dx / acceleration), "gravity (time.cfl)");
  }

  /// v_i = momentum / mass, the mass being that after the step's water fluxes. Vapour leaves with the node's velocity, so that
  /// drying pushes nothing.
  BAKE_INLINE static void update(auto& node, const auto& k, const auto&, auto&) {
    using N = std::decay_t<decltype(node)>;
    auto& mass = node.sums.inertia;
    mass = node[channel::mass];
    if constexpr (N::template scatters<channel::WaterChange>) mass += k.inertia * (node.sums.moved + node.sums.evaporated);
    const auto inverse = mass > 0 ? 1 / mass : 0 * mass;
    for (int i = 0; i < 3; ++i) node.out(channel::velocity, i) = node[channel::momentum][i] * inverse;
    if constexpr (N::template scatters<channel::OldMomentum>)
      for (int i = 0; i < 3; ++i)
        node.out(channel::old_velocity, i) = node[channel::mass] > 0 ? node[channel::old_momentum][i] / node[channel::mass] : 0 * mass;
  }

  /// Of the inertial mass, which is what impulses act on. The water's own momentum is that of which the nodes know: the new flux
  /// acts on the solid in the next step.
  static void totals(auto& p, const auto& k, const auto& step, auto& report) {
    using P = std::decay_t<decltype(p)>;
    using V = typename P::V;
    const V m = k.inertia * p.own_mass(), affine_inertia = m / step.inverse_d;
    const auto& C = p[field::C];
    V position[3], momentum[3], kinetic = 0 * m;
    for (int i = 0; i < 3; ++i) {
      position[i] = report.origin[i] + step.dx * p[field::x][i];
      momentum[i] = m * p[field::v][i];
      if constexpr (P::template has<field::WaterMomentum>) momentum[i] += k.inertia * p[field::Q_old][i];
      kinetic += momentum[i] * p[field::v][i];
    }
    for (int i = 0; i < 9; ++i) kinetic += affine_inertia * C[i] * C[i];
    report.add(total::kinetic, typename P::Real(0.5) * kinetic);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      report.add(total::momentum, momentum[i], i);
      report.add(total::angular_momentum,
                 position[j] * momentum[l] - position[l] * momentum[j] + affine_inertia * (C[3 * l + j] - C[3 * j + l]), i);
    }
  }

  static void show(auto& frame) {
    frame.sampled(field::v);
    frame.sampled(field::sigma);
    frame.sampled(field::von_mises);
    frame.stored(field::J);
  }

  static void ledger(auto& columns) {
    columns.made("max_speed", "m/s", "speed of the fastest particle",
                 [](const auto& now) { return std::sqrt(now.bound(bound::speed_squared)); });
    columns.made("settling_time", "s", "time that settling took before the scene's time began",
                 [](const auto& now) { return now.settling().time; });
  }

  /// Dough that falls under gravity and damping reaches g / damping, 0.63 of it within the time for which it must be slow.
  static void check_settings(const Settings& settings, const auto& complaint) {
    const double g = length(settings.gravity_m_per_s2(0)), most = g / (2 * settings.settle_damping_per_s);
    if (settings.settle_damping_per_s > 0 && g > 0 && settings.settle_still_m_per_s > most)
      complaint.at("settle_still_m_per_s",
                   "found {}, allowed: at most {:.3g} (gravity over twice settle_damping_per_s), or dough that falls counts as still",
                   settings.settle_still_m_per_s, most);
  }

  static std::string idle(const auto& here) {
    const auto moves = [](const auto& thing) { return thing.motion.size() > 1; };
    const auto starts = [](const auto& body) { return length(body.velocity_m_per_s) > 0 || length(body.angular_velocity_rad_per_s) > 0; };
    const auto& scene = here.scene;
    const bool pushed = largest_length(scene.template of<Motion>().gravity_m_per_s2) > 0 || !scene.emitters.empty() ||
                        here.any(scene.colliders, moves) || here.any(scene.grips, moves) || here.any(scene.bodies, starts);
    return pushed || here.swells ? "" : "there is no gravity, nothing else moves and nothing swells";
  }
};

}  // namespace bake
