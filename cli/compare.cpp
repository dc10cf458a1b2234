// SPDX-License-Identifier: MIT
// bake compare <benchmarks> <benchmarks>...
#include <fmt/format.h>

#include <memory>

#include "analysis/machines/comparison.h"
#include "cli/commands.h"

namespace bake::cli {
namespace {

struct CompareFiles {
  std::vector<std::filesystem::path> files;
  std::filesystem::path out;
};

int compare(const CompareFiles& arguments) {
  const studies::BenchFile base = studies::read_bench_file(arguments.files.front());
  std::vector<studies::BenchFile> others;
  for (std::size_t i = 1; i < arguments.files.size(); ++i) others.push_back(studies::read_bench_file(arguments.files[i]));
  std::vector<std::vector<studies::BenchRatio>> ratios;
  ratios.reserve(others.size());
  for (const studies::BenchFile& other : others) ratios.push_back(studies::compare(base, other));
  if (!arguments.out.empty()) charts::write_chart(studies::chart_of(base, others, ratios), arguments.out);
  for (std::size_t i = 0; i < others.size(); ++i) fmt::print("{}{}", i == 0 ? "" : "\n\n", studies::in_words(base, others[i], ratios[i]));
  if (!arguments.out.empty()) fmt::print("chart written to {}\n", (arguments.out / "compare.svg").string());
  return k_success;
}

}  // namespace

void add_compare_command(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<CompareFiles>();
  CLI::App& command = *app.add_subcommand("compare", "Compare benchmarks of machines, compilers or versions (see ./bake bench)");
  command.footer(
      "The test of Mann and Whitney over the repetitions, at 5 %, decides whether a ratio differs from noise. \"per triad\" and \"per "
      "FMA\" are "
      "the ratios divided by those of the machines' measured limits, for the benchmark's threads and precision: near 1, the machines alone "
      "make the difference.");
  command.add_option("files", arguments->files, "JSON files of ./bake bench; the first is what the others are compared with")
      ->required()
      ->expected(2, 1000)
      ->type_name("FILE");
  command.add_option("--out", arguments->out, "also write a chart (compare.svg, .pdf, .csv) into this folder")->type_name("DIR");
  on_request(command, action, [arguments] { return compare(*arguments); });
}

}  // namespace bake::cli
