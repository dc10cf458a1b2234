// SPDX-License-Identifier: MIT
// The solver and the textbook baker on the same scene, with the same steps: how far do they come apart?
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/textbook/baker.h"
#include "solver/run/fill_scene.h"
#include "solver/run/simulation.h"

namespace bake {

/// The largest difference in one field of the particles, over all particles and components.
struct FieldDifference {
  std::string field;
  double largest = 0;  ///< difference, in the field's unit
  double scale = 0;    ///< largest magnitude of the field in the textbook, or of what it is the small difference of
  double relative() const { return largest > 0 ? largest / scale : 0; }
};

double worst(const std::vector<FieldDifference>& differences);

class SideBySide {
 public:
  /// Fills the scene and takes the step of no time. `with_twin`: a second textbook baker goes along that differs in one thing only: before
  /// every step all that its particles carry is rounded to single precision. Throws InputError.
  explicit SideBySide(const Scene& scene, bool with_twin = false);

  /// One step of both, as long as the solver chooses; nothing is left to do (false) at the end of the scene.
  bool step();
  const Simulation& solver() const { return *solver_; }
  /// Position, velocity and whatever else the scene's effects keep. Infinite if the particles are not the same ones.
  std::vector<FieldDifference> differences() const;
  /// How far the twin, which there must be, has come from the textbook: what the scene makes of one rounding of each number in each step.
  std::vector<FieldDifference> differences_of_twin() const;

  /// Memory that the textbook's dense grid needs for a scene [bytes].
  static double textbook_bytes(const Scene& scene);

 private:
  void add(const NewParticle& particle);
  void pour_due();
  void step_textbook(double dt, double begin);
  template <class NumbersOf>
  std::vector<FieldDifference> from_textbook(NumbersOf numbers_of) const;

  const Scene scene_;
  std::unique_ptr<Simulation> solver_;
  textbook::Baker baker_;
  std::optional<textbook::Baker> twin_;
  std::vector<std::unique_ptr<EmitterState>> emitters_;
  std::int64_t next_id_ = 0;
  double last_dt_ = k_infinity;
};

}  // namespace bake
