// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace bake {

/// XXH64 of `bytes` (Yann Collet's xxHash, little-endian machines): finds any accidental change at memory speed; no protection
/// against intent. Long data can be taken in pieces by giving each the checksum of the one before as `seed`.
std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t seed = 0);

}  // namespace bake
