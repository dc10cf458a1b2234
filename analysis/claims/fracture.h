// SPDX-License-Identifier: MIT
// Reads the cracks and pieces that `bake-mesh fracture` found from its fracture.json.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "solver/core/parameter.h"

namespace bake {

/// A body's cracks and pieces, frame by frame.
struct Fracture {
  /// A connected set of broken edges.
  struct Crack {
    double area_m2 = 0, length_m = 0;
    Vector3 centre_m{};  ///< its centre in the reference mesh
  };
  /// A connected part of the body, with its surface.
  struct Piece {
    double volume_m3 = 0;
    bool closed = false;  ///< its surface is a closed manifold
  };
  struct Frame {
    double time_s = 0, crack_area_m2 = 0;
    double volume_m3 = 0;      ///< of all pieces
    double cut_volume_m3 = 0;  ///< volume of all pieces in the reference mesh
    std::vector<Crack> cracks;
    std::vector<Piece> pieces;
  };

  std::filesystem::path file;
  double mesh_volume_m3 = 0;  ///< of the reference mesh
  std::vector<Frame> frames;

  /// The frame nearest to a time, the last one if none is given. Throws NoNumber if that is more than half the way between two frames off,
  /// if a number of the frame is not finite, or if it is empty: no piece, or a body or mesh without volume.
  const Frame& at(std::optional<double> time_s) const;
};

/// A number that is null becomes NaN, for which JSON has no other word. Throws InputError if the file is missing or bake-mesh did not
/// write it.
Fracture read_fracture(const std::filesystem::path& file);

}  // namespace bake
