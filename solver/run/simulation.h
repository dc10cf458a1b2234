// SPDX-License-Identifier: MIT
// A scene in motion, whatever its precision: what a run, a test or a study needs of the engine.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/engine/engine_types.h"
#include "solver/io/frames.h"
#include "solver/io/mesh_file.h"
#include "solver/scene/givers.h"

namespace bake {

class CheckpointReader;
class CheckpointWriter;
struct Scene;
struct SkinSums;

/// Everything about the particles at one time, in double and in the order of their identities.
struct Snapshot {
  std::vector<std::int64_t> id;
  std::vector<std::int32_t> material;
  std::vector<Vector3> position;  ///< [m]
  std::vector<Vector3> velocity;  ///< [m/s]; empty where nothing moves
  /// By column name (see Physics::columns); each particle's `width` numbers together.
  std::vector<std::pair<std::string, std::vector<double>>> columns;
  const std::vector<double>& operator[](std::string_view column) const&;  ///< throws std::out_of_range
  std::vector<double> operator[](std::string_view column) &&;             ///< of a snapshot that is gone afterwards
};

/// The files of a frame, to be put in place.
struct WrittenFrame {
  std::shared_ptr<AtomicFile> particles;
  std::shared_ptr<AtomicFile> skin;  ///< of scenes with skins

  void put_in_place() const {
    particles->put_in_place();
    if (skin) skin->put_in_place();
  }
};

class Simulation {
 public:
  /// Fills the scene and finds the first step, which does not go beyond `first_target` (default: the first frame). Throws InputError.
  static std::unique_ptr<Simulation> begin(const Scene& scene, std::optional<double> first_target = {});
  /// Goes on where a checkpoint stopped. Throws InputError.
  static std::unique_ptr<Simulation> resume(const Scene& scene, const CheckpointReader& checkpoint);
  virtual ~Simulation() = default;

  /// Steps until `target`, at which everything is sampled; `next_target` is where it will be asked to go then. Steps in which the dough
  /// settles come before all others and take none of the scene's time. After each step calls `after_step`; if that returns false, stops
  /// there. Returns whether the target was reached.
  virtual bool advance(
      double target, double next_target, const std::function<bool()>& after_step = [] { return true; }) = 0;
  virtual void set_force(NodalForce force) = 0;  ///< see Engine
  virtual void write(CheckpointWriter& out) const = 0;

  virtual double time() const = 0;
  virtual double dt() const = 0;
  virtual std::size_t particles() const = 0;  ///< without the vertices of skins
  virtual const Counters& counters() const = 0;
  virtual const Settling& settling() const = 0;
  // Quantities are called by what the effects declare, e.g. total(total::momentum, 2); 0 if no effect of the scene has it.
  template <class Q>
  double booked(Q, int i = 0) const {  ///< since the start
    return amount(Sum::booked, Q::symbol, i);
  }
  template <class Q>
  double total(Q, int i = 0) const {  ///< at the last sample
    return amount(Sum::total, Q::symbol, i);
  }
  template <class Q>
  double retired(Q, int i = 0) const {  ///< of the particles that left, when they left
    return amount(Sum::retired, Q::symbol, i);
  }
  template <class Q>
  double emitted(Q, int i = 0) const {  ///< of the particles that were poured, when they were
    return amount(Sum::emitted, Q::symbol, i);
  }
  template <class Q>
  double highest(Q, int i = 0) const {  ///< over the particles, at the last sample
    return amount(Sum::highest, Q::symbol, i);
  }
  template <class Q>
  double bound(Q, int i = 0) const {  ///< over the particles, in the last step
    return amount(Sum::bound, Q::symbol, i);
  }
  virtual const std::vector<Giver>& givers() const = 0;  ///< what the scene wants in the ledger one by one,
  virtual const std::vector<Given>& given() const = 0;   ///< and what each of them gave since the start
  virtual Box3 extent() const = 0;                       ///< of the particles [m]
  virtual Snapshot snapshot() const = 0;
  virtual FrameData frame() const = 0;  ///< ordered by identity, without the vertices of skins
  /// The skins, with what their vertices have: velocity, area_ratio, curvature, skin, and saturation and temperature of the flesh around.
  /// Vertices that have left the domain stay where they were seen last, and their triangles are left out. `flesh`: frame(), as of now.
  virtual std::optional<Mesh> skin_mesh(const FrameData& flesh) const = 0;
  virtual const SkinSums& skin_sums() const = 0;  ///< at the last sample; zero without skins
  void write_frame_file(const std::filesystem::path& path) const { write_frame(path, time(), frame()); }
  virtual WrittenFrame written_frame(FrameWriter& writer, const std::filesystem::path& particles,
                                     const std::filesystem::path& skin) const = 0;
  virtual std::size_t bytes() const = 0;
  virtual std::size_t active_nodes() const = 0;
  virtual std::string memory_words() const = 0;  ///< "19 columns, 76 bytes per particle; ..."
  virtual double inertia_scale() const = 0;      ///< inertial mass over mass

 protected:
  enum class Sum { booked, total, retired, emitted, highest, bound };

 private:
  virtual double amount(Sum kind, std::string_view symbol, int i) const = 0;
};

}  // namespace bake
