// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/cli/commands.h"
#include "analysis/image/montage.h"
#include "analysis/pictures/picture.h"
#include "analysis/slices/slice.h"
#include "analysis/surface/splat.h"
#include "solver/core/errors.h"
#include "solver/io/progress.h"
#include "solver/scene/entry.h"

namespace bake::render {

void add_picture_command(CLI::App& app, Action& action) {
  struct Options : PictureOptions {
    std::vector<std::filesystem::path> files;
    std::filesystem::path out;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("picture", "A photo-like picture of frames, surfaces or meshes");
  options->add_to(*command);
  command->add_option("files", options->files, "frames or meshes, one for each [[object]] of the view")->required();
  command->add_option("--out", options->out, "the picture, a PNG file")->required();
  on_request(*command, action, [options] {
    check_ending(options->out, ".png");
    Histories histories;
    Meter meter(options->out.filename().string());
    write_png(options->out, take_picture(options->read(), options->files, options->results_of(options->files.size()), histories,
                                         thread_count(options->threads), [&](double share) { meter(share); }));
  });
}

namespace {

struct SliceOptions : PictureOptions {
  std::vector<std::filesystem::path> files;
  std::filesystem::path out;
  std::string by, cut;

  /// Without a view the first file stands where it would; `by` and `cut` are values of the view under short names.
  void put_in() {
    const bool has_view = view.extension() == ".toml";
    if (!has_view) files.insert(files.begin(), std::exchange(view, {}));
    if (files.empty()) throw InputError("files: missing, allowed: frames or meshes");
    if (!by.empty()) overrides.push_back(fmt::format("panel=[{{ field = {} }}]", nlohmann::json(by).dump()));
    if (cut.empty()) {
      if (!has_view) overrides.emplace_back("slice.cut=false");
      return;
    }
    const std::size_t axis = std::string_view("xyz").find(cut[0]);
    if (axis == std::string::npos || cut.size() < 3 || cut[1] != '=')
      throw InputError(fmt::format("--cut: found '{}', allowed: x=, y= or z= and a number of metres, as in y=0", quotable(cut)));
    std::array<std::string, 3> point{"0", "0", "0"}, normal = point;
    point[axis] = cut.substr(2);
    normal[axis] = "-1";
    overrides.push_back(fmt::format("slice.point_m=[{}]", fmt::join(point, ", ")));
    overrides.push_back(fmt::format("slice.normal=[{}]", fmt::join(normal, ", ")));
  }
};

}  // namespace

void add_slice_command(CLI::App& app, Action& action) {
  using Options = SliceOptions;
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("slice", "A technical picture: bodies cut open, coloured by the fields of the view's [[panel]]s");
  options->add_to(*command);
  command->get_option("view")->description("a view, if there is one, before the frames or meshes");
  command->add_option("files", options->files, "frames or meshes");
  command->add_option("--by", options->by, "the field that is shown, instead of the view's [[panel]]s");
  command->add_option("--cut", options->cut, "y=0: what lies below on that axis is taken away; without a view or this nothing is");
  command->add_option("--out", options->out, "the picture, a PNG file")->required();
  on_request(*command, action, [options] {
    check_ending(options->out, ".png");
    options->put_in();
    write_png(options->out,
              take_slices(options->read(), options->files, options->results_of(options->files.size()), thread_count(options->threads)));
  });
}

namespace {

struct MontageOptions {
  std::vector<std::filesystem::path> pictures;
  std::vector<std::string> labels, rows;
  std::string cell = "640x480";
  std::filesystem::path out;
  int columns = 0;

  /// The pictures where the rows have the names of their files.
  Image in_rows() const {
    const Layout layout = layout_of(rows);
    if (!layout.problem.empty()) throw InputError("--row: " + layout.problem);
    if (layout.places.size() != pictures.size())
      throw InputError(fmt::format("--row: found {} names for {} pictures, allowed: one for each", layout.places.size(), pictures.size()));
    std::vector<Image> images;
    for (const Place& place : layout.places) {
      const auto is_named = [&](const std::filesystem::path& file) { return file.stem() == place.name; };
      const auto file = std::find_if(pictures.begin(), pictures.end(), is_named);
      if (file == pictures.end())
        throw InputError(fmt::format("--row: found '{}', allowed: names of the pictures' files, without .png", quotable(place.name)));
      images.push_back(read_png(*file));
    }
    const auto [width, height] = size_in_pixels("--cell", cell);
    return tiled(images, layout, width, height);
  }

  Image side_by_side() const {
    if (!labels.empty() && labels.size() != pictures.size())
      throw InputError(
          fmt::format("--label: found {} labels for {} pictures, allowed: one for each or none", labels.size(), pictures.size()));
    std::vector<Image> images;
    for (const auto& picture : pictures) images.push_back(read_png(picture));
    return montage(images, labels, columns > 0 ? columns : static_cast<int>(images.size()));
  }
};

}  // namespace

void add_montage_command(CLI::App& app, Action& action) {
  using Options = MontageOptions;
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("montage", "Pictures side by side with labels, or as tiles of a grid");
  command->add_option("pictures", options->pictures, "PNG files")->required();
  command->add_option("--out", options->out, "the montage, a PNG file")->required();
  auto* label = command->add_option("--label", options->labels, "text below a picture; one for each, in order")->allow_extra_args(false);
  auto* columns = command->add_option("--columns", options->columns, "pictures in a row [all]")->transform(whole_number(1, 1000));
  auto* row = command
                  ->add_option("--row", options->rows,
                               "\"one two two\": a row of a grid, by the names of the files; a picture fills all cells with its name")
                  ->allow_extra_args(false)
                  ->excludes(label)
                  ->excludes(columns);
  command->add_option("--cell", options->cell, "with --row: size of a cell in pixels [640x480]")->needs(row);
  on_request(*command, action, [options] {
    check_ending(options->out, ".png");
    write_png(options->out, options->rows.empty() ? options->side_by_side() : options->in_rows());
  });
}

void add_surface_command(CLI::App& app, Action& action) {
  struct Options {
    std::filesystem::path frame, out;
    double spacing_m = 0;
    int threads = 0;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("surface", "A closed smooth surface around a frame's particles, with their fields");
  command->add_option("frame", options->frame, "a frame of a run")->required();
  command->add_option("--out", options->out, "the surface, an .hdf file")->required();
  command->add_option("--spacing", options->spacing_m, "typical distance of particles in m [measured]")->check(number(1e-9, 1e6, "m"));
  add_threads_option(*command, options->threads);
  on_request(*command, action, [options] {
    check_ending(options->out, ".hdf");
    write_mesh(options->out, splat_surface(read_particles_of_frame(options->frame), {options->spacing_m, thread_count(options->threads)}));
  });
}

void add_explain_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("explain", "All keys of a view file");
  on_request(*command, action, [] { fmt::print("{}", explain_view()); });
}

}  // namespace bake::render
