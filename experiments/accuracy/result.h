// SPDX-License-Identifier: MIT
// What the measurements of a case say.
#pragma once

#include <nlohmann/json.hpp>

#include "experiments/accuracy/front.h"
#include "experiments/accuracy/raw_data.h"

namespace bake::studies::accuracy {

/// How far from the front a quality of the scene is.
struct QualityResult {
  std::string quality;  ///< "draft", "standard", "paper"
  const Point* point;
  double excess_particle_steps, excess_cpu;  ///< 1: on the front
  const Point* better;                       ///< the cheapest as good, in particle-steps
};

/// Measurements of a variant, unless --quick is asked for.
inline constexpr int k_repeats = 5;
inline constexpr double k_allowed_excess = 1.5;
inline constexpr double k_goals[] = {0.1, 0.03, 0.01, 0.003};

/// Finest grid that both curves have without failing; nullptr without one.
std::pair<const Point*, const Point*> finest_common(const Curve* a, const Curve* b);

class CaseResult {
 public:
  /// From the raw data, every variant that is there.
  CaseResult(const Case& c, const RawData& raw);
  CaseResult(CaseResult&&) = default;

  const Case& of() const { return *case_; }
  const std::vector<Curve>& curves() const { return curves_; }  ///< the default's first; none is empty
  bool empty() const { return curves_.empty(); }
  const Curve* default_curve() const;
  std::vector<QualityResult> qualities() const;
  const Curve* curve_of(const std::string& label) const;  ///< nullptr if it is not there
  /// Finest grid that both the default and the curve have without failing; nullptr without one.
  std::pair<const Point*, const Point*> common(const Curve& curve) const { return finest_common(default_curve(), &curve); }

  /// In every repeat of every variant the error is the same, bit for bit.
  bool same_errors() const;
  /// The default's error at the finest grid is below that at the coarsest. True with fewer than two grids.
  bool falls() const;

 private:
  const Case* case_;
  std::vector<Curve> curves_;
};

/// The machine's own speed with one thread, over all measurements that know it.
struct MachineSpeed {
  int known = 0;  ///< measurements
  Spread triad_GB_per_s, single_GFLOPs, double_GFLOPs;
};
MachineSpeed speed_of(const std::vector<CaseResult>& results);

/// "default, 20 cells".
std::string words_of(const Point& point);
/// Two digits, and never an exponent for what is large: "0.034", "2.7", "604".
std::string brief(double number);
/// "3.2 %", as brief().
std::string percent(double share);

/// What the report and `bake info` tell; the measurements themselves stand in the raw data.
nlohmann::json as_json(const CaseResult& result);
nlohmann::json as_json(const MachineSpeed& speed);  ///< null if it is not known
/// Sentences about a case, from its numbers.
std::vector<std::string> conclusions(const CaseResult& result);
/// The page.
std::string as_markdown(const std::vector<CaseResult>& results, const nlohmann::json& provenance);
/// accuracy_<case>.csv, .svg and .pdf. Throws as charts::write_chart.
void write_charts(const CaseResult& result, const std::filesystem::path& folder);

}  // namespace bake::studies::accuracy
