// SPDX-License-Identifier: MIT
#include "experiments/table01_timings/timings.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "claims/results.h"
#include "figures/published.h"
#include "solver/scene/input_error.h"

namespace bake {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Machine {
  int number = 0;
  std::string name;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"number", &Machine::number, "1", Range{1, 9, false, false, "a whole number"}, "of the paper", Presence::required},
        Parameter{"name", &Machine::name, "", any_number, "processor and threads", Presence::required},
    };
  }
};

struct Timing {
  std::string name, elements, scene;
  double seconds_per_frame = 0;
  int machine = 0;
  double particles = 0;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &Timing::name, "", any_number, "as printed", Presence::required},
        Parameter{"seconds_per_frame", &Timing::seconds_per_frame, "s", positive, "average", Presence::required},
        Parameter{"machine", &Timing::machine, "1", Range{1, 9, false, false, "a whole number"}, "number of the machine",
                  Presence::required},
        Parameter{"elements", &Timing::elements, "", any_number, "as printed", Presence::required},
        Parameter{"particles", &Timing::particles, "1", positive, "of the simulation", Presence::required},
        Parameter{"scene", &Timing::scene, "", any_number, "ours of it: <experiment>/<scene>", Presence::required},
    };
  }
};

/// What a finished run has cost.
struct Run {
  std::string folder, quality;
  double particles, seconds_per_frame, particle_steps_per_s;
};

/// Was it made from experiments/<scene>.toml?
bool is_of(const json& description, const std::string& scene) {
  return fs::path(description.value("/scene/file"_json_pointer, std::string())).stem() == fs::path(scene).stem();
}

/// Of a scene's finished runs that with the most particles.
std::optional<Run> largest_run(const fs::path& results, const std::string& scene) {
  std::optional<Run> largest;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(results, none)) {
    if (!fs::exists(entry.path() / "run.json")) continue;
    try {
      const Results run(entry.path());
      const json& all = run.description();
      if (!is_of(all, scene)) continue;
      const json& summary = all["summary"];
      const double particles = summary["particles"], wall = summary["wall_s"], steps = summary["steps"];
      const double frames = std::max(1., static_cast<double>(run.column("time_s").size()) - 1);
      if (!largest || particles > largest->particles)
        largest = Run{entry.path().filename().string(), all.value("/scene/quality"_json_pointer, std::string()), particles, wall / frames,
                      particles * steps / wall};
    } catch (const InputError&) {
      // not done: no timing
    }
  }
  return largest;
}

}  // namespace

Computed table01_timings() { return compare_timings(BAKE_SOURCE_DIR, "results"); }

Computed compare_timings(const fs::path& root, const fs::path& results) {
  const PublishedFile published(root / "reference/published/table1.toml", {"machine", "simulation"});
  ComputedTable table{
      "timings",
      "Table 1: published seconds per frame, and those of the largest finished run of our scene in results/",
      {"simulation", "s/frame", "machine", "elements", "particles", "our run", "our particles", "our s/frame", "our M particle-steps/s"},
      {}};
  double with_a_run = 0, in_full = 0;
  const auto timings = published.list<Timing>("simulation");
  for (const Timing& t : timings) {
    std::vector<std::string> row{t.name, fmt::format("{:g}", t.seconds_per_frame), fmt::format("{}", t.machine), t.elements,
                                 fmt::format("{}K", t.particles / 1000)};
    if (const auto run = largest_run(results, t.scene)) {
      ++with_a_run;
      if (run->particles >= 0.98 * t.particles) ++in_full;
      for (const std::string& cell :
           {run->folder, fmt::format("{:.0f}K", run->particles / 1000), fmt::format("{:.3g}", run->seconds_per_frame),
            fmt::format("{:.3g}", run->particle_steps_per_s / 1e6)})
        row.push_back(cell);
    } else {
      row.insert(row.end(), {"not run", "", "", ""});
    }
    table.rows.push_back(row);
  }
  ComputedTable machines{"machines", "Machines of the paper", {"number", "machine"}, {}};
  for (const Machine& m : published.list<Machine>("machine")) machines.rows.push_back({fmt::format("{}", m.number), m.name});
  Computed computed;
  computed.tables = {table, machines};
  computed.numbers = {
      {"published_rows", "1", "simulations that the paper gives a timing of", static_cast<double>(timings.size())},
      {"rows_with_a_run", "1", "of these, those with a finished run in results/, at any quality", with_a_run},
      {"rows_at_published_size", "1", "of these, those with a run of the published number of particles", in_full},
  };
  return computed;
}

}  // namespace bake
