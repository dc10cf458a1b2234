// SPDX-License-Identifier: MIT
// Runs the solver and the textbook baker on the same scene with the same steps, and measures how far their results differ.
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
  /// Fills the scene and takes the first step, which has no duration. `with_twin`: runs a second textbook baker as well, which differs only
  /// in that the state of its particles is rounded to single precision before every step. Throws InputError.
  explicit SideBySide(const Scene& scene, bool with_twin = false);

  /// Takes one step with both; the solver chooses its length. Returns false at the end of the scene, when nothing is left to do.
  bool step();
  const Simulation& solver() const { return *solver_; }
  /// The differences in position, velocity and all other fields of the scene's effects. Infinite if the particles are not the same.
  std::vector<FieldDifference> differences() const;
  /// How far the twin, which must exist, differs from the textbook: the effect of rounding each number once in each step.
  std::vector<FieldDifference> differences_of_twin() const;

  /// Memory that the textbook's dense grid needs for a scene [bytes].
  static double textbook_bytes(const Scene& scene);

 private:
  void add(const NewParticle& particle);
  void pour_due();
  void step_textbook(double dt, double begin);
  template <class NumbersOf>
  std::vector<FieldDifference> from_textbook(NumbersOf numbers_of, const std::vector<double>& skin_positions,
                                             const std::vector<double>& skin_velocities) const;

  const Scene scene_;
  std::unique_ptr<Simulation> solver_;
  textbook::Baker baker_;
  std::optional<textbook::Baker> twin_;
  std::vector<std::unique_ptr<EmitterState>> emitters_;
  std::int64_t next_id_ = 0;
  double last_dt_ = k_infinity;
};

}  // namespace bake
