// SPDX-License-Identifier: MIT
#include "solver/run/run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <malloc.h>
#include <omp.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "solver/core/tell.h"
#include "solver/io/background_writer.h"
#include "solver/io/checkpoint.h"
#include "solver/io/ledger_file.h"
#include "solver/io/progress.h"
#include "solver/io/provenance.h"
#include "solver/io/scratch_folder.h"
#include "solver/io/stop_signals.h"
#include "solver/run/check_scene.h"
#include "solver/run/describe_bodies.h"
#include "solver/run/fill_scene.h"
#include "solver/run/frame_times.h"
#include "solver/run/ledger.h"
#include "solver/run/results_folder.h"
#include "solver/run/simulation.h"
#include "solver/run/skins.h"
#include "solver/scene/describe.h"
#include "solver/scene/resolved.h"
#include "solver/scene/scene.h"
#include "solver/scene/warnings.h"

namespace bake {

namespace {

/// A descriptor that is held back, so that the end of a run can be written down when there are no others left.
class SpareDescriptor {
 public:
  ~SpareDescriptor() { give_up(); }
  void give_up() {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  }

 private:
  int descriptor_ = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
};

double value(const std::vector<double>& row, std::string_view column) {
  const auto names = ledger_columns();
  return row[static_cast<std::size_t>(std::find(names.begin(), names.end(), column) - names.begin())];
}

std::string summary_text(const Scene& scene, const ResultsFolder& results, const std::vector<double>& first,
                         const std::vector<double>& last, const Simulation& simulation, double wall, std::int64_t particle_steps) {
  const auto now = [&](std::string_view c) { return value(last, c); };
  std::string text =
      fmt::format("{}: {:.4g} s simulated, {} particles, {} steps\n", scene.title.empty() ? scene.file.stem().string() : scene.title,
                  now("time_s"), std::int64_t(now("particles")), std::int64_t(now("steps")));
  const double inertia_scale = simulation.inertia_scale();
  const Settling& settling = simulation.settling();
  if (settling.time > 0)
    text += fmt::format("  settled      for {:.4g} s before its time began, {:.3g} J damped; {}\n", settling.time, now("damped_J"),
                        settling.is_still ? "then it was still" : "it was NOT still then: see motion.settle_longest_s");
  const double volume = value(first, "volume_m3") + now("emitted_volume_m3"),
               water = value(first, "water_mass_kg") + now("emitted_water_mass_kg");
  if (volume > 0) text += fmt::format("  volume       x {:.3f} ({:.4g} m^3)\n", now("volume_m3") / volume, now("volume_m3"));
  if (is_of_scene(scene, "temperature_mean_C"))
    text += fmt::format("  temperature  {:.1f} to {:.1f} C, mean {:.1f} C\n", now("temperature_min_C"), now("temperature_max_C"),
                        now("temperature_mean_C"));
  if (water > 0)
    text += fmt::format("  water lost   {:.4g} kg ({:.2f} %)\n", now("water_evaporated_kg"), 100 * now("water_evaporated_kg") / water);
  if (is_of_scene(scene, "gas_mol")) text += fmt::format("  gas made     {:.4g} mol\n", now("gas_mol"));
  if (inertia_scale != 1 && now("elastic_J") > 0)
    text += fmt::format("  inertia      x {:g}; kinetic energy is {:.2g} of the elastic one: small means quasi-static\n", inertia_scale,
                        now("kinetic_J") / now("elastic_J"));
  if (now("clamped_particles") > 0) text += fmt::format("  held at the domain's faces: {} times\n", std::int64_t(now("clamped_particles")));
  if (now("retired_particles") > 0) text += fmt::format("  retired at open faces: {} particles\n", std::int64_t(now("retired_particles")));
  text += fmt::format("  speed        {:.2f} million particle-steps/s ({:.1f} s)\n",
                      wall > 0 ? static_cast<double>(particle_steps) / wall / 1e6 : 0, wall);
  text += fmt::format("  results      {}", results.path().string());
  return text;
}

/// Arrays of 12 MB and more go back to the system when they are freed. By itself glibc keeps all of the size of the largest one that was
/// freed before, and smaller arrays in their place: 7 bytes a particle at 4 million of them. Less than 8 MB stays for the next frame.
void give_back_large_arrays() {
  mallopt(M_MMAP_THRESHOLD, 12 << 20);
  mallopt(M_TRIM_THRESHOLD, 8 << 20);
}

/// From now on the peak is that of what follows: other runs may have gone before in this process.
void forget_peak_memory() {
  malloc_trim(0);  // what they gave back goes to the system
  std::ofstream("/proc/self/clear_refs") << "5";
}

/// The largest memory of this process since then.
double peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kilobytes = 0; word == "VmHWM:" && status >> kilobytes) return 1024 * kilobytes;
  return std::nan("");
}

/// The load average of the last minute. If it exceeds the number of cores, other processes slowed this run down.
double load_average() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : std::nan("");
}

/// The threads of a parallel loop: fewer than were asked for if the environment limits them (OMP_THREAD_LIMIT, OMP_DYNAMIC).
int threads_that_run() {
  int threads = 1;
#pragma omp parallel
#pragma omp single
  threads = omp_get_num_threads();
  return threads;
}

/// The seconds that the run took before it is resumed; 0 if its description is lost. They are not part of the checkpoint, so that an
/// interrupted run ends with the same checkpoint, bit for bit, as an uninterrupted one.
double wall_so_far(const ResultsFolder& results) {
  std::ifstream in(results.description());
  const nlohmann::json run = nlohmann::json::parse(in, nullptr, false);
  const nlohmann::json::json_pointer place("/summary/wall_s");
  return run.is_object() && run.contains(place) && run[place].is_number() ? run[place].get<double>() : 0;
}

/// A run from its start, or from a checkpoint, to its end.
class Run {
 public:
  Run(const Scene& scene, const RunOptions& options)
      : scene_(scene),
        options_(options),
        times_(scene, options.frames),
        results_(options.out),
        progress_(progress_on_stderr(options.quiet)) {}

  /// Makes the folder and writes the first frame. Throws InputError while old results are untouched, OutputError.
  void begin();
  /// Reads the checkpoint. Throws InputError, and then has changed nothing.
  void resume();
  /// Throws OutputError, RunError and std::bad_alloc.
  RunSummary go_on();
  /// Writes down that the run has failed, if that can be written.
  void fail() noexcept;

 private:
  void save_checkpoint() const;
  void save_series(int frame) const;
  std::function<void()> save_frame(int frame, const std::vector<double>& row);
  void flush_frames();
  void save_description(const char* state) const;
  bool advance();
  void expect_results() const;
  Standing standing() const;
  std::string finish(const char* state) const;
  double wall_here() const { return steady_seconds() - began_; }
  std::int64_t steps_here() const { return simulation_->counters().particle_steps - old_steps_; }

  const Scene& scene_;
  const RunOptions& options_;
  const FrameTimes times_;
  ResultsFolder results_;
  SpareDescriptor spare_;
  Progress progress_;
  std::unique_ptr<Simulation> simulation_;
  FrameWriter frames_;
  int frame_ = 0;                ///< the last one that was reached
  std::atomic<int> saved_ = -1;  ///< and that was written
  double began_ = steady_seconds(), wall_before_ = 0;
  std::int64_t old_steps_ = 0;        ///< particle-steps before it was resumed
  std::vector<double> first_, last_;  ///< rows of the ledger
  std::optional<LedgerFile> ledger_;
  std::optional<BackgroundWriter> writer_;  ///< behind all that its jobs use
};

void Run::begin() {
  simulation_ = Simulation::begin(scene_, times_(1));  // before anything is written, so that a bad scene leaves old results untouched
  results_.take(scene_, times_.end_s(), options_.replace);
  if (options_.resume && !options_.quiet)
    tell_user("bake: {}: found no checkpoint, so the run begins at its start", results_.path().string());
  results_.clear();
  first_ = last_ = ledger_row(*simulation_);
  began_ = steady_seconds();
  try {
    save_description("running");
    ledger_.emplace(LedgerFile::create(results_.ledger(), ledger_columns(scene_)));
    if (!scene_.skins.empty()) results_.make_skins();
    save_frame(0, first_)();
    save_series(0);
  } catch (const OutputError& error) {
    fail();
    throw RunError(error.what());
  } catch (...) {
    fail();
    throw;
  }
}

void Run::resume() {
  results_.take_to_resume();
  const CheckpointReader checkpoint(results_.checkpoint());
  checkpoint.expect(scene_fingerprint(scene_), scene_.run.precision, [&] { return results_.difference(scene_); });
  const auto frame = checkpoint.value<std::int64_t>("frame");
  const auto next = checkpoint.value<double>("next_frame_s");
  const auto refuse = [&](const std::string& found) {
    throw InputError(fmt::format("{}: {}; start the run anew, or give it the end that it had", results_.checkpoint().string(), found));
  };
  if (frame < 0) refuse(fmt::format("is of frame {}, the first is 0", frame));
  if (frame > times_.last()) refuse(fmt::format("is of frame {}, behind the end at frame {}", frame, times_.last()));
  frame_ = static_cast<int>(frame);
  if (next != times_(frame_ + 1))  // the lengths of the steps would not be those of a run that never stopped
    refuse(fmt::format("found a run whose frame {} is due at {:g} s, with this end it is at {:g} s", frame_ + 1, next, times_(frame_ + 1)));
  try {
    results_.expect_whole(times_, frame_);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}; the checkpoint needs what was written before it: start the run anew", error.what()));
  }
  try {
    simulation_ = Simulation::resume(scene_, checkpoint);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}; start the run anew", results_.checkpoint().string(), error.what()));
  }
  if (frame_ == times_.last() && simulation_->time() > times_.end_s())
    refuse(fmt::format("is of {:g} s, behind the end at {:g} s", simulation_->time(), times_.end_s()));
  old_steps_ = simulation_->counters().particle_steps;
  wall_before_ = wall_so_far(results_);
  began_ = steady_seconds();
  results_.remove_frames_behind(frame_);
  ledger_.emplace(LedgerFile::resume(results_.ledger(), ledger_columns(scene_), times_(frame_)));
  const Ledger rows = read_ledger(results_.ledger());
  first_ = rows.rows.front();
  last_ = rows.rows.back();
  saved_ = frame_;
  save_series(frame_);
  save_description("running");
}

void Run::save_checkpoint() const {
  CheckpointWriter out(results_.checkpoint(), scene_fingerprint(scene_), scene_.run.precision);
  simulation_->write(out);
  out.set("frame", static_cast<std::int64_t>(frame_));
  out.set("next_frame_s", times_(frame_ + 1));
  out.commit();
}

void Run::save_series(int frame) const {
  const auto save = [&](const std::string& folder, const std::filesystem::path& series) {
    std::vector<SeriesEntry> entries;
    for (int f = 0; f <= frame; ++f) entries.push_back({folder + frame_name(f), times_(f)});
    write_series(series, entries);
  };
  save("frames/", results_.series());
  if (!scene_.skins.empty()) save("skins/", results_.skin_series());
}

/// Writes what a frame leaves. The job that it returns waits for the disk, and then the frame is there; the ledger comes last, so that its
/// rows are those of whole frames.
std::function<void()> Run::save_frame(int frame, const std::vector<double>& row) {
  if (!results_.is_own())
    throw RunError(fmt::format("{}: was removed or moved while the run went on, frame {} is not written", results_.path().string(), frame));
  const auto saving = [frame](auto part) {
    try {
      return part();
    } catch (const OutputError& error) {
      throw OutputError(fmt::format("frame {}: {}", frame, error.what()));
    }
  };
  const WrittenFrame written = saving([&] { return simulation_->written_frame(frames_, results_.frame(frame), results_.skin(frame)); });
  return [=, this] {
    saving([&] {
      written.put_in_place();
      ledger_->append(row);
      saved_ = frame;
    });
  };
}

void Run::flush_frames() {
  flush_folder(results_.frames());
  if (!scene_.skins.empty()) flush_folder(results_.skins());
  ledger_->flush();
}

/// Writes run.json: what the run is, and its state so far. Its seconds include those before the run was resumed.
void Run::save_description(const char* state) const {
  nlohmann::json summary;
  const auto names = ledger_columns(scene_);
  for (std::size_t i = 0; i < last_.size(); ++i) summary[names[i]] = last_[i];
  summary["state"] = state;
  summary["wall_s"] = wall_before_ + wall_here();
  summary["particle_steps"] = simulation_->counters().particle_steps;
  summary["peak_memory_bytes"] = peak_memory_bytes();
  summary["load_average"] = load_average();
  nlohmann::json made = provenance();
  made["threads"] = threads_that_run();
  made["seed"] = scene_.run.seed;
  const nlohmann::json all{{"scene", resolved(scene_)}, {"provenance", made}, {"summary", summary}};
  write_text_atomically(results_.description(), all.dump(2) + "\n");
}

Standing Run::standing() const {
  return {frame_, times_.last(), simulation_->time(), times_.end_s(), simulation_->dt(), static_cast<std::uint64_t>(steps_here())};
}

/// Steps towards the next frame. Returns whether it was reached.
bool Run::advance() {
  return simulation_->advance(times_(frame_ + 1), times_(frame_ + 2), [&] {
    progress_.update(standing());
    writer_->check();
    return !StopSignals::asked();
  });
}

/// A run is not done if somebody has removed or damaged what it wrote.
void Run::expect_results() const {
  try {
    results_.expect_whole(times_, frame_);
  } catch (const InputError& error) {
    throw RunError(fmt::format("{}; it was changed while the run went on", error.what()));
  }
}

std::string Run::finish(const char* state) const {
  save_description(state);
  return summary_text(scene_, results_, first_, last_, *simulation_, wall_here(), steps_here());
}

void Run::fail() noexcept {
  const auto attempt = [](auto what) {
    try {
      what();
    } catch (...) {  // what made it fail is told already
    }
  };
  attempt([&] {
    spare_.give_up();
    if (writer_) writer_->finish();
  });
  if (!results_.is_own()) return;
  if (saved_ >= 0) attempt([&] { save_series(saved_); });
  attempt([&] { save_description("failed"); });
}

RunSummary Run::go_on() {
  writer_.emplace();
  while (frame_ < times_.last()) {
    const bool reached = advance();
    if (reached) {
      ++frame_;
      last_ = ledger_row(*simulation_);
      // written here, by all threads: a thread of its own would take a core from the steps, whose threads wait for each other
      writer_->put(save_frame(frame_, last_));
      progress_.update(standing());
    }
    const bool at_end = frame_ == times_.last(), stop = StopSignals::asked() && !at_end;
    if (stop || at_end || (reached && frame_ % scene_.run.checkpoint_every_frames == 0)) {
      writer_->finish();  // a checkpoint knows of no frame that is not there
      flush_frames();
      save_series(frame_);
      save_checkpoint();
      save_description("running");  // a killed run must not lose the time that it took
    }
    if (stop)
      return {finish("interrupted") +
                  fmt::format("\n  interrupted at {:.6g} s; checkpoint written, continue with --resume", simulation_->time()),
              true};
  }
  expect_results();
  return {finish("done"), false};
}

/// Whether the run is to go on from a checkpoint. Where there is none it begins, as it must where a job is started again that ended early.
bool is_to_resume(const RunOptions& options) {
  const ResultsFolder results(options.out);
  if (!options.resume || results.has_checkpoint()) return options.resume;
  if (results.is_done())
    throw InputError(
        fmt::format("{}: found a run that is done, and no checkpoint, allowed: to run it anew, without --resume", results.path().string()));
  return false;
}

}  // namespace

RunSummary run_scene(const Scene& scene, const RunOptions& options) {
  const StopSignals signals;
  if (options.threads > 0) omp_set_num_threads(options.threads);
  give_back_large_arrays();
  forget_peak_memory();
  Run run(scene, options);
  is_to_resume(options) ? run.resume() : run.begin();
  try {
    return run.go_on();
  } catch (const OutputError& error) {
    run.fail();
    throw RunError(error.what());
  } catch (...) {
    run.fail();
    throw;
  }
}

namespace {

/// Seconds per particle on this machine, and how the steps' mean length compares with the first one's. A step of fewer than some thousand
/// particles takes as long as one of these, and so does a frame.
struct Costs {
  static constexpr double k_fewest_of_step = 2e3, k_fewest_of_frame = 1e4;
  double step = 0, frame = 0, lengthening = 1;
  double settling_s = 0;  ///< that was seen
};

/// Measures them by a second of steps, 20 at least, and a frame, at the start of a simulation.
Costs try_out(Simulation& simulation, double end) {
  constexpr double k_trial_s = 1;
  constexpr int k_fewest = 20;
  const double first_step = simulation.dt(), began = steady_seconds();
  int steps = 0;
  simulation.advance(end, end, [&] { return ++steps < k_fewest || steady_seconds() - began < k_trial_s; });
  const double taken = steady_seconds() - began;
  const double advanced = simulation.time() + simulation.settling().time;
  const double lengthening = steps > 0 && first_step > 0 ? advanced / steps / first_step : 1;
  const ScratchFolder scratch;
  FrameWriter writer;
  const auto write = [&](int frame) {
    simulation.written_frame(writer, scratch / frame_name(frame), scratch / frame_name(frame + 2)).put_in_place();
  };
  write(0);  // the first frame takes much longer than later ones
  const double again = steady_seconds();
  write(1);
  const double particles = static_cast<double>(simulation.particles());
  return {taken / std::max({static_cast<double>(simulation.counters().particle_steps), steps * Costs::k_fewest_of_step, 1.0}),
          (steady_seconds() - again) / std::max(particles, Costs::k_fewest_of_frame), lengthening, simulation.settling().time};
}

/// Particles that emitters pour in a run.
struct Poured {
  double all = 0, mean = 0;  ///< at the end, and over the run
};

Poured poured_in(const Scene& scene) {
  Poured poured;
  for (std::size_t i = 0; i < scene.emitters.size(); ++i) {
    const EmitterState emitter(scene, scene.emitters[i], i);
    poured.all += emitter.particles_by(scene.run.end_s, false);
    poured.mean += emitter.particles_by(scene.run.end_s, true);
  }
  return poured;
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
    const Poured poured = poured_in(at);
    const double mean = n + poured.mean;
    const double first_step = simulation->dt();
    if (!costs) {
      text += fmt::format("  memory       {}\n", simulation->memory_words());
      costs = try_out(*simulation, scene.run.end_s);
      tried = word_of(quality);
    }
    const double steps = first_step > 0 ? std::ceil((scene.run.end_s + costs->settling_s) / (first_step * costs->lengthening)) : 0;
    const double frames = scene.run.end_s * scene.run.frame_rate_per_s;
    const double seconds =
        steps * costs->step * std::max(mean, Costs::k_fewest_of_step) + frames * costs->frame * std::max(mean, Costs::k_fewest_of_frame);
    const double bytes = static_cast<double>(simulation->bytes()) + poured.all * bytes_per_particle(at), all = n + poured.all;
    text += fmt::format("  {:<12} dx {:.4g} m, {:.0f} particles{}, {}{:.0f} MB ({:.0f} bytes per particle), about {:.0f} steps, {}\n",
                        word_of(quality), at.dx(), n, poured.all > 0 ? fmt::format(" and about {:.0f} poured", poured.all) : "",
                        poured.all > 0 ? "at least " : "", bytes / 1e6, all > 0 ? bytes / all : 0, steps,
                        mean > 0 ? clock_text(seconds) : "no time at all");
  }
  for (const std::string& warning : warnings_about(scene)) text += fmt::format("  warning      {}\n", warning);
  for (const std::string& doubt : doubts_about_skins(scene)) text += fmt::format("  doubt        {}\n", doubt);
  return text + fmt::format("  (steps and time from a trial of about a second and a frame at {} on this machine)", tried);
}

}  // namespace bake
