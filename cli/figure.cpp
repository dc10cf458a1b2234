// SPDX-License-Identifier: MIT
// bake figure <item>, bake table <number>
#include <fmt/format.h>

#include <memory>
#include <regex>

#include "cli/commands.h"
#include "experiments/make/make_figure.h"

namespace bake::cli {
namespace {

struct FigureArguments {
  std::string item;
  bool all = false, no_pictures = false;
  MakeOptions options;
};

/// Makes one item, prints its tables and its claims; exit code 1 if one does not hold.
int make(const Items& items, const Item& item, const MakeOptions& options) {
  const MadeFigure made = make_figure(items, item, options);
  if (!options.only_run.empty()) return k_success;
  for (const ComputedTable& table : made.tables) fmt::print("{}\n", text_of(table));
  const auto missed = std::count_if(made.verdicts.begin(), made.verdicts.end(), [](const ClaimVerdict& v) { return !v.holds; });
  fmt::print("{} ({})\n{}", item.number, item.name, table(made.verdicts));
  fmt::print("{} of {} claims hold; {}\n", static_cast<std::ptrdiff_t>(made.verdicts.size()) - missed, made.verdicts.size(),
             made.folder.string());
  return made.holds() ? k_success : k_failed_check;
}

int make_all(const Items& items, const MakeOptions& options) {
  int worst = k_success;
  for (const Item& item : items.items)
    if (item.status == ItemStatus::done) worst = std::max(worst, make(items, item, options));
  return worst;
}

int figure(FigureArguments arguments, const std::string& kind) {
  arguments.options.pictures = !arguments.no_pictures;
  const Items items = read_items(items_root(BAKE_SOURCE_DIR));
  if (!arguments.all && arguments.item.empty())
    throw InputError(fmt::format("found no {}, allowed: a number or name (bake list figures), or --all", kind));
  if (arguments.all) {
    if (!arguments.item.empty() || !arguments.options.only_run.empty())
      throw InputError("--all: found an item or --only-run beside it, allowed: --all alone");
    return make_all(items, arguments.options);
  }
  return make(items, find_item(items, arguments.item, kind), arguments.options);
}

/// What bake-render allows, before anything is run.
CLI::Validator picture_size() {
  const auto check = [](const std::string& text) {
    const std::regex two_numbers("0*([0-9]{1,5})x0*([0-9]{1,5})");
    std::smatch sides;
    const auto allowed = [&](std::size_t side) { return std::stoi(sides[side]) >= 16 && std::stoi(sides[side]) <= 16384; };
    if (std::regex_match(text, sides, two_numbers) && allowed(1) && allowed(2)) return std::string();
    return fmt::format("found {}, allowed: WIDTHxHEIGHT, each a whole number from 16 to 16384, as in 1280x960", text);
  };
  return {check, ""};
}

}  // namespace

void add_figure_commands(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<FigureArguments>();
  CLI::App& figure_command = *app.add_subcommand("figure", "Make a figure of the paper and check its claims");
  figure_command.add_option("item", arguments->item, "number or name (see `bake list figures`)");
  figure_command.add_flag("--all", arguments->all, "every figure and table that is done");
  figure_command.add_option("--only-run", arguments->options.only_run, "simulate this run of the figure and nothing else")
      ->type_name("NAME");
  figure_command.add_flag("--no-pictures", arguments->no_pictures, "leave out what needs bake-render");
  figure_command.add_option("--size", arguments->options.size, "size of the pictures, instead of the view's")
      ->type_name("WxH")
      ->check(picture_size());
  figure_command.add_option("--samples", arguments->options.samples, "most paths of light per pixel, instead of the view's")
      ->type_name("N")
      ->transform(whole_number(1, 1'000'000));
  on_request(figure_command, action, [arguments] { return figure(*arguments, "figure"); });

  CLI::App& table_command = *app.add_subcommand("table", "Make a table of the paper and check its claims");
  table_command.add_option("number", arguments->item, "its number")->required();
  on_request(table_command, action, [arguments] { return figure(*arguments, "table"); });

  for (CLI::App* command : {&figure_command, &table_command}) {
    add_quality_option(*command, arguments->options.quality);
    add_threads_option(*command, arguments->options.threads);
    command->add_flag("--quiet", arguments->options.quiet, "print claims only");
  }
}

}  // namespace bake::cli
