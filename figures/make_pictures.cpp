// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "figures/made.h"
#include "figures/programs.h"
#include "figures/steps.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

/// What a picture shows: a frame of a run, or the surface at that frame.
struct Input {
  fs::path file;
  fs::path results;  ///< of the run; bake-render reads its history
};

Input input_of(const Place& place, const std::string& name, std::optional<double> time_s) {
  const FigureSurface* surface = find_named(place.figure.surfaces, name);
  const fs::path run = place.run(surface ? surface->run : name);
  const std::string frame = frame_name(Results(run).frame_at(time_s));
  return {(surface ? place.surface(name) : run / "frames") / frame, run};
}

std::vector<Input> inputs_of(const Place& place, const FigurePicture& picture) {
  std::vector<std::optional<double>> times(picture.times_s.begin(), picture.times_s.end());
  if (times.empty()) times.push_back(std::nullopt);
  std::vector<Input> inputs;
  for (const std::string& name : picture.of)
    for (const auto& time : times) inputs.push_back(input_of(place, name, time));
  return inputs;
}

std::vector<std::string> render_arguments(const Place& place, const FigurePicture& picture, const std::vector<Input>& inputs,
                                          const fs::path& out) {
  std::vector<std::string> words{word_of(picture.kind), view_file(place.figure, picture).string()};
  for (const Input& input : inputs) words.push_back(input.file.string());
  words.insert(words.end(), {"--out", out.string()});
  for (const Input& input : inputs) words.insert(words.end(), {"--results", input.results.string()});
  if (!place.options.size.empty()) words.insert(words.end(), {"--size", place.options.size});
  if (place.options.samples > 0) words.insert(words.end(), {"--samples", std::to_string(place.options.samples)});
  return words;
}

void make_picture(const Place& place, const FigurePicture& picture) {
  const fs::path made = place.item_folder() / (picture.name + ".png");
  const std::vector<Input> inputs = inputs_of(place, picture);
  auto words = render_arguments(place, picture, inputs, made);
  nlohmann::json from{words, stamp(view_file(place.figure, picture)), stamp(find_program("bake-render"))};
  for (const Input& input : inputs) from.push_back(stamp(input.file));
  if (is_made(made, from)) return;
  say(place.options, fmt::format("picture {}", picture.name));
  if (place.options.threads > 0) words.insert(words.end(), {"--threads", std::to_string(place.options.threads)});  // same picture
  call_program("bake-render", words, place.item_folder() / (picture.name + ".log"));
  note_made(made, from);
}

}  // namespace

void make_pictures(const Place& place) {
  for (const FigurePicture& picture : place.figure.pictures) make_picture(place, picture);
}

}  // namespace bake
