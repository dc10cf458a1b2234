// SPDX-License-Identifier: MIT
// Elasticity: Hencky's logarithmic strain and a quadratic energy in it. [Ding19 Sec. 5.2]
#pragma once

#include "solver/core/parameter.h"
#include "solver/core/symmetric.h"
#include "solver/effects/effect.h"

namespace bake {

namespace total {
BAKE_FIELD(elastic, Elastic, 1, "elastic", "J", "energy of the solid's stress, that of expansion included");
}  // namespace total

struct Elasticity : Effect {
  static constexpr const char* name = "elasticity";
  static constexpr const char* meaning = "elastic stress of the solid, tau_E = C : 1/2 log b_E";

  static constexpr std::array needs{"motion"};

  struct Material {
    double young_modulus_Pa = 0;
    double poisson_ratio = 0.3;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"young_modulus_Pa", &Material::young_modulus_Pa, "Pa", positive, "E: Young's modulus of the solid", Presence::required},
          Parameter{"poisson_ratio", &Material::poisson_ratio, "1", Range{-1, 0.5, true, true, "a number above -1 and below 0.5"},
                    "nu: Poisson's ratio of the solid"},
      };
    }
  };

  using Stored = FieldList<field::ElasticStrain>;
  using Transient = FieldList<field::HenckyStrain>;
  using Totals = FieldList<total::Elastic>;

  template <class Real>
  struct Constants {
    Real lambda, mu, bulk;  ///< Lame's constants and the bulk modulus [Pa]
    template <class Scene, class SceneMaterial>
    Constants(const Scene&, const SceneMaterial& material) {
      const auto& m = material.effects.template get<Material>();
      const double E = m.young_modulus_Pa, nu = m.poisson_ratio;
      lambda = static_cast<Real>(E * nu / ((1 + nu) * (1 - 2 * nu)));
      mu = static_cast<Real>(E / (2 * (1 + nu)));
      bulk = static_cast<Real>(E / (3 * (1 - 2 * nu)));
    }
  };

  /// Trial state: b_tr = (I + dt C) b_E (I + dt C)^T, kept as b - I so that small strains keep their digits.
  BAKE_INLINE static void gather(auto& p, const auto&, const auto&, const auto& step, auto&) {
    using P = std::decay_t<decltype(p)>;
    using V = typename P::V;
    const auto& b = p[field::b_E];
    V D[3][3], M[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) D[i][j] = step.dt * p[field::C][3 * i + j];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        M[i][j] = D[i][j] + D[i][0] * b[k_component[0][j]] + D[i][1] * b[k_component[1][j]] + D[i][2] * b[k_component[2][j]];
    Symmetric<V> trial;
    for (int k = 0; k < 6; ++k) {
      const int i = k_row_of[k], j = k_column_of[k];
      trial.at[k] = b[k] + M[i][j] + M[j][i] + (M[i][0] * D[j][0] + M[i][1] * D[j][1] + M[i][2] * D[j][2]);
    }
    const auto strain = half_log1p<typename P::Real>(trial);
    for (int k = 0; k < 6; ++k) {
      p[field::b_E][k] = trial.at[k];
      p[field::epsilon][k] = strain.at[k];
    }
  }

  /// tau_E = lambda tr(eps) I + 2 mu eps
  BAKE_INLINE static void stress(auto& p, const auto& k) {
    const auto& e = p[field::epsilon];
    const auto volumetric = k.lambda * (e[0] + e[1] + e[2]);
    for (int i = 0; i < 6; ++i) p[field::tau][i] += 2 * k.mu * e[i] + (i < 3 ? volumetric : 0 * volumetric);
    p.stiffness += k.lambda + 2 * k.mu;
    p.shear_stiffness += k.mu;
  }

  static void totals(auto& p, const auto& k, const auto&, auto& report) {
    using P = std::decay_t<decltype(p)>;
    using V = typename P::V;
    Symmetric<V> e;
    for (int i = 0; i < 6; ++i) e.at[i] = p[field::epsilon][i];
    if constexpr (P::template has<field::ThermalStrain>)
      for (int i = 0; i < 3; ++i) e.at[i] -= typename P::Real(1. / 3) * p[field::thermal_strain];
    const V tr = trace(e);
    report.add(total::elastic, p[field::V_0] * (typename P::Real(0.5) * k.lambda * tr * tr + k.mu * norm_squared(e)));
  }

  static const char* coefficient(const Material& own) { return own.young_modulus_Pa > 0 ? "young_modulus_Pa" : ""; }
};

}  // namespace bake
