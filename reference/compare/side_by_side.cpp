// SPDX-License-Identifier: MIT
#include "reference/compare/side_by_side.h"

#include <algorithm>
#include <cmath>

#include "reference/compare/recipe_of.h"
#include "solver/particles/fields.h"

namespace bake {

namespace {

/// Conjugate gradients must not stop early: what is compared is the step, not where an iteration ends.
Scene with_exact_conduction(Scene scene) {
  std::get<Heat::Settings>(scene.settings).tolerance = 1e-15;
  return scene;
}

/// One field of the solver, `width` numbers per particle, beside the same numbers of the textbook.
template <class Values, class NumbersOf>
FieldDifference compare(const char* field, const Values& solver, const std::vector<textbook::Particle>& particles, NumbersOf numbers_of) {
  FieldDifference d{field};
  std::size_t at = 0;
  for (const textbook::Particle& p : particles)
    for (const double number : numbers_of(p)) {
      const double difference = std::abs(solver[at++] - number);
      d.largest = std::max(d.largest, std::isnan(difference) ? k_infinity : difference);
      d.scale = std::max(d.scale, std::abs(number));
    }
  return d;
}

std::vector<double> flat(const std::vector<Vector3>& vectors) {
  std::vector<double> numbers;
  for (const Vector3& v : vectors) numbers.insert(numbers.end(), v.begin(), v.end());
  return numbers;
}

std::array<double, 3> numbers(const textbook::Vector& v) { return {v[0], v[1], v[2]}; }

}  // namespace

double worst(const std::vector<FieldDifference>& differences) {
  double largest = 0;
  for (const FieldDifference& d : differences) largest = d.relative() <= largest ? largest : d.relative();
  return largest;
}

SideBySide::SideBySide(const Scene& scene)
    : scene_(with_exact_conduction(scene)), solver_(Simulation::begin(scene_)), baker_(recipe_of(scene_)) {
  for (const NewParticle& p : fill_bodies(scene_)) baker_.add(beginning_of(scene_, p, next_id_++));
  for (std::size_t i = 0; i < scene_.emitters.size(); ++i) spouts_.push_back(std::make_unique<Spout>(scene_, scene_.emitters[i], i));
  pour_due();
  baker_.step(0, surroundings_of(scene_, 0));
}

void SideBySide::pour_due() {
  for (const auto& spout : spouts_)
    while (spout->next_time() <= solver_->time())
      for (const NewParticle& p : spout->pour()) baker_.add(beginning_of(scene_, p, next_id_++));
}

bool SideBySide::step() {
  const double begin = solver_->time(), dt = solver_->dt();
  if (!(dt > 0) || begin >= scene_.run.end_s) return false;
  last_dt_ = dt;
  solver_->advance(begin + dt, scene_.run.end_s);
  baker_.step(dt, surroundings_of(scene_, begin));
  pour_due();
  return true;
}

std::vector<FieldDifference> SideBySide::differences() const {
  const Snapshot s = solver_->snapshot();
  const auto& particles = baker_.particles();
  const bool same = std::equal(s.id.begin(), s.id.end(), particles.begin(), particles.end(),
                               [](std::int64_t id, const textbook::Particle& p) { return id == p.id; });
  if (!same) return {{"particles", k_infinity, 1}};

  std::vector<FieldDifference> all;
  const auto add = [&](const char* field, const std::vector<double>& solver, auto numbers_of) {
    all.push_back(compare(field, solver, particles, numbers_of));
  };
  const auto add_column = [&](const char* field, const char* column, auto number_of) {
    add(field, s[column], [&](const textbook::Particle& p) { return std::array{number_of(p)}; });
  };
  add("position", flat(s.position), [](const textbook::Particle& p) { return numbers(p.x); });
  if (scene_.lists(Motion::name)) {
    add("velocity", flat(s.velocity), [](const textbook::Particle& p) { return numbers(p.v); });
    // Stresses that cancel leave round-off, which moves particles at about epsilon times the wave speed, and that is below dx / dt.
    FieldDifference& velocity = all.back();
    velocity.scale = std::max(velocity.scale, 1e-4 * scene_.dx() / last_dt_);
    const double strain_of_a_step = last_dt_ * velocity.scale / scene_.dx();  // whose round-off the strain of a stiff body has
    add_column("J", field::VolumeRatio::name, [](const textbook::Particle& p) { return p.J; });
    add("b_E - I", s[field::ElasticStrain::name], [](const textbook::Particle& p) {
      const textbook::Matrix& b = p.b_E;
      return std::array{b(0, 0) - 1, b(1, 1) - 1, b(2, 2) - 1, b(1, 2), b(0, 2), b(0, 1)};
    });
    all.back().scale = std::max(all.back().scale, strain_of_a_step);
  }
  if (scene_.lists(Plasticity::name)) add_column("J_P", field::PlasticVolumeRatio::name, [](const textbook::Particle& p) { return p.J_P; });
  if (scene_.lists(Heat::name)) {
    add_column("theta", field::Temperature::name, [](const textbook::Particle& p) { return p.theta; });
    add_column("peak theta", field::PeakTemperature::name, [](const textbook::Particle& p) { return p.theta_peak; });
  }
  if (scene_.lists(Water::name)) add_column("m_w", field::WaterMass::name, [](const textbook::Particle& p) { return p.m_w; });
  if (scene_.lists(Leavening::name)) {
    add_column("nu", field::ProducedGas::name, [](const textbook::Particle& p) { return p.nu; });
    add_column("leavener", field::Leavener::name, [](const textbook::Particle& p) { return p.c; });
  }
  return all;
}

double SideBySide::textbook_bytes(const Scene& scene) { return textbook::Baker::bytes(recipe_of(scene)); }

}  // namespace bake
