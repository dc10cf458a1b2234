// SPDX-License-Identifier: MIT
// What every model has whatever its effects.
#pragma once

#include "solver/effects/effect.h"

namespace bake {

namespace booked {
BAKE_FIELD(impulse, Impulse, 3, "impulse", "kg m/s",
           "momentum given by gravity, colliders, grips, faces and settling, less what vapour takes along");
BAKE_FIELD(angular_impulse, AngularImpulse, 3, "angular_impulse", "kg m^2/s",
           "angular momentum given by gravity, colliders, grips, faces and settling, about the origin");
BAKE_FIELD(area, Area, 1, "", "m^2", "area that touches air");
BAKE_FIELD(contact_area, ContactArea, 1, "", "m^2", "area that touches heated colliders");
}  // namespace booked

namespace total {
BAKE_FIELD(solid_mass, SolidMass, 1, "solid_mass", "kg", "mass of the solid");
BAKE_FIELD(volume, Volume, 1, "volume", "m^3", "volume, V_0 J");
}  // namespace total

struct Common : Effect {
  static constexpr const char* name = "common";
  using Stored = FieldList<field::Position, field::Identity, field::InitialVolume, field::SolidMass>;
  using Booked = FieldList<booked::Impulse, booked::AngularImpulse, booked::Area, booked::ContactArea>;
  using Totals = FieldList<total::SolidMass, total::Volume>;

  /// Density is that of the mixture at the material's own saturation: a wetter body has more water on the same solid.
  static void fill(auto& p, int lane, const auto& start) {
    using Real = typename std::decay_t<decltype(p)>::Real;
    p[field::V_0][lane] = static_cast<Real>(start.volume);
    p[field::m_s][lane] = static_cast<Real>(start.volume * start.material.density_kg_per_m3);
  }

  static void totals(auto& p, const auto&, const auto&, auto& report) {
    report.add(total::solid_mass, p[field::m_s]);
    report.add(total::volume, p.volume());
  }

  static void ledger(auto& columns) {
    columns.made("surface", "m^2", "area that touches air, in the last step", [](const auto& now) { return now.booked(booked::area); });
    columns.made("contact_surface", "m^2", "area that touches heated colliders, in the last step",
                 [](const auto& now) { return now.booked(booked::contact_area); });
  }

  static void show(auto& frame) {
    frame.made("volume", "m^3", "volume, V_0 J", [](const auto&) { return [](const auto& p) { return p.volume(); }; });
  }
};

}  // namespace bake
