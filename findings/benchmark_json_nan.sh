#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: libbenchmark-dev and libbenchmark1debian, 1.7.1-1.
# Behaviour: a counter that is NaN or infinite (a rate over no time is enough) is written into the JSON output as the bare words NaN and
# Infinity.
# Expected: null, a text, or a refusal. JSON has no such words (RFC 8259), so the whole file, with all other benchmarks, is lost to readers
# that keep to it; the user guide calls the output JSON and says nothing more. Python's reader takes it, which hides the fault.
# Seen: "ratio": NaN, and node's JSON.parse refuses the file.
source "$(dirname "$0")/common.sh"
debian_packages libbenchmark-dev=1.7.1-1 libbenchmark1debian=1.7.1-1
cat >counter.cpp <<'END'
#include <benchmark/benchmark.h>
#include <cmath>
static void nothing(benchmark::State& state) {
  for (auto _ : state) {}
  state.counters["ratio"] = std::nan("");
}
BENCHMARK(nothing)->Iterations(1);
BENCHMARK_MAIN();
END
compile counter.cpp -lbenchmark -pthread
output() {
  ./program --benchmark_format=json 2>/dev/null >counter.json
  grep -o '"ratio": [A-Za-z0-9]*' counter.json
  if node -e 'JSON.parse(require("fs").readFileSync("counter.json", "utf8"))' 2>/dev/null; then echo "is JSON"; else echo "is no JSON"; fi
}
look_at output
conclude '"ratio": NaN is no JSON' "Google Benchmark's JSON output is no JSON as soon as one counter is NaN"
