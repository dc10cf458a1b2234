// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "experiments/make/computed.h"
#include "experiments/make/published.h"
#include "solver/scene/entry.h"

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

constexpr double k_frames_per_s = 24;  ///< of the table, whatever a scene's own are

/// What a finished run has cost.
struct Run {
  std::string name;
  double particles, simulated_s, wall_s, particle_steps, memory_bytes, load;
  int threads;
  std::string cpu;

  double frames() const { return simulated_s * k_frames_per_s; }
  bool larger_than(const Run& other) const { return std::pair{particles, frames()} > std::pair{other.particles, other.frames()}; }
};

/// A run.json; nothing if it is not of experiments/<scene>.toml, not done, or of an older version.
std::optional<Run> read_run(const fs::path& file, const std::string& scene) {
  try {
    const json all = json::parse(read_text_file(file));
    if (fs::path(all.at("scene").at("file").get<std::string>()).stem() != fs::path(scene).stem()) return std::nullopt;
    const json& summary = all.at("summary");
    if (summary.at("state") != "done") return std::nullopt;
    const json& made = all.at("provenance");
    const fs::path folder = file.parent_path().filename();
    return Run{file.filename() == "run.json" ? folder.string() : file.stem().string() + " (stored)",
               summary.at("particles"),
               summary.at("time_s"),
               summary.at("wall_s"),
               summary.at("particle_steps"),
               summary.at("peak_memory_bytes"),
               summary.at("load_average"),
               made.at("threads"),
               made.at("machine").at("cpu")};
  } catch (const std::exception&) {
    return std::nullopt;  // not a run, or none that says what this table needs
  }
}

/// Of a scene's finished runs that with the most particles, of these the longest.
std::optional<Run> largest_run(const std::vector<fs::path>& descriptions, const std::string& scene) {
  std::optional<Run> largest;
  for (const fs::path& file : descriptions) {
    const auto run = read_run(file, scene);
    if (run && run->frames() > 0 && (!largest || run->larger_than(*largest))) largest = run;
  }
  return largest;
}

/// <results>/*/run.json, and those that were stored beside this table.
std::vector<fs::path> descriptions(const fs::path& root, const fs::path& results) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(results, none))
    if (fs::exists(entry.path() / "run.json")) files.push_back(entry.path() / "run.json");
  for (const auto& entry : fs::directory_iterator(root / "experiments/table01_timings/measured", none))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> cells_of(const Run& run) {
  return {run.name,
          fmt::format("{:.0f}K", run.particles / 1000),
          fmt::format("first {:.3g} s", run.simulated_s),
          fmt::format("{:.3g}", run.wall_s / run.frames()),
          fmt::format("{:.3g}", run.particle_steps / run.wall_s / 1e6),
          fmt::format("{:.0f} MB", run.memory_bytes / 1e6),
          fmt::format("{}, {} thread{}, load {:.1f}", run.cpu, run.threads, run.threads == 1 ? "" : "s", run.load)};
}

}  // namespace

Computed table01_timings() { return compare_timings(BAKE_SOURCE_DIR, "results"); }

Computed compare_timings(const fs::path& root, const fs::path& results) {
  const PublishedFile published(root / "reference/published/table1.toml", {"machine", "simulation"});
  ComputedTable table{"timings",
                      "Table 1: published seconds per frame, and those of our largest finished run, for frames of 1/24 s",
                      {"simulation", "s/frame", "machine", "elements", "particles", "our run", "our particles", "simulated", "our s/frame",
                       "our M particle-steps/s", "peak memory", "our machine"},
                      {}};
  double with_a_run = 0, in_full = 0;
  const auto timings = published.list<Timing>("simulation");
  const auto files = descriptions(root, results);
  for (const Timing& t : timings) {
    std::vector<std::string> row{t.name, fmt::format("{:g}", t.seconds_per_frame), fmt::format("{}", t.machine), t.elements,
                                 fmt::format("{}K", t.particles / 1000)};
    const auto run = largest_run(files, t.scene);
    const bool has_scene = fs::exists(root / "experiments" / (t.scene + ".toml"));
    const auto ours = run ? cells_of(*run) : std::vector<std::string>{has_scene ? "not run" : "no scene yet"};
    row.insert(row.end(), ours.begin(), ours.end());
    row.resize(table.header.size());
    table.rows.push_back(row);
    if (run) ++with_a_run;
    if (run && run->particles >= 0.98 * t.particles) ++in_full;
  }
  ComputedTable machines{"machines", "Machines of the paper", {"number", "machine"}, {}};
  for (const Machine& m : published.list<Machine>("machine")) machines.rows.push_back({fmt::format("{}", m.number), m.name});
  Computed computed;
  computed.tables = {table, machines};
  computed.numbers = {
      {"published_rows", "1", "simulations that the paper gives a timing of", static_cast<double>(timings.size())},
      {"rows_with_a_run", "1", "of these, those with a finished run, at any quality", with_a_run},
      {"rows_at_published_size", "1", "of these, those with a run of the published number of particles", in_full},
  };
  return computed;
}

}  // namespace bake
