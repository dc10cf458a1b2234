// SPDX-License-Identifier: MIT
#include "analysis/machines/bench_file.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "solver/core/errors.h"

namespace bake::studies {
namespace {

using nlohmann::json;

constexpr const char* k_allowed = "allowed: a file that `./bake bench` has written";

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& found, const std::string& allowed = k_allowed) {
  throw InputError(fmt::format("{}: found {}, {}", file.string(), found, allowed));
}

/// Replaces the NaN and Infinity that Google Benchmark writes for the spread of counters that are always zero, and that JSON lacks:
/// counters are not compared.
std::string without_nan(std::string text) {
  for (const char* word : {": NaN", ": -NaN", ": Infinity", ": -Infinity"})
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos;) text.replace(at, std::string_view(word).size(), ": null");
  return text;
}

json parse(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) refuse(file, "a folder");
  std::ifstream in(file);
  if (!in) refuse(file, "no such file, or none that can be read");
  const std::string text = without_nan({std::istreambuf_iterator<char>(in), {}});
  if (text.empty()) refuse(file, "an empty file");
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    if (error.byte >= text.size()) refuse(file, fmt::format("JSON that is cut short after {} bytes", text.size()));
    refuse(file, fmt::format("no JSON (byte {})", error.byte));
  }
}

std::string text_of(const json& context, const char* key, const char* otherwise) {
  const auto at = context.find(key);
  return at != context.end() && at->is_string() ? at->get<std::string>() : otherwise;
}

/// Reads a limit, which the context of the file holds as text.
double limit_of(const std::filesystem::path& file, const json& context, const std::string& key) {
  const std::string text = text_of(context, key.c_str(), "");
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty()) refuse(file, fmt::format("no \"{}\" in its context", key));
  if (error != std::errc() || end != text.data() + text.size() || !(value > 0))
    refuse(file, fmt::format("\"{}\" as \"{}\" in its context", text, key), "allowed: a number above 0");
  return value;
}

MachineLimit limits_of(const std::filesystem::path& file, const json& context, const std::string& key) {
  return {limit_of(file, context, key + ".1_thread"), limit_of(file, context, key + ".all_threads")};
}

double number_of(const json& context, const char* key, double otherwise) {
  const std::string text = text_of(context, key, "");
  double value = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

double seconds_per(const std::string& unit) { return unit == "s" ? 1 : unit == "ms" ? 1e-3 : unit == "us" ? 1e-6 : 1e-9; }

/// Removes the parts of a name that only tell how the benchmark was run.
std::string short_name(std::string name) {
  for (const char* suffix : {"/real_time", "/manual_time", "/process_time"})
    if (name.ends_with(suffix)) name.resize(name.size() - std::string_view(suffix).size());
  const auto iterations = name.rfind("/iterations:");
  return iterations != std::string::npos && name.find('/', iterations + 1) == std::string::npos ? name.substr(0, iterations) : name;
}

void read_benchmarks(const json& benchmarks, BenchFile& into) {
  for (const json& run : benchmarks) {
    if (!run.is_object()) refuse(into.file, "a benchmark that is no object");
    if (run.value("run_type", std::string("iteration")) != "iteration" || run.value("error_occurred", false)) continue;
    const auto time = run.find("real_time");
    if (!run.contains("name") || !run.at("name").is_string()) refuse(into.file, "a benchmark without a name");
    const std::string name = short_name(run.value("run_name", run.at("name").get<std::string>()));
    if (time == run.end() || !time->is_number() || !(time->get<double>() > 0))
      refuse(into.file, fmt::format("\"{}\" without a time above 0", name));
    auto& repetitions = into.seconds[name];
    if (repetitions.empty()) into.names.push_back(name);
    repetitions.push_back(time->get<double>() * seconds_per(run.value("time_unit", std::string("ns"))));
  }
  if (into.names.empty())
    refuse(into.file, "no single repetition of any benchmark",
           "allowed: a file of `./bake bench` without --benchmark_report_aggregates_only");
}

}  // namespace

BenchFile read_bench_file(const std::filesystem::path& file) {
  const json all = parse(file);
  if (!all.is_object() || !all.contains("context") || !all["context"].is_object() || !all.contains("benchmarks") ||
      !all["benchmarks"].is_array())
    refuse(file, "JSON of something else");
  const json& context = all["context"];
  BenchFile bench;
  bench.file = file;
  bench.triad_GB_per_s = limits_of(file, context, "limit.triad_GB_per_s");
  bench.single_GFLOPs = limits_of(file, context, "limit.single_GFLOPs");
  bench.double_GFLOPs = limits_of(file, context, "limit.double_GFLOPs");
  bench.logical_cores = number_of(context, "machine.logical_cores", 1);
  bench.machine = fmt::format("{}, {} logical cores", text_of(context, "machine.cpu", "unknown processor"),
                              text_of(context, "machine.logical_cores", "unknown"));
  bench.program = fmt::format("bake {} {}, {}", text_of(context, "program.version", "?"),
                              text_of(context, "program.commit", "?").substr(0, 12), text_of(context, "program.compiler", "?"));
  if (const auto load = context.find("load_avg"); load != context.end() && load->is_array() && !load->empty() && load->front().is_number())
    bench.load = load->front().get<double>();
  read_benchmarks(all["benchmarks"], bench);
  return bench;
}

}  // namespace bake::studies
