// SPDX-License-Identifier: MIT
#include "analysis/claims/blessing.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "solver/core/errors.h"
#include "solver/scene/entry.h"

namespace bake::cli {
namespace {

/// The output of a git command in the sources. Throws InputError if git fails.
std::string git(const std::string& arguments) {
  const std::string command = fmt::format("git -C '{}' {} 2>/dev/null", BAKE_SOURCE_DIR, arguments);
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 256> part;
  while (pipe && fgets(part.data(), part.size(), pipe)) text += part.data();
  if (!pipe || pclose(pipe) != 0) throw InputError("bless: git cannot tell the commit of the sources, allowed: a clone with git");
  return text;
}

}  // namespace

std::string commit_to_bless(const std::string& why) {
  if (std::getenv("CI")) throw InputError("bless: found CI in the environment, allowed: use by a person, not by continuous integration");
  if (why.find_first_not_of(" \t") == std::string::npos) throw InputError("--why: found nothing, allowed: the reason for the new numbers");
  if (const std::string changes = git("status --porcelain"); !changes.empty())
    throw InputError("bless: found uncommitted changes, allowed: a clean tree, so that the new numbers belong to a commit");
  return git("rev-parse HEAD").substr(0, 40);
}

std::string bless_claims(const std::string& text, const Blessing& blessing) {
  constexpr const char* k_heading = "\n[blessed]\n";
  const toml::table file = parse_toml(text, "claims.toml");
  std::vector<std::string> lines;
  for (std::istringstream in(text.substr(0, text.find(k_heading))); std::getline(in, lines.emplace_back());) continue;
  for (std::size_t i = blessing.expected.size(); i-- > 0;) {  // from the end, so that places before it stay what they are
    if (!blessing.expected[i]) continue;
    if (!std::isfinite(*blessing.expected[i]))
      throw InputError(fmt::format("claims.toml: claim.{}.expected: found {}, allowed: a finite number", i, *blessing.expected[i]));
    const toml::source_region& place = file["claim"][i]["expected"].node()->source();
    lines[place.begin.line - 1].replace(place.begin.column - 1, place.end.column - place.begin.column,
                                        fmt::format("{}", *blessing.expected[i]));
  }
  return fmt::format("{}{}why = {}\ncommit = \"{}\"\n", fmt::join(lines, "\n"), k_heading, nlohmann::json(blessing.why).dump(),
                     blessing.commit);
}

}  // namespace bake::cli
