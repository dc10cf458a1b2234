// SPDX-License-Identifier: MIT
#include "solver/run/run.h"

#include <fmt/format.h>
#include <omp.h>
#include <sys/resource.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "solver/io/background_writer.h"
#include "solver/io/checkpoint.h"
#include "solver/io/ledger_file.h"
#include "solver/io/progress.h"
#include "solver/io/provenance.h"
#include "solver/io/scratch_folder.h"
#include "solver/run/check_scene.h"
#include "solver/run/describe_bodies.h"
#include "solver/run/ledger.h"
#include "solver/run/simulation.h"
#include "solver/scene/describe.h"
#include "solver/scene/resolved.h"
#include "solver/scene/scene.h"
#include "solver/scene/warnings.h"

namespace bake {

namespace {

volatile std::sig_atomic_t g_stop_asked = 0;

/// On SIGINT or SIGTERM the run stops after the current step; a second signal ends the program as usual.
class StopSignals {
 public:
  StopSignals() {
    g_stop_asked = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { g_stop_asked = 1; };
    action.sa_flags = SA_RESETHAND;
    sigaction(SIGINT, &action, &old_int_);
    sigaction(SIGTERM, &action, &old_term_);
  }
  ~StopSignals() {
    sigaction(SIGINT, &old_int_, nullptr);
    sigaction(SIGTERM, &old_term_, nullptr);
  }
  static bool asked() { return g_stop_asked != 0; }

 private:
  struct sigaction old_int_, old_term_;
};

/// The files of a run in the folder of its results.
struct ResultFiles {
  std::filesystem::path folder;
  std::filesystem::path frames() const { return folder / "frames"; }
  std::filesystem::path series() const { return folder / "frames.hdf.series"; }
  std::filesystem::path ledger() const { return folder / "ledger.csv"; }
  std::filesystem::path checkpoint() const { return folder / "checkpoint.h5"; }
  std::filesystem::path description() const { return folder / "run.json"; }
};

double frame_time(const Scene& scene, int frame) { return frame / scene.run.frame_rate_per_s; }

int frame_count(const Scene& scene, const RunOptions& options) {
  if (options.frames) return *options.frames;
  return std::max(1, static_cast<int>(std::ceil(scene.run.end_s * scene.run.frame_rate_per_s - 1e-9)));
}

void save_checkpoint(const Scene& scene, const ResultFiles& results, const Simulation& simulation, int frame) {
  CheckpointWriter out(results.checkpoint(), scene_fingerprint(scene), scene.run.precision);
  simulation.write(out);
  out.set("frame", static_cast<std::int64_t>(frame));
  out.commit();
}

void save_series(const Scene& scene, const ResultFiles& results, int frames) {
  std::vector<SeriesEntry> entries;
  for (int f = 0; f <= frames; ++f) entries.push_back({"frames/" + frame_name(f), frame_time(scene, f)});
  write_series(results.series(), entries);
}

/// Writes what a frame leaves; the ledger comes last, so that its rows are those of whole frames.
void save_frame(const Scene& scene, const ResultFiles& results, int frame, double time_s, const FrameData& data, LedgerFile& ledger,
                const std::vector<double>& row) {
  try {
    write_frame(results.frames() / frame_name(frame), time_s, data);
    save_series(scene, results, frame);
    ledger.append(row);
  } catch (const OutputError& error) {
    throw OutputError(fmt::format("frame {}: {}", frame, error.what()));
  }
}

double value(const std::vector<double>& row, std::string_view column) {
  const auto names = ledger_columns();
  return row[static_cast<std::size_t>(std::find(names.begin(), names.end(), column) - names.begin())];
}

std::string summary_text(const Scene& scene, const ResultFiles& results, const std::vector<double>& first, const std::vector<double>& last,
                         double inertia_scale, double wall, std::int64_t particle_steps) {
  const auto now = [&](std::string_view c) { return value(last, c); };
  std::string text =
      fmt::format("{}: {:.4g} s simulated, {} particles, {} steps\n", scene.title.empty() ? scene.file.stem().string() : scene.title,
                  now("time_s"), std::int64_t(now("particles")), std::int64_t(now("steps")));
  if (value(first, "volume_m3") > 0)
    text += fmt::format("  volume       x {:.3f} ({:.4g} m^3)\n", now("volume_m3") / value(first, "volume_m3"), now("volume_m3"));
  if (is_of_scene(scene, "temperature_mean_C"))
    text += fmt::format("  temperature  {:.1f} to {:.1f} C, mean {:.1f} C\n", now("temperature_min_C"), now("temperature_max_C"),
                        now("temperature_mean_C"));
  if (value(first, "water_mass_kg") > 0)
    text += fmt::format("  water lost   {:.4g} kg ({:.2f} %)\n", now("water_evaporated_kg"),
                        100 * now("water_evaporated_kg") / value(first, "water_mass_kg"));
  if (is_of_scene(scene, "gas_mol")) text += fmt::format("  gas made     {:.4g} mol\n", now("gas_mol"));
  if (inertia_scale != 1 && now("elastic_J") > 0)
    text += fmt::format("  inertia      x {:g}; kinetic energy is {:.2g} of the elastic one: small means quasi-static\n", inertia_scale,
                        now("kinetic_J") / now("elastic_J"));
  if (now("clamped_particles") > 0) text += fmt::format("  held at the domain's faces: {} times\n", std::int64_t(now("clamped_particles")));
  if (now("retired_particles") > 0) text += fmt::format("  retired at open faces: {} particles\n", std::int64_t(now("retired_particles")));
  text += fmt::format("  speed        {:.2f} million particle-steps/s ({:.1f} s)\n",
                      wall > 0 ? static_cast<double>(particle_steps) / wall / 1e6 : 0, wall);
  text += fmt::format("  results      {}", results.folder.string());
  return text;
}

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * static_cast<double>(usage.ru_maxrss);
}

/// The load average of the last minute. If it exceeds the number of cores, other processes slowed this run down.
double load_average() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : std::nan("");
}

/// Writes run.json: what the run is, and its state so far. `wall`: the seconds that `particle_steps` took, including those before the run
/// was resumed.
void save_description(const Scene& scene, const ResultFiles& results, const char* state, const std::vector<double>& row, double wall,
                      std::int64_t particle_steps) {
  nlohmann::json summary;
  const auto names = ledger_columns();
  for (std::size_t i = 0; i < row.size(); ++i) summary[names[i]] = row[i];
  summary["state"] = state;
  summary["wall_s"] = wall;
  summary["particle_steps"] = particle_steps;
  summary["peak_memory_bytes"] = peak_memory_bytes();
  summary["load_average"] = load_average();
  nlohmann::json made = provenance();
  made["threads"] = omp_get_max_threads();
  made["seed"] = scene.run.seed;
  const nlohmann::json all{{"scene", resolved(scene)}, {"provenance", made}, {"summary", summary}};
  write_text_atomically(results.description(), all.dump(2) + "\n");
}

/// The seconds that the run took before it is resumed; 0 if its description is lost. They are not part of the checkpoint, so that an
/// interrupted run ends with the same checkpoint, bit for bit, as an uninterrupted one.
double wall_so_far(const ResultFiles& results) {
  std::ifstream in(results.description());
  const nlohmann::json run = nlohmann::json::parse(in, nullptr, false);
  return run.is_object() ? run.value(nlohmann::json::json_pointer("/summary/wall_s"), 0.0) : 0.0;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InputError(folder.string() + ": cannot make this folder: " + error.message() + ", allowed: a place that can be written (--out)");
}

void clear_old(const ResultFiles& results) {
  std::error_code ignored;
  for (const auto& path : {results.series(), results.ledger(), results.checkpoint(), results.description()})
    std::filesystem::remove(path, ignored);
  std::filesystem::remove_all(results.frames(), ignored);
}

}  // namespace

RunSummary run_scene(const Scene& scene, const RunOptions& options) {
  const StopSignals signals;
  if (options.threads > 0) omp_set_num_threads(options.threads);
  const ResultFiles results{options.out};
  const int threads = omp_get_max_threads(), frames = frame_count(scene, options);

  std::unique_ptr<Simulation> simulation;
  int frame = 0;
  double wall_before = 0;
  if (options.resume) {
    const CheckpointReader checkpoint(results.checkpoint());
    checkpoint.expect(scene_fingerprint(scene), scene.run.precision);
    simulation = Simulation::resume(scene, checkpoint);
    frame = static_cast<int>(checkpoint.value<std::int64_t>("frame"));
    wall_before = wall_so_far(results);
  } else {
    simulation = Simulation::begin(scene);  // before anything is written, so that a bad scene leaves old results untouched
    make_folder(results.folder);
    clear_old(results);
  }
  make_folder(results.frames());

  const double began = steady_seconds();
  const auto wall = [&] { return wall_before + steady_seconds() - began; };
  const std::int64_t old_steps = simulation->counters().particle_steps;
  Progress progress(progress_on_stderr(options.quiet));
  std::vector<double> first = ledger_row(*simulation), last = first;
  LedgerFile ledger = options.resume ? LedgerFile::resume(results.ledger(), ledger_columns(), frame_time(scene, frame))
                                     : LedgerFile::create(results.ledger(), ledger_columns());
  if (options.resume)
    first = last = read_ledger(results.ledger()).rows.at(0);
  else
    save_frame(scene, results, 0, simulation->time(), simulation->frame(), ledger, first);
  save_description(scene, results, "running", last, wall(), simulation->counters().particle_steps);
  BackgroundWriter writer;  // behind all that its jobs use

  const auto stand = [&](int done) {
    return Standing{done,
                    frames,
                    simulation->time(),
                    frame_time(scene, frames),
                    simulation->dt(),
                    static_cast<std::uint64_t>(simulation->counters().particle_steps - old_steps)};
  };
  const auto finish = [&](const char* state) {
    save_description(scene, results, state, last, wall(), simulation->counters().particle_steps);
    return summary_text(scene, results, first, last, simulation->inertia_scale(), steady_seconds() - began,
                        simulation->counters().particle_steps - old_steps);
  };
  const auto advance = [&] {
    try {
      return simulation->advance(frame_time(scene, frame + 1), frame_time(scene, frame + 2), [&] {
        progress.update(stand(frame));
        writer.check();
        return !StopSignals::asked();
      });
    } catch (const RunError&) {
      writer.finish();
      save_description(scene, results, "failed", last, wall(), simulation->counters().particle_steps);
      throw;
    }
  };
  while (frame < frames) {
    const bool reached = advance();
    if (reached) {
      ++frame;
      last = ledger_row(*simulation);
      writer.put([&, frame, time = simulation->time(), data = simulation->frame(), row = last] {
        omp_set_num_threads(writer.owner_waits() ? threads : 1);  // of this thread's own loops: the steps need the cores
        save_frame(scene, results, frame, time, data, ledger, row);
      });
      progress.update(stand(frame));
    }
    const bool stop = StopSignals::asked() && frame < frames;
    if (stop || frame == frames || (reached && frame % scene.run.checkpoint_every_frames == 0)) {
      writer.finish();  // a checkpoint knows of no frame that is not there
      save_checkpoint(scene, results, *simulation, frame);
      save_description(scene, results, "running", last, wall(),
                       simulation->counters().particle_steps);  // a killed run must not lose the time that it took
    }
    if (stop)
      return {finish("interrupted") +
                  fmt::format("\n  interrupted at {:.6g} s; checkpoint written, continue with --resume", simulation->time()),
              true};
  }
  return {finish("done"), false};
}

namespace {

/// Seconds per particle on this machine.
struct Costs {
  double step = 0, frame = 0;
};

/// Measures them by 20 steps and a frame at the start of a simulation.
Costs try_out(Simulation& simulation, double end) {
  const double began = steady_seconds();
  int steps = 20;
  simulation.advance(end, end, [&] { return --steps > 0; });
  const double taken = steady_seconds() - began;
  const ScratchFolder scratch;
  simulation.write_frame_file(scratch / frame_name(0));  // the first frame takes much longer than later ones
  const double again = steady_seconds();
  simulation.write_frame_file(scratch / frame_name(1));
  const double particles = std::max(static_cast<double>(simulation.particles()), 1.0);
  return {taken / std::max(static_cast<double>(simulation.counters().particle_steps), 1.0), (steady_seconds() - again) / particles};
}

}  // namespace

std::string describe_scene(const Scene& scene, int threads) {
  if (threads > 0) omp_set_num_threads(threads);
  check_scene(scene);
  std::string effects;
  for (const std::string& e : scene.effects) effects += (effects.empty() ? "" : ", ") + e;
  std::string text = fmt::format("{}\n  effects      {}\n  precision    {}\n",
                                 scene.title.empty() ? scene.file.stem().string() : scene.title, effects, word_of(scene.run.precision));
  text += describe_bodies(scene);
  std::optional<Costs> costs;
  std::string tried;
  for (const Quality quality : {Quality::draft, Quality::standard, Quality::paper}) {
    Scene at = scene;
    at.quality = quality;
    std::unique_ptr<Simulation> simulation;
    try {
      simulation = Simulation::begin(at);
    } catch (const InputError& error) {
      text += fmt::format("  {:<12} cannot be run: {}\n", word_of(quality), error.what());
      continue;
    }
    const auto n = static_cast<double>(simulation->particles());
    if (!costs) {
      text += fmt::format("  memory       {}\n", simulation->memory_words());
      costs = try_out(*simulation, scene.run.end_s);
      tried = word_of(quality);
    }
    const double steps = simulation->dt() > 0 ? std::ceil(scene.run.end_s / simulation->dt()) : 0;
    const double frames = scene.run.end_s * scene.run.frame_rate_per_s;
    text += fmt::format("  {:<12} dx {:.4g} m, {:.0f} particles, {:.0f} MB ({:.0f} bytes per particle), about {:.0f} steps, {}\n",
                        word_of(quality), at.dx(), n, static_cast<double>(simulation->bytes()) / 1e6,
                        n > 0 ? static_cast<double>(simulation->bytes()) / n : 0, steps,
                        n > 0 ? clock_text(n * (steps * costs->step + frames * costs->frame)) : "no time at all");
  }
  for (const std::string& warning : warnings_about(scene)) text += fmt::format("  warning      {}\n", warning);
  return text +
         fmt::format("  (steps from the first step's length; time from a trial of 20 steps and a frame at {} on this machine)", tried);
}

}  // namespace bake
