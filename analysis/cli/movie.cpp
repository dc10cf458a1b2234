// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "analysis/cli/commands.h"
#include "analysis/pictures/picture.h"
#include "solver/core/errors.h"
#include "solver/io/atomic_file.h"
#include "solver/io/child.h"
#include "solver/io/progress.h"
#include "solver/scene/entry.h"

namespace bake::render {
namespace {

namespace fs = std::filesystem;

/// The .hdf files in frames/ of a results folder, or in a folder of surfaces, sorted by name.
std::vector<fs::path> files_in(const fs::path& folder) {
  const fs::path place = fs::is_directory(folder / "frames") ? folder / "frames" : folder;
  if (!fs::is_directory(place))
    throw InputError(fmt::format("{}: no such folder, allowed: a run's results, or a folder of surfaces", quotable_path(folder)));
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(place))
    if (entry.path().extension() == ".hdf") files.push_back(entry.path());
  if (files.empty())
    throw InputError(fmt::format("{}: found no .hdf file, allowed: a run's results, or a folder of surfaces", quotable_path(folder)));
  std::sort(files.begin(), files.end());
  return files;
}

/// Every n-th of them, and the last.
std::vector<fs::path> thinned(const std::vector<fs::path>& files, int every) {
  std::vector<fs::path> some;
  for (std::size_t i = 0; i < files.size(); i += static_cast<std::size_t>(every)) some.push_back(files[i]);
  if (some.back() != files.back()) some.push_back(files.back());
  return some;
}

/// The pattern of ffmpeg's that names the numbered pictures of a folder; `file:` since a colon would name a protocol.
std::string numbered_pictures(const fs::path& folder) {
  std::string pattern = "file:";
  for (const char c : folder.string()) pattern += c == '%' ? "%%" : std::string(1, c);
  return pattern + "/%04d.png";
}

/// Makes a film of the first `count` numbered pictures, completely or not at all. Returns false if ffmpeg is not installed; throws
/// std::runtime_error if it fails.
bool film_from(const fs::path& folder, std::size_t count, double rate, const fs::path& film) {
  AtomicFile file(film);
  // H.264 needs an even number of pixels, and players assume the colours of television unless the film states them
  const std::string rate_per_s = fmt::format("{:g}", rate), from = numbered_pictures(folder), frames = std::to_string(count);
  const std::string look = "crop=trunc(iw/2)*2:trunc(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv",
                    to = "file:" + film.string() + ".part";
  const ChildEnd end = run_child({"ffmpeg", "-y",         "-loglevel", "error",     "-framerate",  rate_per_s, "-i",
                                  from,     "-frames:v",  frames,      "-vf",       look,          "-c:v",     "libx264",
                                  "-crf",   "18",         "-pix_fmt",  "yuv420p",   "-colorspace", "bt709",    "-color_primaries",
                                  "bt709",  "-color_trc", "bt709",     "-movflags", "+faststart",  "-f",       "mp4",
                                  to});
  if (end.start_error != 0) return false;
  if (end.exit_code != 0) throw RunError(fmt::format("ffmpeg failed; the pictures are in {}", quotable_path(folder)));
  file.commit();
  return true;
}

struct Options : PictureOptions {
  fs::path folder, out;
  int every = 1;
  double rate = 24;
};

/// One camera for the whole movie, into whose picture the first and the last frame fit.
Stage stage_of(const View& view, const std::vector<fs::path>& files, const fs::path& results, int threads) {
  std::vector<Vec3f> points;
  for (const fs::path& file : {files.back(), files.front()}) {
    Histories histories;
    const auto more = points_of(compose(view, {file}, {results}, histories, threads));
    points.insert(points.end(), more.begin(), more.end());
  }
  return set_stage(view, points);
}

void make_movie(const Options& options) {
  const View view = options.read();
  const int threads = thread_count(options.threads);
  const std::vector<fs::path> files = thinned(files_in(options.folder), options.every);
  const fs::path results = options.results_of(1).front();
  const Stage stage = stage_of(view, files, results, threads);
  fs::create_directories(options.out);
  Histories histories;
  Meter meter(options.out.filename().string());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto progress = [&](double share) { meter((static_cast<double>(i) + share) / static_cast<double>(files.size())); };
    write_png(options.out / fmt::format("{:04}.png", i),
              take_picture(view, compose(view, {files[i]}, {results}, histories, threads), stage, threads, progress));
  }
  meter.clear();
  const fs::path film = options.out / "movie.mp4";
  if (film_from(options.out, files.size(), options.rate, film))
    fmt::print("{}\n", film.string());
  else
    fmt::print("{} pictures in {}; to get an mp4, apt-get install ffmpeg\n", files.size(), options.out.string());
}

}  // namespace

void add_movie_command(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("movie", "Numbered pictures of all frames of a run, and an mp4 if ffmpeg is there");
  options->add_to(*command);
  command->add_option("folder", options->folder, "results of a run, or a folder of surfaces")->required();
  command->add_option("--out", options->out, "folder of the pictures")->required();
  command->add_option("--every", options->every, "take every n-th frame, and the last [1]")->transform(whole_number(1, 1000000));
  command->add_option("--rate", options->rate, "pictures per second of the mp4 [24]")->check(number(0.01, 1000));
  on_request(*command, action, [options] { make_movie(*options); });
}

}  // namespace bake::render
