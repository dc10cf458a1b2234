// SPDX-License-Identifier: MIT
#include "reference/compare/recipe_of.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/boundary/scripted.h"
#include "solver/effects/all_effects.h"
#include "solver/effects/skin_of_scene.h"

namespace bake {

namespace {

template <class... Structs>
constexpr std::size_t k_keys = (0 + ... + std::tuple_size_v<decltype(Structs::parameters())>);
static_assert(
    k_keys<DomainSettings, GridSettings, SurfaceSettings, Oven, Material, Body, Collider, Grip, DomainFace, Emitter, Skin> == 77 &&
        k_keys<Motion::Settings, Heat::Settings, Water::Settings, Elasticity::Settings, Plasticity::Settings, Leavening::Settings> == 22 &&
        k_keys<Heat::Material, Water::Material, Elasticity::Material, Plasticity::Material, Leavening::Material> == 23,
    "scenes have another number of keys: hand the new one to the textbook or refuse it here, so that it is not left out silently");

void refuse_unknown_effects(const Scene& scene) {
  const std::vector<std::string> known{Motion::name, Heat::name, Water::name, Elasticity::name, Plasticity::name, Leavening::name};
  for (const std::string& effect : scene.effects)
    if (std::find(known.begin(), known.end(), effect) == known.end())
      throw InputError(
          fmt::format("{}: found {}, allowed: what the textbook knows: {}", scene.at("effects"), effect, fmt::join(known, ", ")));
}

textbook::Vector plain(const Vector3& v) { return {{v[0], v[1], v[2]}}; }
Vector3 packed(const textbook::Vector& v) { return {v[0], v[1], v[2]}; }

textbook::Form plain(Form form) { return form == Form::published ? textbook::Form::published : textbook::Form::standard; }

textbook::Rule plain(Contact contact) {
  return contact == Contact::sticky ? textbook::Rule::sticky : contact == Contact::slip ? textbook::Rule::slip : textbook::Rule::separating;
}

textbook::Rule plain(Face face) {
  return face == Face::open || face == Face::periodic ? textbook::Rule::open
         : face == Face::sticky                       ? textbook::Rule::sticky
         : face == Face::slip                         ? textbook::Rule::slip
                                                      : textbook::Rule::separating;
}

textbook::Material plain(const Material& m) {
  textbook::Material out;
  out.density = m.density_kg_per_m3;
  out.initial_porosity = m.initial_porosity;
  out.s_0 = m.initial_saturation;
  out.theta_0 = m.initial_temperature_C;
  out.young_modulus = of<Elasticity>(m).young_modulus_Pa;
  out.poisson_ratio = of<Elasticity>(m).poisson_ratio;
  const auto& heat = of<Heat>(m);
  out.alpha_s = heat.specific_heat_J_per_kgK;
  out.kappa = heat.conductivity_W_per_mK;
  out.alpha_l = heat.expansion_per_K;
  out.transition_heat = heat.transition_heat_J_per_kg;
  out.transition_from = heat.transition_from_C;
  out.transition_to = heat.transition_to_C;
  const auto& water = of<Water>(m);
  out.rho_w = water.water_density_kg_per_m3;
  out.K = water.diffusivity_m2_per_sK;
  out.beta_w = water.evaporation_kg_per_m2sK;
  out.c_hat = water.pressure_Pa;
  out.D_v = water.vapour_diffusivity_m2_per_s;
  out.h_v = water.vapour_transfer_m_per_s;
  out.X_h = water.hygroscopic_water_kg_per_kg;
  const auto& plasticity = of<Plasticity>(m);
  for (std::size_t i = 0; i < 4; ++i) {
    out.theta[i] = plasticity.temperatures_C[i];
    out.tau_y[i] = plasticity.yield_stress_Pa[i];
    out.eta[i] = plasticity.viscosity_Pa_s[i];
  }
  const auto& leavening = of<Leavening>(m);
  out.alpha_g = leavening.production_mol_per_kgs;
  out.theta_r = leavening.peak_temperature_C;
  out.delta_theta = leavening.temperature_width_K;
  out.leavener_total = leavening.leavener_mol_per_m3;
  return out;
}

/// `thing`: a collider or a grip.
template <class Thing>
textbook::Solid solid_at(const Thing& thing, double time_s, double dt) {
  const ScriptedShape scripted{thing.shape, RigidPath(thing.motion, thing.pivot_m), thing.from_s, thing.until_s};
  const RigidState pose = scripted.path.at(time_s);
  textbook::Solid solid;
  solid.distance = [=](const textbook::Vector& x) { return scripted.distance(pose, packed(x)); };
  solid.normal = [=](const textbook::Vector& x) { return plain(scripted.normal(pose, packed(x))); };
  solid.velocity = [=](const textbook::Vector& x) { return plain(pose.velocity_at(packed(x))); };
  if (thing.temperature_C) solid.theta = thing.temperature_C->mean(time_s, time_s + dt);
  return solid;
}

template <class Thing>
bool present(const Thing& thing, double time_s) {
  return time_s >= thing.from_s && time_s < thing.until_s;
}

void refuse_fracture(const Scene& scene) {
  for (const Material& m : scene.materials)
    if (const double energy = of<Plasticity>(m).fracture_energy_J_per_m2; energy < k_infinity)
      throw InputError(fmt::format("{}: found {:g}, allowed: inf, which the textbook knows",
                                   scene.at(fmt::format("material.{}.fracture_energy_J_per_m2", m.name)), energy));
}

void refuse_settling(const Scene& scene) {
  if (const double damping = scene.of<Motion>().settle_damping_per_s; scene.lists(Motion::name) && damping > 0)
    throw InputError(
        fmt::format("{}: found {:g}, allowed: 0, since the textbook does not settle", scene.at("motion.settle_damping_per_s"), damping));
}

void refuse_kept_surface(const Scene& scene) {
  if (const double keep = scene.surface.keep_dx; keep > 0)
    throw InputError(
        fmt::format("{}: found {:g}, allowed: 0, since the textbook measures in every step", scene.at("surface.keep_dx"), keep));
}

}  // namespace

textbook::Recipe recipe_of(const Scene& scene) {
  refuse_unknown_effects(scene);
  refuse_settling(scene);
  refuse_kept_surface(scene);
  refuse_fracture(scene);
  textbook::Recipe r;
  r.motion = scene.lists(Motion::name);
  r.heat = scene.lists(Heat::name);
  r.water = scene.lists(Water::name);
  r.elasticity = scene.lists(Elasticity::name);
  r.plasticity = scene.lists(Plasticity::name);
  r.leavening = scene.lists(Leavening::name);
  for (const Material& m : scene.materials) r.materials.push_back(plain(m));

  const DomainSettings& domain = scene.domain;
  r.dx = scene.dx();
  r.low = plain(domain.min_m);
  for (std::size_t d = 0; d < 3; ++d) {
    constexpr double k_rounding = 1e-6;  // a box of a whole number of cells gets no further one
    r.cells[d] = std::max(1, static_cast<int>(std::ceil((domain.max_m[d] - domain.min_m[d]) / r.dx - k_rounding)));
  }
  const Face faces[3][2] = {{domain.x_min, domain.x_max}, {domain.y_min, domain.y_max}, {domain.z_min, domain.z_max}};
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) r.faces[axis][side] = plain(faces[axis][side]);
  for (const DomainFace& face : scene.faces)
    if (face.passes_heat()) r.mirrors[static_cast<int>(face.at) / 2][static_cast<int>(face.at) % 2] = false;
  for (int axis = 0; axis < 3; ++axis)
    if (domain.is_periodic(axis)) r.periodic[axis] = true, r.mirrors[axis][0] = r.mirrors[axis][1] = false;
  r.face_friction = domain.friction;
  r.kernel = scene.grid.kernel == KernelOrder::cubic ? textbook::Kernel::cubic : textbook::Kernel::quadratic;

  const auto& motion = scene.of<Motion>();
  r.transfer = motion.transfer == Motion::Transfer::flip  ? textbook::Transfer::flip
               : motion.transfer == Motion::Transfer::pic ? textbook::Transfer::pic
                                                          : textbook::Transfer::apic;
  r.flip_blend = motion.flip_blend;
  r.inertia_scale = motion.inertia_scale;

  const auto& heat = scene.of<Heat>();
  if (heat.integrator == Heat::Integrator::backward_euler) r.heat_step = textbook::HeatStep::backward_euler;
  r.heat_transfer_form = plain(heat.heat_transfer_form);
  r.expansion_form = plain(heat.expansion_form);
  r.water_form = plain(scene.of<Water>().form);
  r.heat_subgrid = heat.subgrid_diffusion;
  r.water_subgrid = scene.of<Water>().subgrid_diffusion;
  r.alpha_w = heat.water_specific_heat_J_per_kgK;
  r.latent_heat = scene.of<Water>().latent_heat_J_per_kg;
  r.leavening_form = plain(scene.of<Leavening>().form);
  r.pores_open = scene.of<Leavening>().pores == Leavening::Pores::open;
  r.reference_pressure = scene.of<Leavening>().reference_pressure_Pa;
  r.porosity_form = plain(scene.of<Plasticity>().porosity_form);
  if (scene.of<Plasticity>().norm == Plasticity::Norm::quadratic) r.norm = textbook::Norm::quadratic;
  r.surface_form = plain(scene.surface.form);
  return r;
}

textbook::Surroundings surroundings_of(const Scene& scene, double time_s, double dt) {
  textbook::Surroundings s;
  s.gravity = plain(scene.of<Motion>().gravity_m_per_s2.mean(time_s, time_s + dt));
  const auto mean = [&](const Curve& curve) { return curve.mean(time_s, time_s + dt); };
  s.air = {mean(scene.oven.heat_transfer_coefficient_W_per_m2K), mean(scene.oven.temperature_C), mean(scene.oven.equilibrium_saturation)};
  for (const Collider& collider : scene.colliders) {
    if (!present(collider, time_s)) continue;
    s.solids.push_back(solid_at(collider, time_s, dt));
    s.solids.back().rule = plain(collider.contact);
    s.solids.back().friction = collider.friction;
    s.solids.back().expels = collider.expels;
    s.solids.back().covers = collider.covers;
    s.solids.back().beta = collider.heat_transfer_coefficient_W_per_m2K;
  }
  for (const Grip& grip : scene.grips) {
    if (!present(grip, time_s)) continue;
    s.solids.push_back(solid_at(grip, time_s, dt));
    s.solids.back().rule = textbook::Rule::sticky;
    s.solids.back().is_grip = true;
    s.solids.back().covers = false;
  }
  for (const DomainFace& face : scene.faces) {
    if (!face.passes_heat()) continue;
    const int axis = static_cast<int>(face.at) / 2;
    const bool far = static_cast<int>(face.at) % 2 != 0;
    const textbook::Recipe recipe = recipe_of(scene);
    const double at = recipe.low[axis] + (far ? recipe.cells[axis] * recipe.dx : 0);
    textbook::Solid wall;
    textbook::Vector inward;
    inward[axis] = far ? -1 : 1;
    wall.distance = [=](const textbook::Vector& x) { return inward[axis] * (x[axis] - at); };
    wall.normal = [=](const textbook::Vector&) { return inward; };
    if (face.temperature_C) {
      wall.theta = mean(*face.temperature_C);
      wall.beta = face.heat_transfer_coefficient_W_per_m2K.value_or(k_infinity);
    }
    if (face.heat_flux_W_per_m2) wall.flux = mean(*face.heat_flux_W_per_m2);
    s.walls.push_back(wall);
  }
  return s;
}

void cover(const Scene& scene, const std::vector<MadeSkin>& skins, const std::vector<NewParticle>& vertices, textbook::Baker& baker) {
  std::size_t first = 0;
  for (std::size_t s = 0; s < skins.size(); ++s) {
    const Skin& skin = scene.skins[s];
    textbook::Sheet sheet{skin.young_modulus_Pa, skin.poisson_ratio, skin.thickness_m, skin.density_kg_per_m3, skin.permeance};
    sheet.inertia = inertia_of_skin(scene, skin);
    std::vector<textbook::Vector> points, velocities, angular;
    for (std::size_t v = first; v < first + skins[s].mesh.points.size(); ++v) {
      points.push_back(plain(vertices[v].x));
      velocities.push_back(plain(vertices[v].velocity));
      angular.push_back(plain(vertices[v].angular_velocity));
    }
    first += points.size();
    baker.cover(sheet, points, {skins[s].mesh.triangles.begin(), skins[s].mesh.triangles.end()}, skins[s].covers, velocities, angular);
  }
}

textbook::Beginning beginning_of(const Scene& scene, const NewParticle& particle, std::int64_t id) {
  const Material& m = scene.materials[static_cast<std::size_t>(particle.material)];
  textbook::Beginning b;
  b.id = id;
  b.material = particle.material;
  b.x = plain(particle.x);
  b.v = plain(particle.velocity);
  b.volume = particle.volume;
  b.angular_velocity = plain(particle.angular_velocity);
  b.theta = particle.body->temperature_C.value_or(m.initial_temperature_C);
  b.saturation = particle.body->saturation.value_or(m.initial_saturation);
  b.leavener = particle.body->leavener;
  return b;
}

}  // namespace bake
