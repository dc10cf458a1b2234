// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <set>
#include <utility>

#include "experiments/make/pipeline.h"
#include "experiments/make/programs.h"
#include "experiments/make/side_by_side.h"
#include "experiments/make/up_to_date.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

/// The frames at the surface's times, "0,240,480".
std::string frames_of(const FigureSurface& surface, const Results& run) {
  std::vector<int> frames;
  for (const double time : surface.times_s) frames.push_back(run.frame_at(time));
  if (frames.empty()) frames.push_back(run.frame_at(std::nullopt));
  return fmt::format("{}", fmt::join(frames, ","));
}

std::vector<std::string> fracture_arguments(const FigurePaths& paths, const FigureSurface& surface) {
  const fs::path folder = paths.run(surface.run);
  std::vector<std::string> words{"fracture",
                                 (folder / "mesh.hdf").string(),
                                 folder.string(),
                                 "--out",
                                 paths.surface(surface.name).string(),
                                 "--reference-time",
                                 fmt::format("{}", surface.reference_time_s),
                                 "--frames",
                                 frames_of(surface, Results(folder))};
  if (surface.stretch) words.insert(words.end(), {"--stretch", fmt::format("{}", *surface.stretch)});
  if (surface.smallest_gap_m) words.insert(words.end(), {"--smallest-gap", fmt::format("{}", *surface.smallest_gap_m)});
  if (surface.void_ratio) words.insert(words.end(), {"--void-ratio", fmt::format("{}", *surface.void_ratio)});
  if (surface.smallest_crack) words.insert(words.end(), {"--smallest-crack", fmt::format("{}", *surface.smallest_crack)});
  return words;
}

void make_surface(const FigurePaths& paths, const FigureSurface& surface) {
  const auto words = fracture_arguments(paths, surface);
  const fs::path made = paths.surface(surface.name) / "fracture.json";
  const nlohmann::json from{words, stamp(paths.run(surface.run) / "run.json"), stamp(find_program("bake-mesh"))};
  if (is_up_to_date(made, from)) return;
  say(paths.options, fmt::format("surface {}", surface.name));
  call_program("bake-mesh", words, paths.item_folder() / (surface.name + ".log"), paths.options.quiet);
  record_sources(made, from);
}

}  // namespace

void make_surfaces(const FigurePaths& paths) {
  const std::vector<FigurePaths> parts = with_parts(paths);
  std::vector<std::pair<const FigurePaths*, const FigureSurface*>> surfaces;
  std::set<fs::path> folders;  // two pictures may show one part
  for (const FigurePaths& part : parts)
    for (const FigureSurface& surface : part.figure.surfaces)
      if (folders.insert(part.surface(surface.name)).second) surfaces.emplace_back(&part, &surface);
  side_by_side(surfaces.size(), programs_at_once(paths.options),
               [&](std::size_t i) { make_surface(*surfaces[i].first, *surfaces[i].second); });
}

}  // namespace bake
