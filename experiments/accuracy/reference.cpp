// SPDX-License-Identifier: MIT
#include "experiments/accuracy/reference.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/accuracy/running.h"
#include "solver/core/errors.h"
#include "solver/io/atomic_file.h"
#include "solver/io/provenance.h"
#include "solver/io/scratch_folder.h"
#include "solver/run/kept_run.h"
#include "solver/scene/resolved.h"
#include "solver/scene/scene.h"

namespace bake::studies::accuracy {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path reference_file(const std::string& name) { return fs::path(BAKE_SOURCE_DIR) / "reference/accuracy" / (name + ".json"); }

std::map<std::string, double> values_of(const Results& run, const std::vector<Quantity>& quantities) {
  std::map<std::string, double> values;
  for (const Quantity& q : quantities) {
    const Measurement m = measure(find_metric(q.metric), run, q.at);
    if (!m.is_number()) throw InputError(m.problem);
    values[q.name] = m.value;
  }
  return values;
}

/// Goes through the scene and leaves what Results reads: first and last frame, ledger, run.json.
void leave_results(const Scene& scene, const fs::path& folder, Running& running, Found& found) {
  fs::create_directories(folder / "frames");
  LedgerFile ledger = LedgerFile::create(folder / "ledger.csv", running.ledger_names());
  const auto leave_frame = [&](int frame) {
    ledger.append(running.ledger_row());
    running.write_frame_file(folder / "frames" / frame_name(frame));
  };
  leave_frame(0);
  running.advance(scene.run.end_s, found);
  leave_frame(1);
  write_text_atomically(folder / "run.json", json{{"summary", {{"state", "done"}}}}.dump());
}

void compare_with_reference(const ReferencedScene& of, const Results& results, Found& found) {
  const json reference = json::parse(std::ifstream(reference_file(of.name)));
  const auto values = values_of(results, of.quantities);
  double sum = 0;
  for (const Quantity& q : of.quantities) {
    const double right = reference.at("quantities").at(q.name);
    found.parts[q.name] = std::abs(values.at(q.name) - right) / std::abs(right - q.start);
    sum += std::pow(found.parts[q.name], 2);
  }
  found.error = std::sqrt(sum / static_cast<double>(of.quantities.size()));
}

Found measure(const ReferencedScene& of, const Scene& scene, By by) {
  return run(scene, by, scene.run.end_s, [&](Running& running, Found& found) {
    const ScratchFolder scratch;  // for the two frames that metrics are taken from
    leave_results(scene, scratch.path(), running, found);
    compare_with_reference(of, Results(scratch.path()), found);
  });
}

/// One frame a run: steps end where the scene ends.
std::vector<std::string> frames_of(double count, double end_s) { return {fmt::format("run.frame_rate_per_s={:.17g}", count / end_s)}; }

Scene scene_with_frames(const ReferencedScene& of, const Variant& v, double count) {
  const Scene as_it_is = scene_of_file(of.scene, of.length, v);
  return scene_of_file(of.scene, of.length, v, frames_of(count, as_it_is.run.end_s));
}

Scene fine_scene(const ReferencedScene& of) {
  constexpr double k_frames = 20;  // a checkpoint at each
  Variant fine{"reference", of.fine, 0, {"run.precision=double", "run.checkpoint_every_frames=1"}};
  fine.overrides.insert(fine.overrides.end(), of.fine_settings.begin(), of.fine_settings.end());
  return scene_with_frames(of, fine, k_frames);
}

void make_reference(const ReferencedScene& of, const fs::path& folder) {
  const Scene scene = fine_scene(of);
  RunOptions options;
  options.out = folder / ("reference-" + of.name);
  options.replace = Replace::any_run;  // the folder is named by the run
  complete_run(scene, options, kept_run(scene, options.out));
  const Results run(options.out);
  const json stored{{"case", of.name},
                    {"scene", of.scene},
                    {"scene_fingerprint", scene_fingerprint(scene)},
                    {"cells", of.fine},
                    {"dx_m", scene.dx()},
                    {"precision", "double"},
                    {"particles", run.last("particles")},
                    {"steps", run.last("steps")},
                    {"quantities", values_of(run, of.quantities)},
                    {"provenance", provenance()}};
  fs::create_directories(reference_file(of.name).parent_path());
  write_text_atomically(reference_file(of.name), stored.dump(2) + "\n");
  fmt::print("{}: written\n", reference_file(of.name).string());
}

}  // namespace

void refer(Case& c, const ReferencedScene& of) {
  c.name = of.name;
  c.scene = of.scene;
  c.scene_of = [of](const Variant& v) { return scene_with_frames(of, v, 1); };
  c.measure = [of](const Scene& scene, By by) { return measure(of, scene, by); };
  c.missing = [of] {
    const auto none = [&](const std::string& what) {
      return fmt::format("{1} reference/accuracy/{0}.json; `bake study accuracy --reference {0}` makes it", of.name, what);
    };
    if (!fs::exists(reference_file(of.name))) return none("no");
    const json reference = json::parse(std::ifstream(reference_file(of.name)));
    if (reference.value("scene_fingerprint", "") != scene_fingerprint(fine_scene(of))) return none("of another version of the scene:");
    for (const Quantity& q : of.quantities)
      if (!reference.at("quantities").contains(q.name)) return none(fmt::format("no \"{}\" in", q.name));
    return std::string();
  };
  c.make_reference = [of](const fs::path& folder) { make_reference(of, folder); };
}

}  // namespace bake::studies::accuracy
