// SPDX-License-Identifier: MIT
// Bodies that turn on the page: what bake figure made of a few frames of a run, packed.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/report/pack.h"

namespace bake::report {

/// A body as the page carries it: `head` tells viewer.js where each piece stands in `bytes`, and what it means.
struct PackedBody {
  nlohmann::json head;
  Bytes bytes;
};

/// Packs the bodies of an object, one in each folder with surface_<frame>.hdf, particles_<frame>.hdf and look.json. All share one cube and
/// one range of each field, so that sizes and colours can be compared. `particles`: these can be shown, too. Throws InputError if a file is
/// missing or damaged.
std::vector<PackedBody> packed_bodies(const std::vector<std::filesystem::path>& folders, bool particles);

}  // namespace bake::report
