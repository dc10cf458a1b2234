// SPDX-License-Identifier: MIT
// bake explain [key], bake version
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
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

void add_help_commands(CLI::App& app, Action& action) {
  auto key = std::make_shared<std::string>();
  CLI::App& explain_command = *app.add_subcommand("explain", "Say what a scene key or a column of results means");
  explain_command.add_option(
      "key", *key, "a key, a table, an effect, a shape, or a column of the ledger or of frames; without it, an overview of all keys");
  explain_command.callback([key, &action] {
    action = [key] {
      const std::string column = key->empty() ? "" : explain_column(*key);
      fmt::print("{}", column.empty() ? explain(*key) : column);
      return k_success;
    };
  });

  app.add_subcommand("version", "Print the version")->callback([&action] {
    action = [] {
      fmt::print("{}\n", version_line());
      return k_success;
    };
  });
}

}  // namespace bake::cli
