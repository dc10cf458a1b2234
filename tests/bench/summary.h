// SPDX-License-Identifier: MIT
// The console's lines, and a table of the steps beside the machine's limits at the end.
#pragma once

#include <benchmark/benchmark.h>

#include <vector>

#include "analysis/machines/limits.h"

namespace bake::bench {

class SummaryReporter : public benchmark::ConsoleReporter {
 public:
  explicit SummaryReporter(const Limits& limits);
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  /// Of the repetitions of one benchmark.
  struct Figures {
    std::vector<double> rate, peak, triad, cpu_ns;
  };
  struct Row {
    std::string name;
    Figures one, all;
  };

  void print_limits();
  const Row* row_of(const std::string& name) const;

  Limits limits_;
  std::vector<Row> rows_;  ///< in the order of the runs
};

}  // namespace bake::bench
