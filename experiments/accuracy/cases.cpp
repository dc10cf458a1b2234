// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/accuracy/case.h"
#include "solver/core/errors.h"

namespace bake::studies::accuracy {

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases{
      heated_slab(), cooling_sphere(), barenblatt(), elastic_bar(), vortex(), drying_cube(), dough_pull(), rising_ball(), cookie(), bread(),
  };
  return cases;
}

const Case& find_case(const std::string& name) {
  const auto& all = all_cases();
  const auto at = std::find_if(all.begin(), all.end(), [&](const Case& c) { return c.name == name; });
  if (at != all.end()) return *at;
  std::vector<std::string> known;
  known.reserve(all.size());
  for (const Case& c : all) known.push_back(c.name);
  throw InputError(fmt::format("--case: found \"{}\", allowed: {}", name, fmt::join(known, ", ")));
}

}  // namespace bake::studies::accuracy
