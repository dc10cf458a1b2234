// SPDX-License-Identifier: MIT
#include "analysis/pictures/picture.h"

#include <fmt/format.h>

#include <memory>

#include "analysis/cli/commands.h"
#include "analysis/surface/splat.h"
#include "solver/scene/input_error.h"

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
  command->callback([&action, options] {
    action = [options] {
      check_ending(options->out, ".png");
      Histories histories;
      Meter meter(options->out.filename().string());
      write_png(options->out, take_picture(options->read(), options->files, options->results_of(options->files.size()), histories,
                                           thread_count(options->threads), [&](double share) { meter(share); }));
    };
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
  command->add_option("--spacing", options->spacing_m, "typical distance of particles in m [measured]")->check(CLI::PositiveNumber);
  add_threads_option(*command, options->threads);
  command->callback([&action, options] {
    action = [options] {
      check_ending(options->out, ".hdf");
      write_mesh(options->out,
                 splat_surface(read_particles_of_frame(options->frame), {options->spacing_m, thread_count(options->threads)}));
    };
  });
}

void add_explain_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("explain", "All keys of a view file");
  command->callback([&action] { action = [] { fmt::print("{}", explain_view()); }; });
}

}  // namespace bake::render
