// SPDX-License-Identifier: MIT
#include "tests/count/instructions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "solver/core/errors.h"
#include "solver/io/atomic_file.h"
#include "solver/io/child.h"
#include "solver/io/provenance.h"
#include "solver/io/scratch_folder.h"

namespace bake::count {
namespace {

namespace fs = std::filesystem;

/// What stands behind a word at the start of a line; "" if there is no such line.
std::string line_after(const fs::path& file, const std::string& word) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(word)) return line.substr(word.size());
  return "";
}

/// Sum over the functions that stand in `program` itself, of a file of callgrind without compression: "ob=<file>" begins an object's
/// functions, lines that begin with a number have a function's own cost, but that after "calls=" has the cost of what was called.
double own_instructions(const fs::path& file, const fs::path& program) {
  std::ifstream in(file);
  bool ours = false, of_call = false;
  double sum = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("ob=")) ours = line.substr(3) == program.string();
    const bool is_cost = !line.empty() && line.front() >= '0' && line.front() <= '9';
    if (is_cost && ours && !of_call) sum += std::stod(line.substr(line.find(' ')));
    of_call = line.starts_with("calls=");
  }
  return sum;
}

double count_of(const Counts& counts, const std::string& name) {
  const auto found = std::find_if(counts.begin(), counts.end(), [&](const auto& c) { return c.first == name; });
  return found == counts.end() ? 0 : found->second;
}

}  // namespace

Counts count_instructions(const fs::path& program) {
  if (std::system("command -v valgrind >/dev/null 2>&1") != 0)
    throw InputError("count: found no valgrind, allowed: with Debian's package valgrind");
  const ScratchFolder scratch;
  const fs::path log = scratch / "log";
  const ChildEnd end = run_child({"valgrind", "--tool=callgrind", "--instr-atstart=no", "--compress-strings=no", "--compress-pos=no",
                                  fmt::format("--callgrind-out-file={}", (scratch / "counts").string()), program.string(), "steps"},
                                 log);
  if (end.exit_code != 0) throw std::runtime_error(fmt::format("valgrind ended with {}: {}", end.exit_code, line_after(log, "==")));
  Counts counts;
  for (int part = 1; fs::exists(scratch / fmt::format("counts.{}", part)); ++part) {
    const fs::path file = scratch / fmt::format("counts.{}", part);
    const std::string name = line_after(file, "desc: Trigger: Client Request: ");
    if (!name.empty()) counts.emplace_back(name, own_instructions(file, program));
  }
  if (counts.empty() || counts.front().second == 0) throw std::runtime_error("valgrind has counted nothing");
  return counts;
}

Stored read_stored(const fs::path& file) {
  std::ifstream in(file);
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object() || !json.contains("instructions") || !json["instructions"].is_object() || !json.contains("compiler") ||
      !json["compiler"].is_string())
    throw InputError(fmt::format("{}: found no counts, allowed: a file that `./bake count bless` has written", file.string()));
  Stored stored{json["compiler"], {}};
  for (const auto& [name, count] : json["instructions"].items()) {
    if (!count.is_number() || !(count.get<double>() > 0))
      throw InputError(fmt::format("{}: {}: found {}, allowed: a number above 0", file.string(), name, count.dump()));
    stored.counts.emplace_back(name, count.get<double>());
  }
  return stored;
}

void write_stored(const fs::path& file, const Counts& counts, const std::string& why, const std::string& commit) {
  nlohmann::ordered_json instructions;
  for (const auto& [name, count] : counts) instructions[name] = static_cast<std::int64_t>(count);
  const nlohmann::ordered_json all{
      {"compiler", this_compiler()}, {"instructions", instructions}, {"blessed", {{"why", why}, {"commit", commit}}}};
  write_text_atomically(file, all.dump(2) + "\n");
}

std::string this_compiler() {
  const std::string full = provenance()["program"]["compiler"];
  return full.substr(0, full.find('.'));
}

std::pair<std::string, bool> compare(const Counts& counted, const Counts& stored) {
  std::string text = fmt::format("{:<24} {:>14} {:>14} {:>9}\n", "instructions of a step", "stored", "counted", "change");
  bool holds = true;
  for (const auto& [name, now] : counted) {
    const double before = count_of(stored, name), change = before > 0 ? now / before - 1 : INFINITY;
    const bool within = std::abs(change) <= k_tolerance;
    holds &= within;
    text += fmt::format("{:<24} {:>14.0f} {:>14.0f} {:>8.2f} %  {}\n", name, before, now, 100 * change,
                        within        ? "holds"
                        : before == 0 ? "NOT STORED"
                        : change > 0  ? "MORE"
                                      : "FEWER: bless it, so that it stays");
  }
  for (const auto& [name, before] : stored)
    if (count_of(counted, name) == 0) {
      holds = false;
      text += fmt::format("{:<24} {:>14.0f} {:>14} {:>9}    NOT COUNTED\n", name, before, "-", "");
    }
  return {text, holds};
}

}  // namespace bake::count
