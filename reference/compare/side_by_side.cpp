// SPDX-License-Identifier: MIT
#include "reference/compare/side_by_side.h"

#include <algorithm>
#include <cmath>

#include "reference/compare/recipe_of.h"
#include "solver/effects/all_effects.h"
#include "solver/effects/fields.h"

namespace bake {

namespace {

/// Makes conjugate gradients iterate to round-off, so that the comparison does not depend on where an iteration stops.
Scene with_exact_conduction(Scene scene) {
  scene.settings.get<Heat::Settings>().tolerance = 1e-15;
  return scene;
}

using Numbers = std::vector<double>;

/// One field of the particles, as the textbook has it.
struct ComparedField {
  const char* name;
  const char* column;  ///< of the solver; empty for position and velocity
  Numbers (*of)(const textbook::Particle&);
};

std::vector<ComparedField> fields_of(const Scene& scene) {
  using P = const textbook::Particle&;
  std::vector<ComparedField> all{{"position", "", [](P p) { return Numbers{p.x[0], p.x[1], p.x[2]}; }}};
  const auto add = [&](std::vector<ComparedField> more) { all.insert(all.end(), more.begin(), more.end()); };
  if (scene.lists(Motion::name))
    add({{"velocity", "",
          [](P p) {
            return Numbers{p.v[0], p.v[1], p.v[2]};
          }},
         {"J", field::VolumeRatio::name, [](P p) { return Numbers{p.J}; }},
         {"b_E - I", field::ElasticStrain::name, [](P p) {
            const textbook::Matrix& b = p.b_E;
            return Numbers{b(0, 0) - 1, b(1, 1) - 1, b(2, 2) - 1, b(1, 2), b(0, 2), b(0, 1)};
          }}});
  if (scene.lists(Plasticity::name)) add({{"J_P", field::PlasticVolumeRatio::name, [](P p) { return Numbers{p.J_P}; }}});
  if (scene.lists(Heat::name))
    add({{"theta", field::Temperature::name, [](P p) { return Numbers{p.theta}; }},
         {"peak theta", field::PeakTemperature::name, [](P p) { return Numbers{p.theta_peak}; }}});
  if (scene.lists(Water::name)) add({{"m_w", field::WaterMass::name, [](P p) { return Numbers{p.m_w}; }}});
  if (scene.lists(Leavening::name))
    add({{"nu", field::ProducedGas::name, [](P p) { return Numbers{p.nu}; }},
         {"leavener", field::Leavener::name, [](P p) { return Numbers{p.c}; }}});
  return all;
}

/// A field of all particles, each particle's numbers together.
Numbers in_order(const std::vector<textbook::Particle>& particles, const ComparedField& field) {
  Numbers all;
  for (const textbook::Particle& p : particles)
    for (const double number : field.of(p)) all.push_back(number);
  return all;
}

Numbers in_order(const std::vector<Vector3>& vectors) {
  Numbers all;
  for (const Vector3& v : vectors) all.insert(all.end(), v.begin(), v.end());
  return all;
}

/// Positions or velocities of the vertices of all skins.
Numbers in_order(const std::vector<textbook::Skin>& skins, textbook::Vector textbook::Vertex::*of) {
  Numbers all;
  for (const textbook::Skin& skin : skins)
    for (const textbook::Vertex& p : skin.vertices) all.insert(all.end(), {(p.*of)[0], (p.*of)[1], (p.*of)[2]});
  return all;
}

FieldDifference compare(const char* field, const Numbers& other, const Numbers& textbook) {
  FieldDifference d{field};
  for (std::size_t i = 0; i < textbook.size(); ++i) {
    const double difference = std::abs(other[i] - textbook[i]);
    d.largest = std::max(d.largest, std::isnan(difference) ? k_infinity : difference);
    d.scale = std::max(d.scale, std::abs(textbook[i]));
  }
  return d;
}

}  // namespace

double worst(const std::vector<FieldDifference>& differences) {
  double largest = 0;
  for (const FieldDifference& d : differences) largest = d.relative() <= largest ? largest : d.relative();
  return largest;
}

SideBySide::SideBySide(const Scene& scene, bool with_twin)
    : scene_(with_exact_conduction(scene)), solver_(Simulation::begin(scene_)), baker_(recipe_of(scene_)) {
  if (with_twin) twin_.emplace(recipe_of(scene_));
  const std::vector<NewParticle> particles = fill_bodies(scene_);
  for (const NewParticle& p : particles) add(p);
  const std::vector<MadeSkin> skins = make_skins(scene_);
  const std::vector<NewParticle> vertices = vertices_of(scene_, skins, particles);
  cover(scene_, skins, vertices, baker_);
  if (twin_) cover(scene_, skins, vertices, *twin_);
  next_id_ += static_cast<std::int64_t>(vertices.size());
  for (std::size_t i = 0; i < scene_.emitters.size(); ++i)
    emitters_.push_back(std::make_unique<EmitterState>(scene_, scene_.emitters[i], i));
  pour_due();
  step_textbook(0, 0);
}

void SideBySide::add(const NewParticle& particle) {
  const textbook::Beginning beginning = beginning_of(scene_, particle, next_id_++);
  baker_.add(beginning);
  if (twin_) twin_->add(beginning);
}

void SideBySide::pour_due() {
  for (const auto& emitter : emitters_)
    while (emitter->next_time() <= solver_->time())
      for (const NewParticle& p : emitter->pour()) add(p);
}

void SideBySide::step_textbook(double dt, double begin) {
  const textbook::Surroundings surroundings = surroundings_of(scene_, begin, dt);
  baker_.step(dt, surroundings);
  if (!twin_) return;
  twin_->round_to_single();
  twin_->step(dt, surroundings);
}

bool SideBySide::step() {
  const double begin = solver_->time(), dt = solver_->dt();
  if (!(dt > 0) || begin >= scene_.run.end_s) return false;
  last_dt_ = dt;
  solver_->advance(begin + dt, scene_.run.end_s);
  step_textbook(dt, begin);
  pour_due();
  return true;
}

template <class NumbersOf>
std::vector<FieldDifference> SideBySide::from_textbook(NumbersOf numbers_of, const Numbers& skin_positions,
                                                       const Numbers& skin_velocities) const {
  std::vector<FieldDifference> all;
  double strain_of_a_step = 0;  // whose round-off the strain of a stiff body has
  for (const ComparedField& field : fields_of(scene_)) {
    all.push_back(compare(field.name, numbers_of(field), in_order(baker_.particles(), field)));
    double& scale = all.back().scale;
    if (all.back().field == "velocity") {
      // Stresses that cancel leave round-off, which moves particles at about epsilon times the wave speed, and that is below dx / dt.
      scale = std::max(scale, 1e-4 * scene_.dx() / last_dt_);
      strain_of_a_step = last_dt_ * scale / scene_.dx();
    }
    if (all.back().field == "b_E - I") scale = std::max(scale, strain_of_a_step);
  }
  if (scene_.skins.empty()) return all;
  const double speed = all[1].scale;
  all.push_back(compare("skin position", skin_positions, in_order(baker_.skins(), &textbook::Vertex::x)));
  all.push_back(compare("skin velocity", skin_velocities, in_order(baker_.skins(), &textbook::Vertex::v)));
  all.back().scale = std::max(all.back().scale, speed);
  return all;
}

std::vector<FieldDifference> SideBySide::differences() const {
  const Snapshot s = solver_->snapshot();
  const auto& particles = baker_.particles();
  const bool same = std::equal(s.id.begin(), s.id.end(), particles.begin(), particles.end(),
                               [](std::int64_t id, const textbook::Particle& p) { return id == p.id; });
  if (!same) return {{"particles", k_infinity, 1}};
  const std::optional<Mesh> skin = solver_->skin_mesh(solver_->frame());
  return from_textbook(
      [&](const ComparedField& field) {
        if (*field.column) return s[field.column];
        return in_order(std::string_view(field.name) == "position" ? s.position : s.velocity);
      },
      skin ? skin->points : Numbers{}, skin ? skin->find("velocity")->values : Numbers{});
}

std::vector<FieldDifference> SideBySide::differences_of_twin() const {
  if (twin_->particles().size() != baker_.particles().size()) return {{"particles", k_infinity, 1}};
  return from_textbook([&](const ComparedField& field) { return in_order(twin_->particles(), field); },
                       in_order(twin_->skins(), &textbook::Vertex::x), in_order(twin_->skins(), &textbook::Vertex::v));
}

double SideBySide::textbook_bytes(const Scene& scene) { return textbook::Baker::bytes(recipe_of(scene)); }

}  // namespace bake
