// SPDX-License-Identifier: MIT
#include "solver/scene/nearest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace bake {
namespace {

constexpr std::size_t k_longest_word = 80;  // longer ones resemble nothing, and are not worth the time

bool same_letter(char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b)); }

/// Optimal string alignment distance.
std::size_t edits(std::string_view from, std::string_view to) {
  std::vector<std::vector<std::size_t>> cost(from.size() + 1, std::vector<std::size_t>(to.size() + 1));
  for (std::size_t i = 0; i <= from.size(); ++i) cost[i][0] = i;
  for (std::size_t j = 0; j <= to.size(); ++j) cost[0][j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = cost[i - 1][j - 1] + (same_letter(from[i - 1], to[j - 1]) ? 0 : 1);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && same_letter(from[i - 1], to[j - 2]) && same_letter(from[i - 2], to[j - 1]);
      if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  }
  return cost[from.size()][to.size()];
}

/// "density" of "density_kg_per_m3": the unit was forgotten.
bool is_stem_of(std::string_view word, std::string_view candidate) {
  return candidate.size() > word.size() && candidate.substr(0, word.size()) == word && candidate[word.size()] == '_';
}

}  // namespace

std::string nearest(std::string_view word, std::vector<std::string> known, const FormerNames& former) {
  if (word.size() > k_longest_word) return {};
  for (const auto& [old, name] : former) known.push_back(old);
  std::string best;
  std::size_t fewest = 2 + word.size() / 4;
  for (const std::string& candidate : known) {
    const std::size_t needed = is_stem_of(word, candidate) ? 1 : edits(word, candidate);
    const bool resembles = needed < std::max(word.size(), candidate.size());
    if (resembles && needed < fewest) {
      fewest = needed;
      best = candidate;
    }
  }
  const auto renamed = former.find(best);
  return renamed == former.end() ? best : renamed->second;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known, const FormerNames& former) {
  const std::string guess = nearest(word, known, former);
  if (!guess.empty()) return fmt::format("did you mean '{}'?", guess);
  return known.empty() ? "allowed: none" : fmt::format("allowed: {}", fmt::join(known, ", "));
}

}  // namespace bake
