// SPDX-License-Identifier: MIT
// bake_bench: Google Benchmark with the machine's limits beside the figures.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "analysis/machines/limits.h"
#include "solver/core/lanes.h"
#include "solver/io/provenance.h"
#include "solver/program/waiting.h"
#include "tests/bench/steps.h"
#include "tests/bench/summary.h"

namespace bake::bench {

namespace {

void describe_machine(const Limits& limits) {
  const nlohmann::json source = provenance();
  for (const char* part : {"program", "machine"})
    for (const auto& [key, value] : source.at(part).items())
      benchmark::AddCustomContext(fmt::format("{}.{}", part, key), value.is_string() ? value.get<std::string>() : value.dump());
  for (const auto& [level, name] :
       {std::pair("L1d", _SC_LEVEL1_DCACHE_SIZE), std::pair("L2", _SC_LEVEL2_CACHE_SIZE), std::pair("L3", _SC_LEVEL3_CACHE_SIZE)})
    benchmark::AddCustomContext(fmt::format("machine.cache_bytes.{}", level), std::to_string(sysconf(name)));
  benchmark::AddCustomContext("program.vector_bits", std::to_string(8 * sizeof(Lanes<float>)));
  benchmark::AddCustomContext("machine.threads", std::to_string(limits.threads));
  for (const char* variable : {"OMP_NUM_THREADS", "OMP_PROC_BIND", "OMP_PLACES", "GOMP_SPINCOUNT"})
    if (const char* value = std::getenv(variable)) benchmark::AddCustomContext(fmt::format("environment.{}", variable), value);
  const auto add = [](const char* name, const Rate& rate) {
    benchmark::AddCustomContext(fmt::format("{}.1_thread", name), fmt::format("{:.1f}", rate.one));
    benchmark::AddCustomContext(fmt::format("{}.all_threads", name), fmt::format("{:.1f}", rate.all));
  };
  add("limit.triad_GB_per_s", limits.triad_GB_per_s);
  add("limit.single_GFLOPs", limits.single_GFLOPs);
  add("limit.double_GFLOPs", limits.double_GFLOPs);
}

/// The arguments, with a JSON file of the results unless one is named.
std::vector<char*> with_output(int count, char** given) {
  static char out[] = "--benchmark_out=bake-bench.json";
  std::vector<char*> arguments(given, given + count);
  const auto is = [](const char* option) { return [=](const char* a) { return std::strncmp(a, option, std::strlen(option)) == 0; }; };
  const bool named = std::any_of(arguments.begin(), arguments.end(), is("--benchmark_out="));
  const bool lists = std::any_of(arguments.begin(), arguments.end(), is("--benchmark_list_tests"));
  if (!named && !lists) arguments.push_back(out);
  return arguments;
}

int run(int count, char** given) {
  std::vector<char*> arguments = with_output(count, given);
  int left = static_cast<int>(arguments.size());
  benchmark::Initialize(&left, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(left, arguments.data())) return 2;
  const Limits limits = measure_limits();
  describe_machine(limits);
  register_steps(limits);
  register_passes(limits);
  register_parts(limits);
  SummaryReporter reporter(limits);
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return 0;
}

}  // namespace

}  // namespace bake::bench

int main(int count, char** arguments) {
  bake::let_waiting_threads_sleep(arguments);
  return bake::bench::run(count, arguments);
}
