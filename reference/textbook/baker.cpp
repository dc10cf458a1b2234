// SPDX-License-Identifier: MIT
#include "reference/textbook/baker.h"

#include "reference/textbook/conduction.h"
#include "reference/textbook/contact.h"
#include "reference/textbook/elasticity.h"
#include "reference/textbook/heat.h"
#include "reference/textbook/leavening.h"
#include "reference/textbook/motion.h"
#include "reference/textbook/plasticity.h"
#include "reference/textbook/surface.h"
#include "reference/textbook/vapour.h"
#include "reference/textbook/water.h"

namespace bake::textbook {

void Baker::add(const Beginning& b) {
  Particle p;
  p.id = b.id;
  p.material = b.material;
  const Material& m = material(p);
  p.x = b.x;
  p.v = b.v;
  p.C = p.grad_v = {{{0, -b.angular_velocity[2], b.angular_velocity[1]},
                     {b.angular_velocity[2], 0, -b.angular_velocity[0]},
                     {-b.angular_velocity[1], b.angular_velocity[0], 0}}};
  p.V_0 = p.V_before = b.volume;
  p.theta = p.theta_peak = recipe_.heat ? b.theta : m.theta_0;
  p.c = b.leavener;
  // The density is that of the mixture at the material's own saturation: a wetter body has more water on the same solid.
  const double water_per_saturation = recipe_.water ? m.rho_w : 0;
  p.m_s = b.volume * (m.density - water_per_saturation * m.s_0);
  p.m_w = b.volume * water_per_saturation * b.saturation;
  update_stress(p);
  particles_.push_back(p);
}

void Baker::cover(const Sheet& sheet, const std::vector<Vector>& points, const std::vector<std::array<int, 3>>& triangles,
                  const std::vector<double>& covers, const std::vector<Vector>& velocities, const std::vector<Vector>& angular_velocities) {
  Skin skin{sheet, points, triangles, {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector& w = angular_velocities[i];
    skin.vertices.push_back({points[i], velocities[i], {{{0, -w[2], w[1]}, {w[2], 0, -w[0]}, {-w[1], w[0], 0}}}, 0, covers[i]});
  }
  for (const auto& t : triangles)
    for (const int corner : t) skin.vertices[static_cast<std::size_t>(corner)].area += triangle_area(points, t) / 3;
  skins_.push_back(skin);
}

void Baker::step(double dt, const Surroundings& surroundings) {
  scatter(dt, surroundings.gravity);
  update_nodes(dt, surroundings);
  gather(dt, surroundings);
}

void Baker::round_to_single() {
  const auto round = [](double& number) { number = static_cast<float>(number); };
  const auto round_all = [&](Vector& v) {
    for (double& number : v.at) round(number);
  };
  const auto round_matrix = [&](Matrix& a) {
    for (auto& row : a.at)
      for (double& number : row) round(number);
  };
  for (Particle& p : particles_) {
    for (double* number : {&p.V_0, &p.m_s, &p.J, &p.J_P, &p.theta, &p.theta_peak, &p.theta_lent, &p.m_w, &p.m_w_lent, &p.nu, &p.c})
      round(*number);
    for (Vector* v : {&p.x, &p.v, &p.grad_theta, &p.q, &p.j_v, &p.Q_scattered}) round_all(*v);
    Matrix strain = p.b_E - identity();  // small beside I, and of its own precision
    for (Matrix* a : {&p.C, &p.grad_v, &p.tau, &strain}) round_matrix(*a);
    p.b_E = identity() + strain;
  }
  for (Skin& skin : skins_)
    for (Vertex& p : skin.vertices) {
      round_all(p.x);
      round_all(p.v);
      round_matrix(p.C);
    }
}

void Baker::scatter(double dt, const Vector& gravity) {
  grid_.clear();
  for (Particle& p : particles_) {
    const Material& m = material(p);
    for_each_node(grid_, p.x, recipe_.kernel, [&](const Index& i, const Overlap& o) {
      Node& node = grid_[i];
      node.volume += o.w * p.V();  // [Ding19 Eq. 18]
      if (recipe_.motion) {
        scatter_momentum(p, recipe_, o, node);
        scatter_stress(p, dt, o, node);
      }
      if (recipe_.water) {
        scatter_water(p, m, o, node);
        scatter_water_flux(p, recipe_, dt, o, node);
        scatter_vapour(p, m, o, node);
      }
      if (recipe_.water && recipe_.motion) scatter_water_momentum(p, recipe_, dt, o, node);
      if (recipe_.heat) {
        scatter_heat(p, recipe_, m, o, node);
        if (recipe_.heat_step == HeatStep::forward_euler) scatter_conduction(p, m, dt, o, node);
        if (recipe_.motion) scatter_expansion(p, recipe_, m, dt, o, node);
        if (recipe_.water) {
          scatter_carried_heat(p, recipe_, dt, o, node);
          scatter_latent_heat(p, recipe_, dt, o, node);
        }
      }
    });
    p.Q_scattered = p.Q();
  }
  grid_.join();  // there are no skins between periodic faces
  for (const Skin& skin : skins_) {
    const std::vector<Vector> force = skin_forces(skin);
    for (std::size_t i = 0; i < skin.vertices.size(); ++i)
      for_each_node(grid_, skin.vertices[i].x, recipe_.kernel, [&](const Index& at, const Overlap& o) {
        scatter_vertex(skin, skin.vertices[i], force[i], gravity, recipe_, dt, o, grid_[at]);
      });
  }
}

void Baker::update_nodes(double dt, const Surroundings& surroundings) {
  if (recipe_.heat || recipe_.water) {
    if (recipe_.surface_form == Form::published)
      measure_published_surface(particles_, surroundings, grid_);
    else
      measure_surface(surroundings, grid_);
    grid_.repeat();
  }
  grid_.for_each([&](const Index& i, Node& node) {
    node.area = open_area(node);
    if (recipe_.motion && !(node.volume > 0) && node.mass > 0) update_velocity(recipe_, surroundings.gravity, dt, node);  // skin alone
    if (!(node.volume > 0)) return;
    if (recipe_.water) update_water(recipe_, surroundings, dt, node);
    if (recipe_.heat) {
      hold_temperature(recipe_, surroundings, grid_.position(i), node);
      update_heat(recipe_, dt, node);
      if (recipe_.water) update_vapour(node);
    }
    if (recipe_.motion) update_velocity(recipe_, surroundings.gravity, dt, node);
  });
  if (recipe_.motion) {
    std::vector<Vector> after(grid_.count());
    grid_.for_each([&](const Index& i, const Node& node) {
      if (moving_mass(recipe_, node) > 0) after[grid_.number(i)] = after_touching(grid_, surroundings, i);
    });
    grid_.for_each([&](const Index& i, Node& node) { node.v = after[grid_.number(i)]; });
  }
  if (recipe_.heat && recipe_.heat_step == HeatStep::backward_euler) conduct_implicitly(particles_, dt, grid_);
  grid_.repeat();
}

void Baker::gather(double dt, const Surroundings& surroundings) {
  const double D = second_moment(recipe_.kernel, recipe_.dx);
  std::vector<Particle> stay;
  for (Particle& p : particles_) {
    const Material& m = material(p);
    SeenVelocity velocity;
    SeenWater water;
    SeenHeat heat;
    SeenVapour vapour;
    for_each_node(grid_, p.x, recipe_.kernel, [&](const Index& i, const Overlap& o) {
      velocity.add(grid_[i], o, D);
      water.add(grid_[i], o, recipe_.water_form);
      heat.add(grid_[i], o);
      vapour.add(grid_[i], o);
    });
    if (recipe_.motion) move(velocity, recipe_, dt, p);
    if (recipe_.heat) take_heat(heat, recipe_, m, dt, is_held(surroundings, p.x), p);
    if (recipe_.heat && recipe_.water) take_vapour(vapour, m, p);
    if (recipe_.water) take_water(water, recipe_, m, dt, p);
    if (recipe_.elasticity) p.b_E = trial_strain(p, dt);
    if (recipe_.plasticity) return_mapping(recipe_, m, dt, p);
    if (recipe_.leavening) react(m, dt, p);
    if (recipe_.motion) expel(recipe_, surroundings, p.x, p.v);
    update_stress(p);
    if (!leaves(recipe_, p.x)) stay.push_back(p);
  }
  particles_ = stay;
  for (Skin& skin : skins_)
    for (Vertex& p : skin.vertices) {
      SeenVelocity velocity;
      for_each_node(grid_, p.x, recipe_.kernel, [&](const Index& i, const Overlap& o) { velocity.add(grid_[i], o, D); });
      p.x += dt * velocity.v;
      p.v = velocity.v;
      p.C = velocity.affine;
      expel(recipe_, surroundings, p.x, p.v);
      leaves(recipe_, p.x);
    }
}

/// tau = tau_E - (J p_gas + J p_water + beta_T (theta - theta_0)) I, of solid, gas and water together.   [Ding19 Eq. 10, 13, 14]
void Baker::update_stress(Particle& p) const {
  const Material& m = material(p);
  double pressure = 0;
  if (recipe_.heat) pressure += thermal_pressure(p, recipe_, m);
  if (recipe_.water) pressure += water_pressure(p, m);
  if (recipe_.leavening) pressure += gas_pressure(p, recipe_, m);
  p.tau = (-pressure) * identity();
  if (recipe_.elasticity) p.tau += elastic_stress(hencky_strain(p.b_E), m);
}

}  // namespace bake::textbook
