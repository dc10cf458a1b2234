// SPDX-License-Identifier: MIT
#include "solver/run/kept_run.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "solver/io/provenance.h"
#include "solver/run/frame_times.h"
#include "solver/scene/resolved.h"
#include "solver/scene/scene.h"

namespace bake {
namespace {

/// Everything that decides the numbers of a run.
nlohmann::json identity(const nlohmann::json& scene, const nlohmann::json& program) {
  nlohmann::json values = under_former_names(scene);
  values.erase("file");
  return {values, program.at("solver"), program.at("compiler"), program.at("flags")};
}

}  // namespace

KeptRun kept_run(const Scene& scene, const std::filesystem::path& folder) {
  std::ifstream in(folder / "run.json");
  if (!in) return KeptRun::none;
  try {
    const nlohmann::json run = nlohmann::json::parse(in);
    const nlohmann::json now = provenance()["program"];
    if (identity(run.at("scene"), run.at("provenance").at("program")) != identity(resolved(scene), now)) return KeptRun::none;
    const bool reached_the_end = run.at("summary").at("time_s").get<double>() >= FrameTimes(scene).end_s();
    if (run.at("summary").at("state") == "done" && reached_the_end) return KeptRun::finished;
    return std::filesystem::exists(folder / "checkpoint.h5") ? KeptRun::unfinished : KeptRun::none;
  } catch (const nlohmann::json::exception&) {
    return KeptRun::none;  // written by an older version, or not a run at all
  }
}

void complete_run(const Scene& scene, RunOptions options, KeptRun kept) {
  if (kept == KeptRun::finished) return;
  options.resume = kept == KeptRun::unfinished;
  if (run_scene(scene, options).interrupted) throw RunError("interrupted; the same command resumes from the checkpoint");
}

}  // namespace bake
