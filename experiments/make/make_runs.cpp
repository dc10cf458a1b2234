// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "experiments/make/pipeline.h"
#include "experiments/make/programs.h"
#include "experiments/make/up_to_date.h"
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

void make_run(const FigurePaths& paths, const FigureRun& run) {
  Scene scene = scene_of(paths, run);
  scene.file = fs::absolute(scene.file);  // the mesh's path is relative to the working folder
  if (run.mesh) use_mesh(scene, make_mesh(paths, run, scene));
  for (const std::string& notice : scene.notices) say(paths.options, notice);
  RunOptions options;
  options.out = paths.run(run.name);
  options.threads = paths.options.threads;
  options.quiet = paths.options.quiet;
  options.replace = Replace::any_run;  // the folder is named by the run
  const KeptRun kept = kept_run(scene, options.out);
  say(paths.options, fmt::format("run {}: {}", run.name,
                                 kept == KeptRun::finished     ? "is finished already"
                                 : kept == KeptRun::unfinished ? "resumes from its checkpoint"
                                                               : "begins"));
  complete_run(scene, options, kept);
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
  std::set<std::string> made;  // two pictures may show one run
  for (const FigurePaths& part : with_parts(paths))
    for (const FigureRun& run : part.figure.runs)
      if ((paths.options.only_run.empty() || paths.options.only_run == run.name) && made.insert(run.name).second) make_run(part, run);
}

}  // namespace bake
