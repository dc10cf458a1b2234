// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "experiments/make/moments.h"
#include "experiments/make/pipeline.h"
#include "experiments/make/programs.h"
#include "experiments/make/side_by_side.h"
#include "experiments/make/up_to_date.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

constexpr int k_moments = 12;

/// The first frame in which there is something: what is poured begins with nothing.
int first_frame(const Results& run) {
  const std::vector<double> volumes = run.column_as_it_is("volume_m3");
  return static_cast<int>(std::find_if(volumes.begin(), volumes.end() - 1, [](double volume) { return volume > 0; }) - volumes.begin());
}

/// The frames that are shown, closer together where the body changes.
std::vector<int> frames_of(const Results& run, double from_s) {
  std::vector<std::vector<double>> columns;
  for (const char* name : {"time_s", "volume_m3", "height_m", "extent_x_m", "extent_y_m"}) columns.push_back(run.column_as_it_is(name));
  return moments(columns, k_moments, std::max(first_frame(run), run.frame_at(from_s)));
}

/// The frames of another run that are nearest in time; its last one from there on where it ends before.
std::vector<int> frames_beside(const Results& leader, const std::vector<int>& frames, const Results& run) {
  const std::vector<double> times = leader.column("time_s"), own = run.column("time_s");
  std::vector<int> beside;
  beside.reserve(frames.size());
  for (const int frame : frames)
    beside.push_back(std::max(first_frame(run), run.frame_at(std::min(times[static_cast<std::size_t>(frame)], own.back()))));
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  return beside;
}

void make_body(const FigurePaths& paths, const FigureObject& object, const std::string& name, const std::vector<int>& frames) {
  const fs::path run = paths.run(name), folder = paths.item_folder() / object.name / name, view = view_file(paths.figure, object.view);
  // particles cost as many bytes as triangles: a body that has both gets fewer of these
  std::vector<std::string> words{"model",
                                 view.string(),
                                 run.string(),
                                 "--frames",
                                 fmt::format("{}", fmt::join(frames, ",")),
                                 "--out",
                                 folder.string(),
                                 "--triangles",
                                 object.particles ? "11000" : "17000"};
  const nlohmann::json from{words, stamp(run / "run.json"), stamp(view), stamp(find_program("bake-render"))};
  if (is_up_to_date(folder, from)) return;
  say(paths.options, fmt::format("object {} of {}", object.name, name));
  fs::remove_all(folder);  // frames that are no longer chosen
  if (paths.options.threads > 0) words.insert(words.end(), {"--threads", std::to_string(paths.options.threads)});  // same surfaces
  call_program("bake-render", words, paths.item_folder() / (object.name + "_" + name + ".log"), paths.options.quiet);
  record_sources(folder, from);
}

}  // namespace

void make_objects(const FigurePaths& paths) {
  for (const FigureObject& object : paths.figure.objects) {
    const Results leader(paths.run(object.of.front()));
    const std::vector<int> frames = frames_of(leader, object.from_s);
    side_by_side(object.of.size(), programs_at_once(paths.options), [&](std::size_t i) {
      const std::string& name = object.of[i];
      make_body(paths, object, name, i == 0 ? frames : frames_beside(leader, frames, Results(paths.run(name))));
    });
  }
}

}  // namespace bake
