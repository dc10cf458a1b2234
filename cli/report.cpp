// SPDX-License-Identifier: MIT
// bake report
#include "experiments/report/report.h"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "solver/io/atomic_file.h"

namespace bake::cli {
namespace {

struct ReportArguments {
  Quality quality = Quality::draft;
  std::filesystem::path out = "report.html";
};

void write(const ReportArguments& arguments) {
  const report::ReportPage made = report::make_report(read_items(items_root(BAKE_SOURCE_DIR)), arguments.quality);
  write_text_atomically(arguments.out, made.page);
  fmt::print("{}: {} reproduced, {} not reproduced, {} not run, {} not there yet\n", arguments.out.string(), made.reproduced,
             made.not_reproduced, made.not_run, made.not_there_yet);
}

}  // namespace

void add_report_command(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App& command = *app.add_subcommand("report", "Write one page with every figure that was made: pictures, claims, verdicts");
  add_quality_option(command, arguments->quality);
  command.add_option("--out", arguments->out, "the page [report.html]")->type_name("FILE");
  on_request(command, action, [arguments] { write(*arguments); });
}

}  // namespace bake::cli
