// SPDX-License-Identifier: MIT
// Where the dough ends: the area of the free surface at the nodes.
//
//     phi_i = V_i / dx^3;  phi~ = B phi                        B: separable (1, 2, 1)/4
//     psi_i = clamp((phi~_i - 0.2) / 0.6, 0, 1)                takes out the noise inside
//     S_i   = |grad psi|_i dx^3                                central differences, (1, 6, 1)/8 across
//     r_i   = S_i / (phi~_i dx^3);  r <- B^T r
//     K_i   = dx (k_1 + k_2) = -dx div(grad phi~ / |grad phi~|) = -dx (tr H - n.H n) / |grad phi~|, averaged with r
//     A_i   = V_i r_i (1 + min(c K_i^2, 0.5)                   puts back what smoothing took off curved surfaces
//                        + min(9 max(E_i, 0), 1))            and off edges: E = <K^2> - <K>^2 - 0.01 - 0.03 <K>^4, averaged with r
// The last term is for air only, and fades from 2.5 to 1.5 dx before a solid (k_ends): where dough meets one is a corner of both, no edge.
// Beside a collider the dough fills what it is left: there phi~ is divided by that room, so that a free face goes on straight to the wall
// and only what lies outside of the wall counts. Faces that colliders cover are measured without.
// B^T only moves area onto nodes in proportion to the dough they carry, so that heat and vapour leave from where there is dough. Second
// order for smooth bodies; rounding takes 0.6 dx of area per length off edges, nearly all of which is put back.
// DEPARTS [Ding19 Sec. 6.6]: the printed quadrature over boundary particles finds 25 to 40 % of a sphere, whatever dx.
// DEPARTS [Ding19 Sec. 6.2-6.4]: fluxes through the surface are taken at the nodes, from the temperature and saturation of the
// same step, and not at particles from those of the last: one smoothing less, and the heat transfer can be implicit.
#pragma once

#include <array>
#include <functional>

#include "solver/core/surface_layer.h"
#include "solver/engine/contacts.h"
#include "solver/grid/grid.h"
#include "solver/scene/settings.h"

namespace bake {

/// What the surroundings do at the nodes of one block.
template <class Real>
struct BlockSurroundings {
  alignas(64) Real area[k_block_nodes];                  ///< free, touching air [m^2]
  alignas(64) Real heat_transfer[k_block_nodes];         ///< sum of area times beta [W/K]
  alignas(64) Real heat_transfer_source[k_block_nodes];  ///< sum of area times beta times theta_out [W]
  alignas(64) Real contact_area[k_block_nodes];          ///< touching a solid [m^2]
};

/// The air of a step.
struct Air {
  double heat_transfer_coefficient = 0;  ///< beta [W/(m^2 K)]
  double temperature = 0;                ///< theta_out [C]
  double saturation = 0;                 ///< s_out
};

template <class Real>
class FreeSurfaceMeasure {
 public:
  using Nodes = std::array<Real, k_block_nodes>;
  /// Where volumes V_i stand among the scattered rows, and the conductivities of the layer that resists heat (-1: none).
  struct Rows {
    const Real* numbers;
    int size, volume_channel, conductivity_channel;
  };
  /// Measures from the volumes V_i. Parallel over blocks, same bits for any number of threads.
  void measure(const Rows& rows, const SurfaceLayer<Real>& layer, double rounding, const ActiveBlocks& active, const GridGeometry& geometry,
               const Contacts& contacts);
  /// Takes the volumes of now and leaves A_i / V_i as it was measured, of the same active blocks.
  void follow(const Rows& rows, const ActiveBlocks& active);
  /// Measures as then, from the volumes of then.
  void measure_again(std::vector<Nodes> volumes, const SurfaceLayer<Real>& layer, double rounding, const ActiveBlocks& active,
                     const GridGeometry& geometry, const Contacts& contacts);
  /// Those of the last `measure` or `follow`, by slots of the active blocks.
  const std::vector<Nodes>& volumes() const { return volume_; }
  /// [Ding19 Sec. 6.6] as printed: every node with mass that has a neighbour without appends the particle nearest to it, and each
  /// such particle stands for a disc of pi r^2, (4/3) pi r^3 = V. Serial: for studies of small scenes.
  template <KernelOrder order>
  void measure_published(const ParticleStore<Real>& store, const Real* rows, int row_size, int volume_channel, int ratio_column,
                         int volume_column, const ActiveBlocks& active, const GridGeometry& geometry, const Contacts& contacts,
                         const Air& air);
  std::size_t bytes() const {
    return volume_.capacity() * (8 * sizeof(Nodes) + sizeof(Block)) + published_.capacity() * sizeof(BlockSurroundings<Real>);
  }
  /// What surrounds a block after either `measure`, or false if no surface is near. `air`: as given to measure_published.
  bool surround(std::size_t slot, const Air& air, BlockSurroundings<Real>& surroundings) const;
  /// Calls visit(giver, node, heat transfer [W/K], its source [W]) for the part of either that single givers (ContactHeat) have at the
  /// nodes of a block, as long as the last measure holds.
  void tell(std::size_t slot, const ActiveBlocks& active, const std::function<void(int, int, double, double)>& visit) const;

 private:
  static constexpr Real k_full = Real(0.8), k_no_dough = Real(1e-3);  ///< values of phi~
  /// Of a face that ends at a solid K^2 counts less, by so much of the room that is missing: nothing within 1.5 dx.
  static constexpr Real k_ends = 24;
  static constexpr double k_least_room = 0.05, k_reach = Survey::k_reach;  ///< of room(), and of what covers a surface

  struct Block {
    bool has_volume = false, is_mirrored = false, is_full = false, is_empty = false, is_beside = false, has_density = false,
         has_area = false, faces_air = false;
  };
  /// A solid in front of nodes of a block.
  struct Cover {
    ContactHeat heat;
    Nodes density, bend;  ///< r and r K of those nodes
  };
  /// Nodes of a block before which one giver stands.
  struct Share {
    int giver;
    ContactHeat heat;
    Nodes density;  ///< r of those nodes
  };
  /// What a solid covers at the nodes of a block.
  struct Facing {
    ContactHeat heat;
    Nodes per_volume;  ///< A_i / V_i
  };
  /// Areas of a block's nodes [m^2], and what passes through them: heat transfer [W/K] and its source [W].
  struct Passing {
    Nodes area, transfer, source;
  };
  const Nodes* of_cover(std::size_t slot, const ContactHeat& heat, Nodes Cover::*nodes) const;
  template <class FieldOf>
  bool blurred(std::size_t slot, const ActiveBlocks& active, FieldOf field_of, Nodes& out) const;
  /// From the areas per volume. The layer between the nodes and the surface conducts as well.
  void pass(std::size_t slot, const ContactHeat& heat, const Nodes& per_volume, Passing& out) const;
  void take_volumes(const Rows& rows, const ActiveBlocks& active);
  void find(const ActiveBlocks& active, const GridGeometry& geometry, const Contacts& contacts);
  void mirror(std::size_t slot, const ActiveBlocks& active, const GridGeometry& geometry, const Contacts& contacts);
  void smooth(std::size_t slot, const ActiveBlocks& active, const GridGeometry& geometry, const Contacts& contacts);
  void find_density(std::size_t slot, const ActiveBlocks& active, const GridGeometry& geometry, const Contacts& contacts);
  void find_areas(const ActiveBlocks& active);
  void find_area(std::size_t slot, const ActiveBlocks& active);

  std::vector<Block> blocks_;
  std::vector<Nodes> volume_, mirrored_;
  std::vector<Nodes> smooth_;        ///< phi~; once r is found and nothing asks for it any more, A_i / V_i of the air
  std::vector<Nodes> filled_;        ///< phi~ over the room, of blocks near a collider (is_beside)
  std::vector<Nodes> conductivity_;  ///< sum of w V kappa; empty if no layer resists heat
  SurfaceLayer<Real> layer_;
  double rounding_ = 0;
  std::vector<Nodes> density_, bend_, edge_;  ///< r, r K and r K^2 of nodes that touch air
  std::vector<std::vector<Cover>> covers_;
  std::vector<ContactHeat> heats_;           ///< of all covers, each once
  std::vector<std::vector<Facing>> facing_;  ///< solids, in the order of heats_
  std::vector<std::vector<Share>> shares_;   ///< of those covers that a giver has
  std::vector<BlockSurroundings<Real>> published_;
  std::vector<std::array<int, k_block_nodes>> published_givers_;  ///< -1: none
};

extern template class FreeSurfaceMeasure<float>;
extern template class FreeSurfaceMeasure<double>;

}  // namespace bake
