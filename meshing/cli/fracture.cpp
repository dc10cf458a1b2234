// SPDX-License-Identifier: GPL-3.0-or-later
// bake-mesh fracture <mesh> <results>
#include "meshing/fracture/fracture.h"

#include <fmt/format.h>

#include <memory>

#include "meshing/cli/commands.h"
#include "solver/io/progress.h"

namespace bake::cli {

void add_fracture_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<FractureOptions>();
  CLI::App& command = *app.add_subcommand("fracture", "Make the surfaces of the pieces into which a mesh broke during a run");
  command.add_option("mesh", options->mesh, "tetrahedra that `bake-mesh tets` made and the run started from")->required();
  command.add_option("results", options->results, "folder of the finished run")->required();
  command.add_option("--out", options->out, "folder for NNNN.hdf (surfaces) and fracture.json")->required()->type_name("DIR");
  command
      .add_option("--reference-time", options->reference_time_s,
                  "simulated time at which edges have their unstretched length: for a loaf that is torn, the end of baking [0]")
      ->type_name("SECONDS")
      ->check(number(0, 1e9, "s"));
  auto* frames = command.add_option("--frames", options->frames, "which frames, separated by commas [the last]");
  frames->type_name("N,N,...")->delimiter(',')->transform(whole_number(0, 1'000'000'000));
  command.add_option("--every", options->every, "every N-th frame")
      ->type_name("N")
      ->transform(whole_number(1, 1'000'000'000))
      ->excludes(frames);
  command.add_option("--stretch", options->stretch, "an edge breaks beyond this many times its unstretched length, and ... [2]")
      ->type_name("S")
      ->check(number(1, 1e6));
  command
      .add_option("--smallest-gap", options->smallest_gap_m, "... beyond this length, both in two frames that follow each other [1.5 dx]")
      ->type_name("METRES")
      ->check(number(0, 1e6, "m"));
  command
      .add_option("--void-ratio", options->void_ratio,
                  "... and if the tetrahedra around it hold this many times the volume of their dough [not asked]")
      ->type_name("R")
      ->check(number(1, 1e6));
  command
      .add_option(
          "--smallest-crack", options->smallest_crack,
          "cracks stay closed that are smaller than this many faces of a cell of the run's grid, dx^2 each: below 1 no grid resolves "
          "them [0]")
      ->type_name("FACES")
      ->check(number(0, 1e6));
  command.add_option("--first-particle", options->first_particle, "identity of the particle that is vertex 0 [0]")
      ->type_name("N")
      ->transform(whole_number(0, std::int64_t{1} << 40));
  on_request(command, action, [options] {
    Meter meter("fracture");
    const auto tell = [&](const std::string& line) {
      meter.clear();
      fmt::print("{}\n", line);
    };
    write_fracture(*options, tell, [&](double share) { meter(share); });
  });
}

}  // namespace bake::cli
