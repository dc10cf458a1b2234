// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/image/layout.h"
#include "experiments/make/pipeline.h"
#include "experiments/make/programs.h"
#include "experiments/make/side_by_side.h"
#include "experiments/make/up_to_date.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

/// What a picture shows: a frame of a run, the surface or the skins at that frame.
struct Input {
  fs::path file;
  fs::path results;  ///< folder of the run, whose history bake-render reads
};

Input input_of(const FigurePaths& paths, const std::string& name, std::optional<double> time_s) {
  if (name.ends_with(k_skin_of)) {
    const fs::path run = paths.run(name.substr(0, name.size() - k_skin_of.size()));
    return {run / "skins" / frame_name(Results(run).frame_at(time_s)), run};
  }
  const FigureSurface* surface = find_named(paths.figure.surfaces, name);
  const fs::path run = paths.run(surface ? surface->run : name);
  const std::string frame = frame_name(Results(run).frame_at(time_s));
  return {(surface ? paths.surface(name) : run / "frames") / frame, run};
}

std::vector<Input> inputs_of(const FigurePaths& paths, const FigurePicture& picture) {
  std::vector<std::optional<double>> times(picture.times_s.begin(), picture.times_s.end());
  if (times.empty()) times.push_back(std::nullopt);
  std::vector<Input> inputs;
  for (const std::string& name : picture.of)
    for (const auto& time : times) inputs.push_back(input_of(shown_by(picture, paths), name, time));
  return inputs;
}

std::vector<std::string> render_arguments(const FigurePaths& paths, const FigurePicture& picture, const std::vector<Input>& inputs,
                                          const fs::path& out) {
  std::vector<std::string> words{word_of(picture.kind), view_file(paths.figure, picture.view).string()};
  for (const Input& input : inputs) words.push_back(input.file.string());
  words.insert(words.end(), {"--out", out.string()});
  for (const Input& input : inputs) words.insert(words.end(), {"--results", input.results.string()});
  if (!paths.options.size.empty()) words.insert(words.end(), {"--size", paths.options.size});
  if (paths.options.samples > 0) words.insert(words.end(), {"--samples", std::to_string(paths.options.samples)});
  return words;
}

/// The same picture as JPEG, a fortieth as large, for the report.
void make_small(const FigurePaths& paths, const std::string& name, const fs::path& png) {
  fs::path made = png;
  made.replace_extension(".jpg");
  const std::vector<std::string> words{"jpeg", png.string(), "--out", made.string()};
  const nlohmann::json from{words, stamp(png)};
  if (is_up_to_date(made, from)) return;
  call_program("bake-render", words, paths.item_folder() / (name + ".jpg.log"), paths.options.quiet);
  record_sources(made, from);
}

void make_picture(const FigurePaths& paths, const FigurePicture& picture) {
  const fs::path made = paths.item_folder() / (picture.name + ".png");
  const std::vector<Input> inputs = inputs_of(paths, picture);
  auto words = render_arguments(paths, picture, inputs, made);
  nlohmann::json from{words, stamp(view_file(paths.figure, picture.view)), stamp(find_program("bake-render"))};
  for (const Input& input : inputs) from.push_back(stamp(input.file));
  if (is_up_to_date(made, from)) return make_small(paths, picture.name, made);
  say(paths.options, fmt::format("picture {}", picture.name));
  if (paths.options.threads > 0) words.insert(words.end(), {"--threads", std::to_string(paths.options.threads)});  // same picture
  call_program("bake-render", words, paths.item_folder() / (picture.name + ".log"), paths.options.quiet);
  record_sources(made, from);
  make_small(paths, picture.name, made);
}

void make_montage(const FigurePaths& paths, const FigureMontage& montage) {
  const fs::path made = paths.item_folder() / (montage.name + ".png");
  std::vector<std::string> words{"montage"};
  nlohmann::json from = nlohmann::json::array();
  for (const Place& place : layout_of(montage.rows).places) {
    words.push_back((paths.item_folder() / (place.name + ".png")).string());
    from.push_back(stamp(words.back()));
  }
  for (const std::string& row : montage.rows) words.insert(words.end(), {"--row", row});
  words.insert(words.end(), {"--cell", fmt::format("{}x{}", montage.cell_width_px, montage.cell_height_px), "--out", made.string()});
  from.push_back({words, stamp(find_program("bake-render"))});
  if (!is_up_to_date(made, from)) {
    say(paths.options, fmt::format("montage {}", montage.name));
    call_program("bake-render", words, paths.item_folder() / (montage.name + ".log"), paths.options.quiet);
    record_sources(made, from);
  }
  make_small(paths, montage.name, made);
}

}  // namespace

void make_pictures(const FigurePaths& paths) {
  const auto& pictures = paths.figure.pictures;
  side_by_side(pictures.size(), programs_at_once(paths.options), [&](std::size_t i) { make_picture(paths, pictures[i]); });
  for (const FigureMontage& montage : paths.figure.montages) make_montage(paths, montage);
}

}  // namespace bake
