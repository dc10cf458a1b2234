// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace bake {

/// XXH64 of `bytes` (Yann Collet's xxHash, little-endian machines): it detects accidental changes at memory speed, but does not
/// protect against intended ones. Long data can be processed in pieces: pass the checksum of the piece before as `seed`.
std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t seed = 0);

}  // namespace bake
