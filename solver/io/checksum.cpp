// SPDX-License-Identifier: MIT
#include "solver/io/checksum.h"

#include <array>
#include <bit>
#include <cstring>

namespace bake {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint64_t k_prime_1 = 0x9E3779B185EBCA87;
constexpr std::uint64_t k_prime_2 = 0xC2B2AE3D27D4EB4F;
constexpr std::uint64_t k_prime_3 = 0x165667B19E3779F9;
constexpr std::uint64_t k_prime_4 = 0x85EBCA77C2B2AE63;
constexpr std::uint64_t k_prime_5 = 0x27D4EB2F165667C5;

template <class Word>
std::uint64_t take(std::span<const std::byte>& bytes) {
  Word word;
  std::memcpy(&word, bytes.data(), sizeof word);
  bytes = bytes.subspan(sizeof word);
  return word;
}

std::uint64_t mixed(std::uint64_t state, std::uint64_t word) { return std::rotl(state + word * k_prime_2, 31) * k_prime_1; }

/// Processes the bulk in four independent states, 32 bytes at a time.
std::uint64_t take_stripes(std::span<const std::byte>& bytes, std::uint64_t seed) {
  std::array<std::uint64_t, 4> states{seed + k_prime_1 + k_prime_2, seed + k_prime_2, seed, seed - k_prime_1};
  while (bytes.size() >= 32) {
    for (auto& state : states) state = mixed(state, take<std::uint64_t>(bytes));
  }
  auto hash = std::rotl(states[0], 1) + std::rotl(states[1], 7) + std::rotl(states[2], 12) + std::rotl(states[3], 18);
  for (const auto state : states) hash = (hash ^ mixed(0, state)) * k_prime_1 + k_prime_4;
  return hash;
}

std::uint64_t take_rest(std::span<const std::byte> bytes, std::uint64_t hash) {
  while (bytes.size() >= 8) hash = std::rotl(hash ^ mixed(0, take<std::uint64_t>(bytes)), 27) * k_prime_1 + k_prime_4;
  if (bytes.size() >= 4) hash = std::rotl(hash ^ (take<std::uint32_t>(bytes) * k_prime_1), 23) * k_prime_2 + k_prime_3;
  while (!bytes.empty()) hash = std::rotl(hash ^ (take<std::uint8_t>(bytes) * k_prime_5), 11) * k_prime_1;
  return hash;
}

/// Mixes the result, so that every bit of the input affects every bit of it.
std::uint64_t avalanched(std::uint64_t hash) {
  hash = (hash ^ (hash >> 33)) * k_prime_2;
  hash = (hash ^ (hash >> 29)) * k_prime_3;
  return hash ^ (hash >> 32);
}

}  // namespace

std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t seed) {
  const auto size = bytes.size();
  const auto start = size >= 32 ? take_stripes(bytes, seed) : seed + k_prime_5;
  return avalanched(take_rest(bytes, start + size));
}

}  // namespace bake
