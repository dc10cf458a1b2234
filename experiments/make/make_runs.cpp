// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <set>
#include <span>

#include "experiments/make/pipeline.h"
#include "experiments/make/programs.h"
#include "experiments/make/side_by_side.h"
#include "experiments/make/up_to_date.h"
#include "solver/io/stop_signals.h"
#include "solver/run/kept_run.h"
#include "solver/scene/entry.h"
#include "solver/scene/nearest.h"
#include "solver/scene/reader.h"
#include "solver/scene/resolved.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

Scene scene_of(const FigurePaths& paths, const FigureRun& run) {
  return read_scene(scene_file(paths.figure, run), {paths.options.quality, run.set});
}

std::vector<std::string> mesh_arguments(const FigurePaths& paths, const FigureRun& run, const fs::path& out) {
  std::vector<std::string> words{"tets", scene_file(paths.figure, run).string(), "--out", out.string(), "--quality", paths.quality()};
  for (const std::string& override : run.set) words.insert(words.end(), {"--set", override});
  return words;
}

/// Puts the new mesh in place. If it differs from the old one, the results that were made from the old one become invalid.
void replace_mesh(const fs::path& made, const fs::path& mesh) {
  const bool same = fs::exists(mesh) && read_text_file(made) == read_text_file(mesh);
  if (!same) fs::remove(mesh.parent_path() / "run.json");
  fs::rename(made, mesh);
}

/// mesh.hdf in the run's folder.
fs::path make_mesh(const FigurePaths& paths, const FigureRun& run, const Scene& scene) {
  const fs::path folder = paths.run(run.name), aside = folder / "new_mesh.hdf";
  fs::path mesh = folder / "mesh.hdf";
  const nlohmann::json from{resolved(scene), stamp(find_program("bake-mesh"))};
  if (is_up_to_date(mesh, from)) return mesh;
  say(paths.options, fmt::format("mesh of {}", run.name));
  call_program("bake-mesh", mesh_arguments(paths, run, aside), folder / "bake-mesh.log", paths.options.quiet);
  replace_mesh(aside, mesh);
  record_sources(mesh, from);
  return mesh;
}

void use_mesh(Scene& scene, const fs::path& mesh) {
  if (scene.bodies.empty())
    throw InputError(fmt::format("{}: found no body, allowed: mesh = true for a scene with one", scene.file.string()));
  scene.bodies.front().shape = nullptr;
  scene.bodies.front().particles_file = fs::absolute(mesh);
}

/// A run that is to be made.
struct Asked {
  FigurePaths paths;
  const FigureRun& run;
  Scene scene;
  KeptRun kept = KeptRun::none;
};

/// Each once: two pictures may show one run.
std::vector<Asked> asked_runs(const FigurePaths& paths) {
  std::vector<Asked> runs;
  std::set<std::string> names;
  const std::string& only = paths.options.only_run;
  for (const FigurePaths& part : with_parts(paths))
    for (const FigureRun& run : part.figure.runs)
      if ((only.empty() || only == run.name) && names.insert(run.name).second) runs.push_back({part, run, scene_of(part, run)});
  return runs;
}

/// Makes its mesh, and looks whether it is there.
void prepare(Asked& asked) {
  asked.scene.file = fs::absolute(asked.scene.file);  // the mesh's path is relative to the working folder
  if (asked.run.mesh) use_mesh(asked.scene, make_mesh(asked.paths, asked.run, asked.scene));
  asked.kept = kept_run(asked.scene, asked.paths.run(asked.run.name));
}

void say_state(const Asked& asked) {
  const auto& [paths, run, scene, kept] = asked;
  for (const std::string& notice : scene.notices) say(paths.options, notice);
  say(paths.options, fmt::format("run {}: {}", run.name,
                                 kept == KeptRun::finished     ? "is finished already"
                                 : kept == KeptRun::unfinished ? "resumes from its checkpoint"
                                                               : "begins"));
}

void make_here(const Asked& asked) {
  say_state(asked);
  const MakeOptions& make = asked.paths.options;
  RunOptions options;
  options.out = asked.paths.run(asked.run.name);
  options.threads = make.threads;
  options.quiet = make.quiet;
  options.replace = Replace::any_run;  // the folder is named by the run
  complete_run(asked.scene, options, asked.kept);
}

/// By a process of its own: how many threads work, and what ends a run in order, a process has once. `item`: what asks for the run.
void make_aside(const Asked& asked, const std::string& item, int threads) {
  const FigurePaths& paths = asked.paths;
  const std::string& name = asked.run.name;
  say_state(asked);
  call_program("bake",
               {"figure", item, "--only-run", name, "--no-pictures", "--quality", paths.quality(), "--threads", std::to_string(threads)},
               paths.item_folder() / (name + ".log"), paths.options.quiet, "run " + name);
}

/// Makes runs side by side as long as there are enough of them for all threads, since between its parallel loops a run leaves threads idle;
/// those that are left over share the threads.
void make_all(std::span<const Asked* const> runs, const FigurePaths& paths) {
  const int threads = paths.options.threads > 0 ? paths.options.threads : omp_get_max_threads();
  const bool alone = paths.figure.timed || paths.options.quality == Quality::paper;  // at paper one takes up to 4 GB
  while (!runs.empty()) {
    const int at_once = alone ? 1 : std::min(static_cast<int>(runs.size()), threads);
    const std::size_t now = runs.size() - runs.size() % static_cast<std::size_t>(at_once);
    if (at_once == 1) {
      for (const Asked* run : runs) make_here(*run);
    } else {
      const StopSignals signals;  // passed on to those that work
      side_by_side(now, at_once, [&](std::size_t i) { make_aside(*runs[i], paths.item.name, threads / at_once); });
    }
    runs = runs.subspan(now);
  }
}

void refuse_unknown_run(const FigurePaths& paths) {
  if (paths.options.only_run.empty()) return;
  const std::vector<std::string> names = runs_of(paths.figure);
  if (std::find(names.begin(), names.end(), paths.options.only_run) != names.end()) return;
  throw InputError(fmt::format("--only-run: unknown run '{}'; {}", quotable(paths.options.only_run),
                               names.empty() ? paths.item.number + " has none" : suggestion(paths.options.only_run, names)));
}

}  // namespace

void make_runs(const FigurePaths& paths) {
  refuse_unknown_run(paths);
  std::vector<Asked> runs = asked_runs(paths);
  side_by_side(runs.size(), programs_at_once(paths.options), [&](std::size_t i) { prepare(runs[i]); });
  std::vector<const Asked*> missing;
  for (const Asked& asked : runs)
    if (asked.kept == KeptRun::finished) {
      say_state(asked);
    } else {
      missing.push_back(&asked);
    }
  make_all(missing, paths);
}

}  // namespace bake
