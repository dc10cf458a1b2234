// SPDX-License-Identifier: MIT
// bake explain [key], bake version
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "solver/core/errors.h"
#include "solver/io/ledger_file.h"
#include "solver/io/provenance.h"
#include "solver/run/ledger.h"
#include "solver/scene/explain.h"

namespace bake::cli {

std::string version_line() {
  const nlohmann::json program = provenance()["program"];
  const bool dirty = program["dirty"].is_boolean() && program["dirty"].get<bool>();
  const auto commit = program["commit"].get<std::string>();
  return fmt::format("bake {} (commit {}{})", program["version"].get<std::string>(), commit,
                     commit == "unknown" ? ": built from sources without git"
                     : dirty             ? ", changed since"
                                         : "");
}

namespace {

/// Scene keys and columns of results may have the same name: then both are told of. Columns are known by their former names, too.
std::string explain_key_or_column(const std::string& name) {
  std::string column = name.empty() ? "" : explain_column(present_column(name));
  std::vector<std::string> columns = ledger_columns();
  for (const FrameColumnWords& c : frame_columns()) columns.push_back(c.name);
  try {
    return explain(name, columns) + (column.empty() ? "" : "\n" + column);
  } catch (const InputError&) {
    if (column.empty()) throw;
    return column;
  }
}

}  // namespace

void add_help_commands(CLI::App& app, Action& action) {
  auto key = std::make_shared<std::string>();
  CLI::App& explain_command = *app.add_subcommand("explain", "Say what a scene key or a column of results means");
  explain_command.add_option(
      "key", *key, "a key, a table, an effect, a shape, or a column of the ledger or of frames; without it, an overview of all keys");
  on_request(explain_command, action, [key] { fmt::print("{}", explain_key_or_column(*key)); });

  on_request(*app.add_subcommand("version", "Print the version"), action, [] { fmt::print("{}\n", version_line()); });
}

}  // namespace bake::cli
