// SPDX-License-Identifier: MIT
// The skins of a run: elastic sheets of triangles whose vertices are particles. [Ding19 Sec. 7.1; Jiang et al. 2015]
//
// A vertex moves with the grid, x_p = sum w x_i, and so the grid feels the force on it as -dE/dx_i = sum_p w f_p. Forces need all corners
// of an element at the new time, which is when the pass has ended. They are added then, dt w f_p, to what the pass scattered for the next
// step.
//
// Elements write what they do to their corners into slots, and each vertex sums its own in the order of the mesh: the same bits for any
// number of threads.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/boundary/surface_mesh.h"
#include "solver/grid/grid.h"
#include "solver/grid/particle_store.h"
#include "solver/io/checkpoint.h"
#include "solver/scene/scene.h"

namespace bake {

/// Sums over the skins.
struct SkinSums {
  double membrane = 0;  ///< energy of the membrane [J]
  double bending = 0;   ///< energy of the hinges [J]
  double area = 0;      ///< of the triangles [m^2]
};

/// How a vertex stands.
struct SkinVertexState {
  double area_ratio = 1;  ///< area of its triangles over that at rest
  double curvature = 0;   ///< sqrt(2 e / B), e being the bending energy per area of its hinges: 1/R of a rolled cylinder [1/m]
};

template <class Real>
class Sheets {
 public:
  /// The column in which vertices keep the area of surface that they cover over their own: that of the ratio of volumes, which they have
  /// not.
  static constexpr const char* k_cover = "volume_ratio";

  /// `meshes`: of the scene's skins, in which they are at rest; `first_identity`: of the first vertex, all others follow it.
  Sheets(const Scene& scene, std::vector<SurfaceMesh> meshes, std::int64_t first_identity);

  /// Finds the vertices in the store, which must be done after each sorting. A skin is torn where vertices have left the domain.
  void find_vertices(const ParticleStore<Real>& store);
  /// Reads where the vertices are, and finds the forces on them. `sums_wanted`: and the sums.
  void find_forces(const ParticleStore<Real>& store, const GridGeometry& geometry, bool sums_wanted);

  const std::vector<SurfaceMesh>& meshes() const { return meshes_; }  ///< at rest
  std::int64_t first_identity() const { return first_identity_; }
  std::size_t vertices() const { return position_.size(); }
  std::size_t vertices_left() const;  ///< that are still in the domain
  bool is_left(std::size_t vertex) const { return is_left_[vertex]; }
  /// The tiles of a home block that hold vertices.
  struct Tiles {
    std::int32_t first, end;
  };
  const Tiles& tiles_of(std::size_t home_block) const { return tiles_[home_block]; }
  const Vector3& position(std::size_t vertex) const { return position_[vertex]; }  ///< as of the last find_forces [m]
  /// The force on a vertex [N].
  const Real* force(std::size_t vertex) const { return &force_[3 * vertex]; }
  const SkinSums& sums() const { return sums_; }  ///< at the last find_forces that was asked for them
  std::vector<SkinVertexState> vertex_states() const;

  void write(CheckpointWriter& out) const;
  /// The same skins as were written. Throws InputError.
  static Sheets read(const Scene& scene, const CheckpointReader& in);

 private:
  using V = Lanes<Real>;
  static constexpr std::size_t W = k_width<Real>;

  /// Elements with n corners: of each, whose they are and to which slot the force on them goes.
  struct Elements {
    std::size_t count = 0, corners = 0;      ///< elements, without those that fill the last pack
    std::vector<std::int32_t> vertex, slot;  ///< [corner][element]
    std::vector<Real> constants;             ///< [constant][element]
    std::size_t padded() const { return (count + W - 1) / W * W; }
  };
  static Elements in_columns(const std::vector<std::vector<std::int32_t>>& vertices, const std::vector<std::vector<double>>& constants);
  void give_slots();
  void tear();
  template <std::size_t corners>
  void differences(const Elements& elements, std::size_t first, V (&d)[corners - 1][3]) const;
  template <std::size_t corners>
  void put_forces(const Elements& elements, std::size_t first, const V (&force)[corners - 1][3]);
  static V constants_of(const Elements& elements, std::size_t constant, std::size_t first);
  void act_triangles(std::size_t first, SkinSums* sums);
  void act_hinges(std::size_t first, SkinSums* sums);

  std::vector<SurfaceMesh> meshes_;
  std::int64_t first_identity_;
  std::vector<Vector3> position_;  ///< of the vertices [m]
  std::vector<char> is_left_;
  std::vector<Tiles> tiles_;  ///< of the home blocks
  Elements triangles_, hinges_;
  std::vector<std::size_t> first_slot_;  ///< of a vertex; its slots end where the next one's begin
  std::vector<Real> slots_;              ///< [slot][3]; two more than the vertices have, for elements that only fill a pack
  std::vector<Real> force_;              ///< [vertex][3]
  std::vector<SkinSums> partial_;
  SkinSums sums_;
};

extern template class Sheets<float>;
extern template class Sheets<double>;

}  // namespace bake
