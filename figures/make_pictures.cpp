// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "figures/made.h"
#include "figures/programs.h"
#include "figures/steps.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

/// The file of a run or surface at a time: a frame, or the surface at that frame.
fs::path input_file(const Place& place, const std::string& name, std::optional<double> time_s) {
  const FigureSurface* surface = find_named(place.figure.surfaces, name);
  const fs::path run = place.run(surface ? surface->run : name);
  const std::string frame = frame_name(Results(run).frame_at(time_s));
  return (surface ? place.surface(name) : run / "frames") / frame;
}

std::vector<fs::path> inputs_of(const Place& place, const FigurePicture& picture) {
  std::vector<std::optional<double>> times(picture.times_s.begin(), picture.times_s.end());
  if (times.empty()) times.push_back(std::nullopt);
  std::vector<fs::path> files;
  for (const std::string& name : picture.of)
    for (const auto& time : times) files.push_back(input_file(place, name, time));
  return files;
}

void make_picture(const Place& place, const FigurePicture& picture) {
  const fs::path view = view_file(place.figure, picture), made = place.item_folder() / (picture.name + ".png");
  const std::vector<fs::path> inputs = inputs_of(place, picture);
  std::vector<std::string> words{choice_names(picture.kind)[static_cast<std::size_t>(picture.kind)], view.string()};
  nlohmann::json from{stamp(view), stamp(find_program("bake-render"))};
  for (const fs::path& input : inputs) {
    words.push_back(input.string());
    from.push_back(stamp(input));
  }
  words.insert(words.end(), {"--out", made.string()});
  from.push_back(words);
  if (is_made(made, from)) return;
  say(place.options, fmt::format("picture {}", picture.name));
  call_program("bake-render", words, place.item_folder() / (picture.name + ".log"));
  note_made(made, from);
}

}  // namespace

void make_pictures(const Place& place) {
  for (const FigurePicture& picture : place.figure.pictures) make_picture(place, picture);
}

}  // namespace bake
