// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <omp.h>

#include <charconv>
#include <tuple>

#include "analysis/cli/commands.h"
#include "solver/core/errors.h"
#include "solver/scene/entry.h"

namespace bake::render {
namespace {

/// The number, or 0 where there is none that is allowed.
int pixels_in(std::string_view digits) {
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc() && end == digits.data() + digits.size() && pixels.contains(value) ? value : 0;
}

}  // namespace

int thread_count(int threads) { return threads > 0 ? threads : omp_get_num_procs(); }

std::pair<int, int> size_in_pixels(const std::string& option, const std::string& size) {
  const std::size_t x = size.find('x');
  const int width = pixels_in(std::string_view(size).substr(0, x));
  const int height = x == std::string::npos ? 0 : pixels_in(std::string_view(size).substr(x + 1));
  if (width == 0 || height == 0)
    throw InputError(fmt::format("{}: found '{}', allowed: WIDTHxHEIGHT, each {}, as in 1280x960", option, quotable(size), pixels.words));
  return {width, height};
}

void check_ending(const std::filesystem::path& file, const char* ending) {
  if (file.extension() != ending)
    throw InputError(fmt::format("--out: found {}, allowed: a name that ends in {}", quotable_path(file), ending));
}

void PictureOptions::add_to(CLI::App& command) {
  command.add_option("view", view, "how the picture is taken: a TOML file, see bake-render explain")->required();
  command.add_option("--results", results,
                     "folder of the run that the files show: one for all, or one for each [found from frames themselves]");
  command.add_option("--set", overrides, "key=value: changes a value of the view, e.g. camera.angle_of_view_deg=40")
      ->allow_extra_args(false);
  command.add_option("--size", size, "WIDTHxHEIGHT in pixels instead of the view's");
  command.add_option("--samples", samples, "most paths of light per pixel instead of the view's (slices need none)")
      ->transform(whole_number(1, 1000000));
  add_threads_option(command, threads);
}

View PictureOptions::read() const {
  View result = view.empty() ? parse_view("", "command line", overrides) : read_view(view, overrides);
  if (samples > 0) result.picture.samples = samples;
  if (size.empty()) return result;
  std::tie(result.picture.width_px, result.picture.height_px) = size_in_pixels("--size", size);
  return result;
}

std::vector<std::filesystem::path> PictureOptions::results_of(std::size_t files) const {
  if (results.size() > 1 && results.size() != files)
    throw InputError(fmt::format("--results: found {} folders for {} files, allowed: one for all or one for each", results.size(), files));
  std::vector<std::filesystem::path> folders = results;
  folders.resize(files, results.empty() ? std::filesystem::path() : results.front());
  return folders;
}

}  // namespace bake::render
