// SPDX-License-Identifier: MIT
// bake-count check, bake-count bless --why "..."
#include <fmt/format.h>

#include <memory>

#include "analysis/claims/blessing.h"
#include "solver/core/errors.h"
#include "solver/program/program.h"
#include "tests/count/counted_steps.h"
#include "tests/count/instructions.h"

namespace bake::count {
namespace {

const std::filesystem::path k_file = std::filesystem::path(BAKE_SOURCE_DIR) / "reference/instructions.json";

Counts counts() { return count_instructions(std::filesystem::read_symlink("/proc/self/exe")); }

int check() {
  const Stored stored = read_stored(k_file);
  if (stored.compiler != this_compiler())
    throw InputError(fmt::format("count: found the compiler {}, allowed: {}, by which the instructions of {} were made (name it in CXX)",
                                 this_compiler(), stored.compiler, k_file.string()));
  const auto [text, holds] = compare(counts(), stored.counts);
  fmt::print("{}{}\n", text, holds ? "all within 3 %" : "NOT all within 3 %: find out why, or `./bake count bless --why \"...\"`");
  return holds ? cli::k_success : cli::k_failed_check;
}

int bless(const std::string& why) {
  const std::string commit = cli::commit_to_bless(why);
  const Counts counted = counts();
  if (std::filesystem::exists(k_file)) fmt::print("{}", compare(counted, read_stored(k_file).counts).first);
  write_stored(k_file, counted, why, commit);
  fmt::print("{} is written; commit it\n", k_file.string());
  return cli::k_success;
}

}  // namespace
}  // namespace bake::count

int main(int count, char** words) {
  using namespace bake;
  CLI::App app("Counts the instructions of one step of every combination of effects.", "bake-count");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  cli::Action action;
  cli::on_request(*app.add_subcommand("check", "Compare them with reference/instructions.json; exit 1 if one has changed by more than 3 %"),
                  action, count::check);
  auto why = std::make_shared<std::string>();
  CLI::App& bless = *app.add_subcommand("bless", "Write reference/instructions.json anew, with a reason");
  bless.add_option("--why", *why, "the reason")->required();
  cli::on_request(bless, action, [why] { return count::bless(*why); });
  cli::on_request(*app.add_subcommand("steps", "Take the steps that are counted: what the others run under valgrind"), action,
                  count::take_counted_steps);
  return cli::run_program(app, action, count, words);
}
