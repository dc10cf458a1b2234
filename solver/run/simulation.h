// SPDX-License-Identifier: MIT
// A scene in motion, whatever its precision: what a run, a test or a study needs of the engine.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solver/effects/totals.h"
#include "solver/engine/engine_types.h"
#include "solver/io/frames.h"

namespace bake {

class CheckpointReader;
class CheckpointWriter;
struct Scene;

/// The numbers of one row of ledger.csv.
std::vector<std::string> ledger_columns();

/// Everything about the particles at one time, in double and in the order of their identities.
struct Snapshot {
  std::vector<std::int64_t> id;
  std::vector<std::int32_t> material;
  std::vector<Vector3> position;  ///< [m]
  std::vector<Vector3> velocity;  ///< [m/s]; empty where nothing moves
  /// By column name (see Physics::columns); each particle's `width` numbers together.
  std::vector<std::pair<std::string, std::vector<double>>> columns;
  const std::vector<double>& operator[](std::string_view column) const;  ///< throws std::out_of_range
};

class Simulation {
 public:
  /// Fills the scene and finds the first step. Throws InputError.
  static std::unique_ptr<Simulation> begin(const Scene& scene);
  /// Goes on where a checkpoint stopped. Throws InputError.
  static std::unique_ptr<Simulation> resume(const Scene& scene, const CheckpointReader& checkpoint);
  virtual ~Simulation() = default;

  /// Steps until `target`, at which everything is sampled; `next_target` is where it will be asked to go then. After each step
  /// calls `after_step`; if that returns false, stops there. Returns whether the target was reached.
  virtual bool advance(
      double target, double next_target, const std::function<bool()>& after_step = [] { return true; }) = 0;
  virtual void set_force(NodalForce force) = 0;  ///< see Engine
  virtual void write(CheckpointWriter& out) const = 0;

  virtual double time() const = 0;
  virtual double dt() const = 0;
  virtual std::size_t particles() const = 0;
  virtual const Counters& counters() const = 0;
  virtual const Budget& booked() const = 0;
  virtual const Totals& totals() const = 0;                    ///< at the last sample
  virtual const Totals& retired() const = 0;                   ///< of the particles that left, when they left
  virtual const Totals& emitted() const = 0;                   ///< of the particles that were poured, when they were
  virtual std::pair<double, double> temperatures() const = 0;  ///< lowest and highest, at the last sample
  virtual Snapshot snapshot() const = 0;
  virtual std::vector<double> ledger_row() const = 0;
  virtual void write_frame_file(const std::filesystem::path& path) const = 0;
  virtual std::size_t bytes() const = 0;
  virtual std::size_t active_nodes() const = 0;
  virtual std::string memory_words() const = 0;  ///< "19 columns, 76 bytes per particle; ..."
};

}  // namespace bake
